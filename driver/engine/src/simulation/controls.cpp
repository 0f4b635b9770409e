// SPDX-License-Identifier: Apache-2.0
#include "engine/controls.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/impactor.hpp"
#include "engine/stages.hpp"
#include "simulation/control_checks.hpp"

namespace driver {
namespace {

using Eigen::Vector3d;

const GasPart& gas_of(const Simulation& simulation, const char* name) {
  if (!simulation.scene().has_volume())
    control::refuse(fmt::format("{}: the scene has no volume of gas, allowed: a case with one", name));
  return *simulation.scene().gas;
}

// The integrator has a model of its own; making it tests the new one.
Moment::Change new_model(const GasPart& gas, gas::ControlVolumeModel model) {
  return [integrator = gas::GasIntegrator(model, gas.integrator), model = std::move(model)](Scene& scene,
                                                                                            State& state) {
    scene.gas->model = model;
    state.gas_integrator = integrator;
  };
}

// The work on the ambient gas so far; in the last step half of the new pressure counts.
void settle_ambient_work(const Scene& scene, State& state, double pressure) {
  if (!scene.bag) return;
  const double now = state.bag->surface.volume, last = state.steps > 0 ? state.level.volume : now;
  state.start.ambient_work += scene.ambient.pressure * (now - state.start.volume) +
                              0.5 * (pressure - scene.ambient.pressure) * (now - last);
  state.start.volume = now;
}

void require_rotation(const Eigen::Matrix3d& axes) {
  control::require_finite(axes, "axes");
  const double error = (axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < 1e-9))
    control::refuse(fmt::format("axes: are not a rotation, off by {:.3g}, allowed: 1e-9", error));
  if (!(axes.determinant() > 0.0)) control::refuse("axes: are a mirror image, allowed: a rotation");
}

void require_no_turn(const Scene& scene, const Vector3d& angular_velocity) {
  if (!scene.body->model.is_free() && !angular_velocity.isZero(0.0))
    control::refuse("angular_velocity: is not zero, allowed: zero, as a body on a rail does not turn");
}

// As the caller takes the impactor over, its energy at the last level leaves the balance.
void take_over(State& state) {
  BodyRun& run = *state.body;
  if (std::exchange(run.driven, true)) return;
  run.last_pose = {run.motion.centre, run.motion.axes};
  run.last_velocity = run.motion.velocity;
  if (state.steps == 0) return;
  run.last_pose = state.level.impactor;
  run.last_contact = run.contact;
  state.flows.driving_work -= run.kinetic + run.gravity_energy + run.spring_energy;
  state.flows.kick_work -= run.kick.kinetic_after;
}

void set_speed(const Scene& scene, State& state, const Vector3d& velocity, const Vector3d& angular_velocity) {
  coupling::RigidBodyState& motion = state.body->motion;
  const Eigen::Matrix3d inertia =
      motion.axes * scene.body->model.parameters().inertia * motion.axes.transpose();
  motion.velocity = velocity;
  motion.angular_momentum = inertia * angular_velocity;
}

}  // namespace

void set_vent_area(Simulation& simulation, std::size_t vent, double area) {
  const GasPart& gas = gas_of(simulation, "vent");
  control::require_number(vent, gas.model.vents.size(), "vent");
  control::require(area >= 0.0 && std::isfinite(area), "area", area, "0 or more");
  const gas::Vent& now = gas.model.vents[vent];
  if (now.area == area && !now.area_of_time && !now.area_of_overpressure) return;
  const Control control{Control::vent, vent, {area}};
  gas::ControlVolumeModel model = gas.model;
  model.vents[vent].area = area;
  model.vents[vent].area_of_time.reset();
  model.vents[vent].area_of_overpressure.reset();
  simulation.change_now(new_model(gas, std::move(model)));
  simulation.note(control);
}

void set_sensor(Simulation& simulation, const std::string& name, bool on) {
  const GasPart& gas = gas_of(simulation, "sensor");
  const auto found = std::ranges::find(gas.sensor_names, name);
  const auto number = static_cast<std::size_t>(found - gas.sensor_names.begin());
  if (found == gas.sensor_names.end())
    control::refuse(fmt::format("name: is '{}', but the scene has no such sensor", name));
  if (gas.model.triggers.sensors[number].kind != gas::SensorKind::input ||
      std::ranges::find(gas.contact_sensors, number) != gas.contact_sensors.end())
    control::refuse(
        fmt::format("name: is '{}', which follows the scene, allowed: one with external = true", name));
  simulation.change_now([number, on](Scene& scene, State& state) {
    gas::set_input(scene.gas->model.triggers, number, on, state.gas.triggers);
  });
}

void set_ambient(Simulation& simulation, double pressure, double temperature) {
  gas::ControlVolumeModel model = gas_of(simulation, "pressure").model;
  control::require(pressure >= 0.0 && std::isfinite(pressure), "pressure", pressure, "0 or more");
  control::require(temperature > 0.0 && std::isfinite(temperature), "temperature", temperature, "above 0");
  model.ambient.pressure = pressure;
  model.ambient.temperature = temperature;
  gas::validate(model);  // before anything changes
  simulation.change_level([pressure, temperature](Scene& scene, State& state) {
    settle_ambient_work(scene, state, pressure);
    for (gas::Ambient* ambient : {&scene.ambient, &scene.gas->model.ambient}) {
      ambient->pressure = pressure;
      ambient->temperature = temperature;
    }
    state.gas_integrator.emplace(scene.gas->model, scene.gas->integrator);
  });
  simulation.note({Control::ambient, 0, {pressure, temperature}});
}

