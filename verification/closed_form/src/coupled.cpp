// SPDX-License-Identifier: Apache-2.0
#include "closed_form/coupled.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"

namespace closed_form {
namespace {

// gamma p S^2/V [N/m]; gamma = 1 is isothermal.
double gas_stiffness(double gamma, double pressure, double area, double volume) {
  check::positive("pressure", pressure, "area", area, "volume", volume);
  return gamma * pressure * area * area / volume;
}

// (K.60) with the contact in series where a body drives the piston.
double piston_frequency(const GasPiston& piston, double gamma) {
  check::positive("mass", piston.mass);
  check::non_negative("stiffness", piston.stiffness);
  const double gas = gas_stiffness(gamma, piston.pressure, piston.area, piston.volume);
  return std::sqrt((piston.stiffness + gas) / piston.mass);
}

void check_fill(const SphereFill& scene) {
  check::gas(scene.gas);
  check::sheet(scene.sphere.sheet, false);
  check::positive("radius", scene.sphere.radius, "ambient_pressure", scene.ambient_pressure,
                  "inflow_temperature", scene.inflow_temperature);
}

// The state at the stretch 1 + excess.
SphereFillState fill_at(const SphereFill& scene, double excess) {
  const auto& [sheet, radius] = scene.sphere;
  const double membrane = sheet.young_modulus / (1.0 - sheet.poisson_ratio) * sheet.thickness;  // [N/m]
  const double strain = excess * (1.0 + 0.5 * excess);
  const double overpressure = 2.0 * membrane / radius * strain / (1.0 + excess);
  const double initial_volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const double gained = initial_volume * excess * (3.0 + excess * (3.0 + excess));  // V - V0
  SphereFillState state;
  state.stretch = 1.0 + excess;
  state.pressure = scene.ambient_pressure + overpressure;
  state.volume = initial_volume + gained;
  state.strain_energy = 4.0 * std::numbers::pi * radius * radius * membrane * strain * strain;
  state.ambient_work = scene.ambient_pressure * gained;
  const double gas_energy =
      (overpressure * state.volume + scene.ambient_pressure * gained) / (scene.gas.heat_capacity_ratio - 1.0);
  state.inflow_mass = (gas_energy + state.strain_energy + state.ambient_work) /
                      (specific_heat_cp(scene.gas) * scene.inflow_temperature);
  return state;
}

}  // namespace

double gas_piston_frequency(const GasPiston& piston) {
  return piston_frequency(piston, check::gas(piston.gas).heat_capacity_ratio);
}

double gas_piston_isothermal_frequency(const GasPiston& piston) {
  return piston_frequency(piston, 1.0);
}

double pendulum_gas_spring_frequency(const PendulumGasSpring& scene) {
  const PendulumConstants constants = pendulum_constants(scene.pendulum);
  const double gas =
      gas_stiffness(check::gas(scene.gas).heat_capacity_ratio, scene.pressure, scene.area, scene.volume);
  const double own = constants.angular_frequency;
  return std::sqrt(gas / constants.effective_mass + own * own);
}

SphereFillState sphere_fill(const SphereFill& scene, double stretch) {
  check_fill(scene);
  if (!(std::isfinite(stretch) && stretch >= 1.0))
    check::refuse("stretch", stretch, "must be finite and >= 1");
  return fill_at(scene, stretch - 1.0);
}

SphereFillState sphere_fill_by_mass(const SphereFill& scene, double inflow_mass) {
  check_fill(scene);
  check::non_negative("inflow_mass", inflow_mass);
  double low = 0.0, high = 1.0;
  while (fill_at(scene, high).inflow_mass < inflow_mass) {
    if (high > 1e3) check::refuse("inflow_mass", inflow_mass, "must leave the stretch below 1000");
    high *= 2.0;
  }
  // The mass grows with the stretch: bisection to the last bit.
  for (double mid = 0.5 * (low + high); mid > low && mid < high; mid = 0.5 * (low + high))
    (fill_at(scene, mid).inflow_mass < inflow_mass ? low : high) = mid;
  return fill_at(scene, inflow_mass > 0.0 ? high : 0.0);
}

}  // namespace closed_form
