// SPDX-License-Identifier: Apache-2.0
#include "closed_form/tank_test.hpp"

#include <cmath>

#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

PulseFill as_fill(const PerfectGas& gas, const TankTestPulse& p) {
  return {gas,          p.volume,   p.initial_pressure,  p.initial_temperature,
          p.total_mass, p.duration, p.start_temperature, p.end_temperature};
}

// sum over species of Y R (polynomial of cp/R).
double nasa7_cp(const Nasa7Gas& gas, double t) {
  double sum = 0.0;
  for (const auto& s : gas) {
    const auto& a = t <= 1000.0 ? s.low : s.high;
    sum += s.mass_fraction * s.gas_constant *
           (a[0] + a[1] * t + a[2] * t * t + a[3] * t * t * t + a[4] * t * t * t * t);
  }
  return sum;
}

double nasa7_gas_constant(const Nasa7Gas& gas) {
  double sum = 0.0;
  for (const auto& s : gas) sum += s.mass_fraction * s.gas_constant;
  return sum;
}

double nasa7_energy(const Nasa7Gas& gas, double t) {
  return nasa7_enthalpy(gas, t) - nasa7_gas_constant(gas) * t;
}

}  // namespace

double average_inflow_temperature(const AverageTemperature& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume);
  check::non_negative("initial_pressure", tank.initial_pressure);
  check::positive("final_pressure", tank.final_pressure, "total_mass", tank.total_mass);
  if (tank.final_pressure <= tank.initial_pressure)
    check::refuse("final_pressure", tank.final_pressure, "must be > initial_pressure");
  const auto [R, gamma] = tank.gas;
  return (tank.final_pressure - tank.initial_pressure) * tank.volume / (gamma * R * tank.total_mass);
}

double average_temperature_mass_flow(const AverageTemperature& tank, double pressure_rate) {
  check::non_negative("pressure_rate", pressure_rate);
  const auto [R, gamma] = tank.gas;
  return tank.volume * pressure_rate / (gamma * R * average_inflow_temperature(tank));
}

DualPressureResult dual_pressure(const DualPressure& test) {
  check::gas(test.gas);
  check::positive("volume", test.volume, "outlet_area", test.outlet_area, "chamber_pressure",
                  test.chamber_pressure, "pressure_rate", test.pressure_rate);
  const auto [R, gamma] = test.gas;
  const double enthalpy_flow = test.volume * test.pressure_rate / (gamma * R);  // mdot T
  const double choked = test.outlet_area * choked_flux_coefficient(gamma) * test.chamber_pressure;
  const double ratio = enthalpy_flow / choked;
  return {choked / (R * ratio), R * ratio * ratio};
}

double chamber_pressure(const PerfectGas& gas, double outlet_area, double mass_flow, double temperature,
                        double tank_pressure) {
  check::gas(gas);
  check::positive("outlet_area", outlet_area);
  check::non_negative("mass_flow", mass_flow);
  check::positive("temperature", temperature, "tank_pressure", tank_pressure);
  const auto [R, gamma] = gas;
  const double flux = mass_flow / (outlet_area * tank_pressure);
  const double q = (gamma - 1.0) / (2.0 * gamma) * R * temperature * flux * flux;
  const double rise = 2.0 * q / (1.0 + std::sqrt(1.0 + 4.0 * q));  // y - 1
  if (rise > 0.5 * (gamma - 1.0))
    return mass_flow * std::sqrt(R * temperature) / (outlet_area * choked_flux_coefficient(gamma));
  return tank_pressure * std::exp(gamma / (gamma - 1.0) * std::log1p(rise));
}

TankTestReadings tank_test_pulse(const PerfectGas& tank_gas, const PerfectGas& inflow_gas,
                                 const TankTestPulse& pulse, double time) {
  check::gas(tank_gas);
  const PulseFill fill = as_fill(inflow_gas, pulse);
  const GasState alone = pulse_fill(fill, time);  // the tank full of the inflow's gas: its integrals
  const auto [R, gamma] = inflow_gas;
  const double p0 = pulse.initial_pressure, T0 = pulse.initial_temperature, V = pulse.volume;
  const double mass_in = alone.mass - p0 * V / (R * T0);
  const double mass_temperature = (alone.pressure - p0) * V / (gamma * R);  // int mdot T_s dt
  const double own = p0 * V / (tank_gas.gas_constant * T0);
  const double temperature =
      (own * specific_heat_cv(tank_gas) * T0 + specific_heat_cp(inflow_gas) * mass_temperature) /
      (own * specific_heat_cv(tank_gas) + mass_in * specific_heat_cv(inflow_gas));
  const PulseFlow flow = pulse_flow(fill, time);
  const double pressure = (own * tank_gas.gas_constant + mass_in * R) * temperature / V;
  return {pressure,
          chamber_pressure(inflow_gas, pulse.outlet_area, flow.mass_flow, flow.temperature, pressure),
          flow.mass_flow, flow.temperature};
}

double nasa7_enthalpy(const Nasa7Gas& gas, double t) {
  double sum = 0.0;
  for (const auto& s : gas) {
    const auto& a = t <= 1000.0 ? s.low : s.high;
    sum += s.mass_fraction * s.gas_constant *
           (a[5] + a[0] * t + a[1] * t * t / 2.0 + a[2] * std::pow(t, 3) / 3.0 + a[3] * std::pow(t, 4) / 4.0 +
            a[4] * std::pow(t, 5) / 5.0);
  }
  return sum;
}

TankTestReadings nasa7_tank_test_pulse(const Nasa7Gas& tank_gas, const Nasa7Gas& inflow_gas,
                                       const TankTestPulse& pulse, double time) {
  const double R = nasa7_gas_constant(inflow_gas), own_R = nasa7_gas_constant(tank_gas);
  const double cp = nasa7_cp(inflow_gas, pulse.start_temperature);
  const PulseFill fill = as_fill({R, cp / (cp - R)}, pulse);
  const double mass_in =
      pulse_fill(fill, time).mass - pulse.initial_pressure * pulse.volume / (R * pulse.initial_temperature);
  const double own = pulse.initial_pressure * pulse.volume / (own_R * pulse.initial_temperature);
  const auto enthalpy_flow = [&](double t) {
    const PulseFlow flow = pulse_flow(fill, t);
    return flow.mass_flow * nasa7_enthalpy(inflow_gas, flow.temperature);
  };
  const double end = std::fmin(time, pulse.duration);
  const double energy = own * nasa7_energy(tank_gas, pulse.initial_temperature) +
                        quadrature::integrate(enthalpy_flow, 0.0, end, 8);
  double low = 200.0, high = 6000.0;
  while (high - low > 1e-13 * high) {
    const double t = 0.5 * (low + high);
    const double u = own * nasa7_energy(tank_gas, t) + mass_in * nasa7_energy(inflow_gas, t);
    (u < energy ? low : high) = t;
  }
  const double pressure = (own * own_R + mass_in * R) * low / pulse.volume;
  const PulseFlow flow = pulse_flow(fill, time);
  const double outlet_cp = nasa7_cp(inflow_gas, flow.temperature);
  return {pressure,
          chamber_pressure({R, outlet_cp / (outlet_cp - R)}, pulse.outlet_area, flow.mass_flow,
                           flow.temperature, pressure),
          flow.mass_flow, flow.temperature};
}

}  // namespace closed_form
