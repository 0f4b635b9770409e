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
  check::gas(scene.gas);
  check::positive("ambient_pressure", scene.ambient_pressure, "inflow_temperature", scene.inflow_temperature);
  const double overpressure = stretched_sphere_pressure(scene.sphere, stretch);
  const SphereStretch shape = stretched_sphere(scene.sphere, overpressure);
  const double gamma = scene.gas.heat_capacity_ratio;
  const double radius = scene.sphere.radius;
  const double initial_volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  SphereFillState state;
  state.pressure = scene.ambient_pressure + overpressure;
  state.volume = initial_volume * stretch * stretch * stretch;
  state.strain_energy = shape.strain_energy;
  state.ambient_work = scene.ambient_pressure * (state.volume - initial_volume);
  const double gas_energy =
      (state.pressure * state.volume - scene.ambient_pressure * initial_volume) / (gamma - 1.0);
  state.inflow_mass = (gas_energy + state.strain_energy + state.ambient_work) /
                      (specific_heat_cp(scene.gas) * scene.inflow_temperature);
  return state;
}

double sphere_fill_stretch(const SphereFill& scene, double inflow_mass) {
  check::non_negative("inflow_mass", inflow_mass);
  double low = 1.0;
  double high = 2.0;
  while (sphere_fill(scene, high).inflow_mass < inflow_mass) {
    if (high > 1e3) check::refuse("inflow_mass", inflow_mass, "must leave the stretch below 1000");
    high *= 2.0;
  }
  // The mass grows with the stretch: bisection to the last bit.
  for (double mid = 0.5 * (low + high); mid > low && mid < high; mid = 0.5 * (low + high))
    (sphere_fill(scene, mid).inflow_mass < inflow_mass ? low : high) = mid;
  return high;
}

}  // namespace closed_form
