// SPDX-License-Identifier: Apache-2.0
#include "closed_form/gas.hpp"

#include <cmath>
#include <numbers>

#include "cancellation.hpp"
#include "check.hpp"
#include "closed_form/orifice.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

// State of mass [kg] at pressure [Pa] in volume [m3].
GasState state_of(const PerfectGas& gas, double mass, double pressure, double volume) {
  return {mass, pressure * volume / (mass * gas.gas_constant), pressure, volume};
}

void check_tank(const PerfectGas& gas, double volume, double temperature) {
  check::gas(gas);
  check::positive("volume", volume, "initial_temperature", temperature);
}

void check_pulse(const PulseFill& pulse) {
  check_tank(pulse.gas, pulse.volume, pulse.initial_temperature);
  check::positive("initial_pressure", pulse.initial_pressure, "total_mass", pulse.total_mass, "duration",
                  pulse.duration, "start_temperature", pulse.start_temperature, "end_temperature",
                  pulse.end_temperature);
}

}  // namespace

GasState tank_fill(const TankFill& tank, double time) {
  check_tank(tank.gas, tank.volume, tank.initial_temperature);
  check::non_negative("initial_pressure", tank.initial_pressure, "mass_flow", tank.mass_flow);
  check::positive("inflow_temperature", tank.inflow_temperature);
  check::non_negative("time", time);
  const auto [R, gamma] = tank.gas;
  const double mass0 = tank.initial_pressure * tank.volume / (R * tank.initial_temperature);
  const double inflow = tank.mass_flow * time;
  const double pressure = tank.initial_pressure + gamma * R * tank.inflow_temperature * inflow / tank.volume;
  if (mass0 + inflow == 0.0) return {0.0, gamma * tank.inflow_temperature, 0.0, tank.volume};
  return state_of(tank.gas, mass0 + inflow, pressure, tank.volume);
}

GasState pulse_fill(const PulseFill& pulse, double time) {
  check_pulse(pulse);
  check::non_negative("time", time);
  const auto [R, gamma] = pulse.gas;
  const double x = std::fmin(time / pulse.duration, 1.0);
  // int 2 sin^2(pi s) ds = x - sin(2 pi x)/(2 pi) and int 2 s sin^2(pi s) ds by what sin(y)/y lacks of 1.
  const double half = sinc_defect(pi * x), whole = sinc_defect(2.0 * pi * x);
  const double mass_in = pulse.total_mass * x * whole;
  const double ramp = pulse.total_mass * x * x * (whole - half + 0.5 * half * half);
  const double mass_temperature =
      pulse.start_temperature * mass_in + (pulse.end_temperature - pulse.start_temperature) * ramp;
  const double mass0 = pulse.initial_pressure * pulse.volume / (R * pulse.initial_temperature);
  const double pressure = pulse.initial_pressure + gamma * R * mass_temperature / pulse.volume;
  return state_of(pulse.gas, mass0 + mass_in, pressure, pulse.volume);
}

PulseFlow pulse_flow(const PulseFill& pulse, double time) {
  check_pulse(pulse);
  check::finite("time", time);
  const double x = time / pulse.duration;
  if (x <= 0.0 || x >= 1.0) return {0.0, x <= 0.0 ? pulse.start_temperature : pulse.end_temperature, 0.0};
  const double half = std::sin(pi * x);
  PulseFlow flow;
  flow.mass_flow = 2.0 * pulse.total_mass / pulse.duration * half * half;
  flow.temperature = pulse.start_temperature + (pulse.end_temperature - pulse.start_temperature) * x;
  flow.pressure_rate = pulse.gas.heat_capacity_ratio * pulse.gas.gas_constant * flow.mass_flow *
                       flow.temperature / pulse.volume;
  return flow;
}

TwoGasState two_gas_fill(const TwoGasFill& tank) {
  check_tank(tank.tank_gas, tank.volume, tank.initial_temperature);
  check::gas(tank.inflow_gas);
  check::positive("initial_pressure", tank.initial_pressure);
  check::non_negative("inflow_mass", tank.inflow_mass);
  check::positive("inflow_temperature", tank.inflow_temperature);
  const double mass_a =
      tank.initial_pressure * tank.volume / (tank.tank_gas.gas_constant * tank.initial_temperature);
  const double mass_b = tank.inflow_mass;
  const double mass = mass_a + mass_b;
  const double heat_a = mass_a * specific_heat_cv(tank.tank_gas);
  const double cv = heat_a + mass_b * specific_heat_cv(tank.inflow_gas);
  const double cp = mass_a * specific_heat_cp(tank.tank_gas) + mass_b * specific_heat_cp(tank.inflow_gas);
  const double energy = heat_a * tank.initial_temperature +
                        mass_b * specific_heat_cp(tank.inflow_gas) * tank.inflow_temperature;
  const double temperature = energy / cv;
  const double mR = mass_a * tank.tank_gas.gas_constant + mass_b * tank.inflow_gas.gas_constant;
  return {{mass, temperature, mR * temperature / tank.volume, tank.volume}, cp / cv, mR / mass};
}

