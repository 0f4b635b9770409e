// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "cancellation.hpp"
#include "check.hpp"
#include "closed_form/orifice.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

// The subsonic branch of both blow-downs: v = sqrt((p/p_a)^((gamma-1)/gamma) - 1), time left = scale I_b(v).
struct Branch {
  double exponent = 0.0;  // b
  double scale = 0.0;     // [s]
  double start = 0.0;     // v where the branch begins
};

void check_tank(const Blowdown& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume, "area", tank.area);
  check::above_upto("discharge_coefficient", tank.discharge_coefficient, 0.0, 1.0);
  check::positive("initial_pressure", tank.initial_pressure, "initial_temperature", tank.initial_temperature,
                  "ambient_pressure", tank.ambient_pressure);
  if (tank.initial_pressure <= tank.ambient_pressure)
    check::refuse("initial_pressure", tank.initial_pressure, "must be > ambient_pressure");
}

// v of a pressure >= p_a.
double branch_variable(const Blowdown& tank, double pressure) {
  const double gamma = tank.gas.heat_capacity_ratio;
  return std::sqrt(std::expm1((gamma - 1.0) / gamma * log_ratio(pressure, tank.ambient_pressure)));
}

double branch_pressure(const Blowdown& tank, double v) {
  const double gamma = tank.gas.heat_capacity_ratio;
  return tank.ambient_pressure * std::exp(gamma / (gamma - 1.0) * std::log1p(v * v));
}

double final_temperature(const Blowdown& tank) {
  const double gamma = tank.gas.heat_capacity_ratio;
  return tank.initial_temperature *
         std::pow(tank.ambient_pressure / tank.initial_pressure, (gamma - 1.0) / gamma);
}

// Where the subsonic branch begins: the unchoking pressure, or p0 when the tank starts below it.
double subsonic_start(const Blowdown& tank) {
  return std::min(tank.initial_pressure,
                  tank.ambient_pressure / critical_pressure_ratio(tank.gas.heat_capacity_ratio));
}

double time_constant(const Blowdown& tank) {
  return tank.volume / (tank.discharge_coefficient * tank.area *
                        std::sqrt(tank.gas.gas_constant * tank.initial_temperature) *
                        choked_flux_coefficient(tank.gas.heat_capacity_ratio));
}

Branch adiabatic_branch(const Blowdown& tank) {
  const auto [R, gamma] = tank.gas;
  const double temperature = final_temperature(tank);
  const double area = tank.discharge_coefficient * tank.area;
  // 2 m_f/((gamma-1) K) with m_f = p_a V/(R T_f), K = A p_a/sqrt(R T_f) sqrt(2 gamma/(gamma-1)).
  const double scale = 2.0 * tank.volume / ((gamma - 1.0) * area * std::sqrt(R * temperature)) /
                       std::sqrt(2.0 * gamma / (gamma - 1.0));
  return {(2.0 - gamma) / (gamma - 1.0), scale, branch_variable(tank, subsonic_start(tank))};
}

Branch isothermal_branch(const Blowdown& tank) {
  const auto [R, gamma] = tank.gas;
  const double area = tank.discharge_coefficient * tank.area;
  const double scale = 2.0 * tank.volume / (area * std::sqrt(R * tank.initial_temperature)) *
                       std::sqrt(gamma / (2.0 * (gamma - 1.0)));
  return {1.0 / (gamma - 1.0) - 0.5, scale, branch_variable(tank, subsonic_start(tank))};
}

double time_left(const Branch& branch, double v) {
  return branch.scale * quadrature::power_integral(branch.exponent, v);
}

// Pressure on the branch `elapsed` [s] after its start.
double pressure_after(const Blowdown& tank, const Branch& branch, double elapsed) {
  const double left = time_left(branch, branch.start) - elapsed;
  const double v = quadrature::power_integral_inverse(branch.exponent, left / branch.scale, branch.start);
  return branch_pressure(tank, v);
}

GasState state_at(const Blowdown& tank, double pressure, double temperature) {
  return {pressure * tank.volume / (tank.gas.gas_constant * temperature), temperature, pressure, tank.volume};
}

// Time of the choked phase down to `pressure`, adiabatic.
double choked_time(const Blowdown& tank, double pressure) {
  const double gamma = tank.gas.heat_capacity_ratio;
  const double fallen = log_ratio(tank.initial_pressure, pressure);
  return 2.0 * time_constant(tank) / (gamma - 1.0) * std::expm1(0.5 * (gamma - 1.0) / gamma * fallen);
}