void set_inflow(Simulation& simulation, std::size_t inflator, double mass_flow, double temperature) {
  const GasPart& gas = gas_of(simulation, "inflator");
  control::require_number(inflator, gas.model.inflows.size(), "inflator");
  control::require(mass_flow >= 0.0 && std::isfinite(mass_flow), "mass_flow", mass_flow, "0 or more");
  control::require(temperature > 0.0 && std::isfinite(temperature), "temperature", temperature, "above 0");
  const auto change = [inflator, mass_flow, temperature](Scene& scene, State& state) {
    gas::Inflow& inflow = scene.gas->model.inflows[inflator];
    inflow.mass_flow = gas::Curve::constant(mass_flow);
    inflow.temperature = gas::Curve::constant(temperature);
    inflow.start_time = 0.0;
    inflow.trigger.reset();
    state.gas_integrator.emplace(scene.gas->model, scene.gas->integrator);
    for (std::size_t j = 0; j < scene.jets.size(); ++j)
      if (scene.jets[j].inflator == inflator) state.jets[j].firing = 0.0;
  };
  gas::ControlVolumeModel model = gas.model;  // tested before anything changes
  model.inflows[inflator].temperature = gas::Curve::constant(temperature);
  gas::validate(model);
  simulation.change_level(change);
  simulation.note({Control::inflow, inflator, {mass_flow, temperature}});
}

void meet_every(Simulation& simulation, double interval) {
  const double least = 1e-6 * simulation.scene().time.end;
  control::require(interval == 0.0 || (interval >= least && std::isfinite(interval)), "interval", interval,
                   "0, or a millionth of the end time or more");
  simulation.change_level([interval](Scene&, State& state) { state.step.meet_every = interval; });
}

void set_gravity(Simulation& simulation, const Vector3d& gravity) {
  const Scene& scene = simulation.scene();
  control::require_finite(gravity, "gravity");
  if (!scene.moves()) control::refuse("gravity: has no effect, as nothing in the scene moves");
  if (!scene.gravity.isZero(0.0))
    control::refuse(
        "gravity: is constant in the scene, which counts its energy, allowed: a case without scene.gravity, "
        "or "
        "with one over time");
  simulation.change_now([gravity](Scene& changed, State&) {
    changed.field = {gas::Curve::constant(gravity.x()), gas::Curve::constant(gravity.y()),
                     gas::Curve::constant(gravity.z())};
  });
  simulation.note({Control::gravity, 0, {gravity.x(), gravity.y(), gravity.z()}});
}

void apply(Simulation& simulation, const Control& control) {
  const auto& v = control.value;
  switch (control.kind) {
    case Control::vent:
      return set_vent_area(simulation, control.part, v[0]);
    case Control::ambient:
      return set_ambient(simulation, v[0], v[1]);
    case Control::inflow:
      return set_inflow(simulation, control.part, v[0], v[1]);
    case Control::outlet:
      return place_outlet(simulation, control.part, {v[0], v[1], v[2]}, {v[3], v[4], v[5]});
    case Control::gravity:
      return set_gravity(simulation, {v[0], v[1], v[2]});
  }
  control::refuse("state: is damaged, allowed: bytes as they were saved");
}

void set_impactor(Simulation& simulation, const ImpactorPlace& place) {
  const Scene& scene = simulation.scene();
  if (!scene.body)
    control::refuse(scene.pendulum ? "sim: has an impactor on a pendulum, allowed: one on a rail or free"
                                   : "sim: has no impactor, allowed: a case with one on a rail or free");
  if (simulation.now().evaluated)
    control::refuse(fmt::format(
        "sim: is evaluated at {:.6g} s, allowed: after a step, before forces, contact or the next "
        "step are read",
        simulation.state().time));
  control::require_finite(place.centre, "centre");
  control::require_finite(place.velocity, "velocity");
  control::require_finite(place.angular_velocity, "angular_velocity");
  require_rotation(place.axes);
  require_no_turn(scene, place.angular_velocity);
  const State& now = simulation.state();
  const double jump = (place.centre - now.body->motion.centre).norm(),
               half = 0.5 * coupling::size_of(scene.impactor);
  if (scene.contact && !(jump <= half))
    control::refuse(
        fmt::format("centre: jumps by {:.3g} m, allowed: {:.3g} m, half of what it may sink in", jump, half));
  simulation.change_now([place](Scene& changed, State& state) {
    take_over(state);
    state.body->motion.centre = place.centre;
    state.body->motion.axes = place.axes;
    set_speed(changed, state, place.velocity, place.angular_velocity);
  });
}

void set_impactor_speed(Simulation& simulation, const Vector3d& velocity, const Vector3d& angular_velocity) {
  if (!simulation.state().body || !simulation.state().body->driven)
    control::refuse("sim: has no impactor of the caller, allowed: after its place was set");
  control::require_finite(velocity, "velocity");
  control::require_finite(angular_velocity, "angular_velocity");
  require_no_turn(simulation.scene(), angular_velocity);
  simulation.change_now([velocity, angular_velocity](Scene& scene, State& state) {
    set_speed(scene, state, velocity, angular_velocity);
  });
}

gas::GasPoint gas_now(const Scene& scene, const State& state) {
  const Enclosure now = enclosure(scene, state);
  return gas::evaluate(scene.gas->model, state.gas, now.volume, now.leak_area, state.time);
}

membrane::VectorsMap own_force(Simulation& simulation) {
  if (!simulation.scene().bag) control::refuse("sim: has no skin, allowed: a case with [membrane]");
  membrane::Vectors* force = nullptr;
  simulation.change_now([&](Scene&, State& state) { force = &state.bag->own_force; });
  if (force->empty()) control::refuse("sim: takes no forces, allowed: a scene that is driven");
  return force->map();
}

}  // namespace driver