VentedFillSteady vented_fill_steady(const VentedFill& tank) {
  check_tank(tank.gas, tank.volume, 1.0);
  check::positive("mass_flow", tank.mass_flow, "inflow_temperature", tank.inflow_temperature, "vent_area",
                  tank.vent_area);
  check::above_upto("discharge_coefficient", tank.discharge_coefficient, 0.0, 1.0);
  check::non_negative("ambient_pressure", tank.ambient_pressure);
  const auto [R, gamma] = tank.gas;
  const double phi = choked_flux_coefficient(gamma);
  const double pressure = tank.mass_flow * std::sqrt(R * tank.inflow_temperature) /
                          (tank.discharge_coefficient * tank.vent_area * phi);
  if (tank.ambient_pressure > critical_pressure_ratio(gamma) * pressure)
    check::refuse("ambient_pressure", tank.ambient_pressure, "the steady vent must be choked against it");
  const double mass = pressure * tank.volume / (R * tank.inflow_temperature);
  const double half_trace = 0.5 * (1.0 + 3.0 * gamma);
  const double root = 0.5 * std::sqrt((9.0 * gamma - 1.0) * (gamma - 1.0));  // half_trace^2 - 4 gamma
  const double rate = tank.mass_flow / mass;
  const double fast = -0.5 * (half_trace + root);
  return {{mass, tank.inflow_temperature, pressure, tank.volume}, rate * gamma / fast, rate * fast};
}

PistonState adiabatic_piston(const AdiabaticPiston& piston, double volume) {
  check_tank(piston.gas, piston.initial_volume, piston.initial_temperature);
  check::positive("initial_pressure", piston.initial_pressure, "volume", volume);
  const auto [R, gamma] = piston.gas;
  const double shrunk = log_ratio(piston.initial_volume, volume);
  const double energy0 = piston.initial_pressure * piston.initial_volume / (gamma - 1.0);
  const double mass = piston.initial_pressure * piston.initial_volume / (R * piston.initial_temperature);
  const double temperature = piston.initial_temperature * std::exp((gamma - 1.0) * shrunk);
  const double pressure = piston.initial_pressure * std::exp(gamma * shrunk);
  return {{mass, temperature, pressure, volume}, energy0 * std::expm1((gamma - 1.0) * shrunk)};
}

GasState constant_pressure_fill(const ConstantPressureFill& bag, double time) {
  check_tank(bag.gas, bag.initial_volume, bag.initial_temperature);
  check::positive("pressure", bag.pressure);
  check::non_negative("mass_flow", bag.mass_flow);
  check::positive("inflow_temperature", bag.inflow_temperature);
  check::non_negative("time", time);
  const double R = bag.gas.gas_constant;
  const double mass0 = bag.pressure * bag.initial_volume / (R * bag.initial_temperature);
  const double inflow = bag.mass_flow * time;
  const double volume = bag.initial_volume + inflow * R * bag.inflow_temperature / bag.pressure;
  return state_of(bag.gas, mass0 + inflow, bag.pressure, volume);
}

GasState spring_bag_fill(const SpringBag& bag, double mass, double temperature) {
  check::gas(bag.gas);
  check::positive("initial_pressure", bag.initial_pressure, "initial_temperature", bag.initial_temperature,
                  "initial_volume", bag.initial_volume);
  check::non_negative("compliance", bag.compliance, "inflow_mass", mass);
  check::positive("inflow_temperature", temperature);
  const auto [R, gamma] = bag.gas;
  const double p0 = bag.initial_pressure, v0 = bag.initial_volume, k = bag.compliance;
  const double supplied = mass * gamma * R / (gamma - 1.0) * temperature;
  // a d^2 + b d = supplied, with d = p - p0; the root that does not cancel.
  const double a = k * (1.0 / (gamma - 1.0) + 0.5), b = (v0 + k * p0) / (gamma - 1.0) + k * p0;
  const double d = 2.0 * supplied / (b + std::sqrt(b * b + 4.0 * a * supplied));
  const double p = p0 + d, v = v0 + k * d, m = p0 * v0 / (R * bag.initial_temperature) + mass;
  return {m, p * v / (m * R), p, v};
}

}  // namespace closed_form
