// SPDX-License-Identifier: Apache-2.0
// Numbers that are likely to be in another unit: they run, and give numbers that look like results.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/plausibility.hpp"

namespace driver {
namespace {

class UnitWarnings {
 public:
  explicit UnitWarnings(Scene& scene) : scene_(scene) {}
  /// Of a value beyond what scenes of airbags have.
  void expect(const std::string& key, double value, const char* unit, double low, double high) {
    if (value < low || value > high)
      scene_.warnings.push_back(fmt::format("{} is {:.4g} {}, usual are {:g} to {:g} {}: check its unit", key,
                                            value, unit, low, high, unit));
  }

 private:
  Scene& scene_;
};

void check_gas(Scene& scene, UnitWarnings& units) {
  constexpr double cold = 150.0, hot = 6000.0, thin = 1e3, dense = 1e8;
  constexpr double long_burn = 1.0, late = 100.0;  // [s], and of the scene
  constexpr double nearly_empty = 50.0;            // [Pa] of a tank; less is likely to be in bar
  if (scene.ambient.pressure > 0.0)
    units.expect("ambient.pressure", scene.ambient.pressure, "Pa", thin, dense);
  if (!scene.gas) return;
  const GasPart& gas = *scene.gas;
  units.expect("ambient.temperature", scene.ambient.temperature, "K", cold, hot);
  if (gas.initial_pressure > 0.0 && gas.initial_pressure != scene.ambient.pressure)
    units.expect("gas.initial.pressure", gas.initial_pressure, "Pa", scene.bag ? thin : nearly_empty, dense);
  for (std::size_t i = 0; i < gas.model.inflows.size(); ++i) {
    const std::string key = fmt::format("inflator.{}.", i);
    units.expect(key + "temperature", gas.model.inflows[i].temperature.minimum(), "K", cold, hot);
    units.expect(key + "mass_flow", gas.model.inflows[i].mass_flow.maximum(), "kg/s", 0.0, 100.0);
    const auto knots = gas.model.inflows[i].mass_flow.knots();
    const auto flows = [](const gas::Curve::Knot& knot) { return knot.value > 0.0; };
    const auto last = std::find_if(knots.rbegin(), knots.rend(), flows);
    if (last != knots.rend() && last->time > std::max(long_burn, late * scene.time.end))
      scene.warnings.push_back(
          fmt::format("{}mass_flow continues until {:.4g} s, but the scene ends at {:.4g} s: check its unit",
                      key, last->time, scene.time.end));
  }
  if (const auto& coefficient = gas.heat_loss_coefficient)
    units.expect("gas.heat_loss.coefficient", *coefficient, "W/(m2 K)", 0.1, 1e5);
  if (gas.rigid_volume) units.expect("tank.volume", *gas.rigid_volume, "m3", 1e-5, 10.0);
  for (std::size_t i = 0; i < gas.model.vents.size(); ++i)
    units.expect(fmt::format("vent.{}.area", i), gas.model.vents[i].area, "m2", 0.0, 1.0);
}

void check_general(const Scene& scene, UnitWarnings& units) {
  constexpr double longest = 10.0;    // [s] a curtain of a car that rolls over stays full for 6 s
  constexpr double steepest = 500.0;  // [m/s2] that of a crash, which acts on what rides along
  if (scene.bag || (scene.gas && !scene.gas->model.inflows.empty()))
    units.expect("scene.end_time", scene.time.end, "s", 0.0, longest);
  units.expect("scene.gravity", scene.gravity.norm(), "m/s2", 0.0, steepest);
}

void check_pendulum(const PendulumPart& pendulum, UnitWarnings& units) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const coupling::PendulumParameters& p = pendulum.model.parameters();
  const auto expect = [&](const char* key, double value, const char* unit, double low, double high) {
    units.expect(pendulum.path + '.' + key, value, unit, low, high);
  };
  expect("mass", p.mass, "kg", 0.05, 5e3);
  expect("inertia_cg", p.inertia_cg, "kg m2", 0.0, 1e4);
  expect("cg_distance", p.cg_distance, "m", 0.0, 20.0);
  expect("impactor_distance", p.impactor_distance, "m", 0.01, 20.0);
  if (pendulum.path == "pendulum") expect("impactor_radius", p.impactor_radius, "m", 1e-3, 2.0);
  expect("initial_angle", pendulum.initial.angle, "rad", -turn, turn);
}

void check_body(const Scene& scene, UnitWarnings& units) {
  const coupling::RigidBodyParameters& p = scene.body->model.parameters();
  units.expect("impactor.motion.mass", p.mass, "kg", 0.05, 5e3);
  units.expect("impactor.motion.velocity", p.velocity.norm(), "m/s", 0.0, 100.0);
  units.expect("impactor.motion.angular_velocity", p.angular_velocity.norm(), "rad/s", 0.0, 1e3);
  if (scene.body->model.is_free())
    units.expect("impactor.motion.inertia", p.inertia.trace(), "kg m2", 1e-8, 1e4);
  units.expect("impactor.shape", coupling::reach_of(scene.impactor), "m", 1e-3, 2.0);
}

void check_bag(Scene& scene, UnitWarnings& units) {
  for (const membrane::ElementProperties& fabric : scene.bag->model.description.properties) {
    if (fabric.null_panel) continue;
    const std::size_t before = scene.warnings.size();
    units.expect("fabric.thickness", fabric.thickness, "m", 1e-6, 0.01);
    units.expect("fabric.density", fabric.density, "kg/m3", 10.0, 2e4);
    if (std::isfinite(fabric.young_modulus))
      units.expect("fabric.young_modulus", fabric.young_modulus, "Pa", 1e4, 1e12);
    if (scene.warnings.size() > before) break;  // once, not of each element
  }
  const membrane::BagDescription& bag = scene.bag->model.description;
  units.expect("membrane.mass_damping", bag.mass_damping, "1/s", 0.0, 1e4);
  units.expect("membrane.stiffness_damping", bag.stiffness_damping, "s", 0.0, 0.1);
  for (std::size_t i = 0; i < bag.straps.size(); ++i) {
    const std::string key = fmt::format("membrane.strap.{}.", i);
    units.expect(key + "free_length", bag.straps[i].free_length, "m", 0.01, 5.0);
    units.expect(key + "stiffness", bag.straps[i].stiffness, "N/m", 50.0, 1e8);
  }
}

}  // namespace

void warn_of_units(Scene& scene) {
  UnitWarnings units(scene);
  check_general(scene, units);
  check_gas(scene, units);
  if (scene.bag) check_bag(scene, units);
  if (scene.pendulum) check_pendulum(*scene.pendulum, units);
  if (scene.body) check_body(scene, units);
}

}  // namespace driver