BlowdownTimes times_of(const Blowdown& tank, const Branch& branch, double unchoke_time, double temperature) {
  BlowdownTimes times;
  times.time_constant = time_constant(tank);
  times.unchoke_time = unchoke_time;
  times.unchoke_pressure = subsonic_start(tank);
  times.end_time = unchoke_time + time_left(branch, branch.start);
  times.final_temperature = temperature;
  times.final_mass = state_at(tank, tank.ambient_pressure, temperature).mass;
  return times;
}

}  // namespace

BlowdownTimes blowdown_times(const Blowdown& tank) {
  check_tank(tank);
  return times_of(tank, adiabatic_branch(tank), choked_time(tank, subsonic_start(tank)),
                  final_temperature(tank));
}

GasState blowdown(const Blowdown& tank, double time) {
  check_tank(tank);
  check::non_negative("time", time);
  const double gamma = tank.gas.heat_capacity_ratio;
  const double unchoke = choked_time(tank, subsonic_start(tank));
  if (time <= unchoke) {
    const double log_f = std::log1p(0.5 * (gamma - 1.0) * time / time_constant(tank));
    return state_at(tank, tank.initial_pressure * std::exp(-2.0 * gamma / (gamma - 1.0) * log_f),
                    tank.initial_temperature * std::exp(-2.0 * log_f));
  }
  const double pressure = pressure_after(tank, adiabatic_branch(tank), time - unchoke);
  const double temperature =
      final_temperature(tank) * std::pow(pressure / tank.ambient_pressure, (gamma - 1.0) / gamma);
  return state_at(tank, pressure, temperature);
}

double blowdown_time_of_pressure(const Blowdown& tank, double pressure) {
  check_tank(tank);
  check::within("pressure", pressure, tank.ambient_pressure, tank.initial_pressure);
  if (pressure >= subsonic_start(tank)) return choked_time(tank, pressure);
  const Branch branch = adiabatic_branch(tank);
  const double v = branch_variable(tank, pressure);
  return choked_time(tank, subsonic_start(tank)) + time_left(branch, branch.start) - time_left(branch, v);
}

BlowdownTimes isothermal_blowdown_times(const Blowdown& tank) {
  check_tank(tank);
  const double unchoke = time_constant(tank) * log_ratio(tank.initial_pressure, subsonic_start(tank));
  return times_of(tank, isothermal_branch(tank), unchoke, tank.initial_temperature);
}

GasState isothermal_blowdown(const Blowdown& tank, double time) {
  check_tank(tank);
  check::non_negative("time", time);
  const double tau = time_constant(tank);
  const double unchoke = tau * log_ratio(tank.initial_pressure, subsonic_start(tank));
  const double pressure = time <= unchoke ? tank.initial_pressure * std::exp(-time / tau)
                                          : pressure_after(tank, isothermal_branch(tank), time - unchoke);
  return state_at(tank, pressure, tank.initial_temperature);
}

GasState proportional_blowdown(const Blowdown& bag, double time) {
  check::gas(bag.gas);
  check::positive("volume", bag.volume, "area", bag.area);
  check::above_upto("discharge_coefficient", bag.discharge_coefficient, 0.0, 1.0);
  check::positive("initial_pressure", bag.initial_pressure, "initial_temperature", bag.initial_temperature);
  check::non_negative("ambient_pressure", bag.ambient_pressure, "time", time);
  const auto [R, gamma] = bag.gas;
  const double rate = bag.discharge_coefficient * bag.area * choked_flux_coefficient(gamma) *
                      std::sqrt(R * bag.initial_temperature) / bag.volume;
  const double a = (gamma - 1.0) / gamma, left = 1.0 - 0.5 * rate * time;
  const double x = left > 0.0 ? std::pow(left, 2.0 / (2.0 - a)) : 0.0;
  if (!(critical_pressure_ratio(gamma) * x * bag.initial_pressure >= bag.ambient_pressure && x > 0.0))
    check::refuse("time", time, "the vent must be choked up to then");
  const double p = bag.initial_pressure * x, v = bag.volume * x,
               temperature = bag.initial_temperature * std::pow(x, a);
  return {p * v / (R * temperature), temperature, p, v};
}

}  // namespace closed_form
