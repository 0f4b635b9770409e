// SPDX-License-Identifier: Apache-2.0
// What the caller of a simulation sets.
#include <gasjet/simulation.h>

#include "arrays.hpp"
#include "engine/controls.hpp"
#include "sim_object.hpp"

using namespace border;

namespace {

std::size_t index_of(int64_t value, const char* argument) {
  if (value < 0) refuse(argument, "is " + std::to_string(value) + ", allowed: 0 or more");
  return static_cast<std::size_t>(value);
}

}  // namespace

int gasjet_sim_own_force(gasjet_handle sim, double** force, int64_t* nodes, int64_t* stride) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(force, "force");
    needed(nodes, "nodes");
    needed(stride, "stride");
    const auto view = driver::own_force(use->simulation);
    *force = const_cast<double*>(view.data());
    *nodes = view.cols();
    *stride = view.outerStride();
  });
}

int gasjet_sim_meet_every(gasjet_handle sim, double interval) {
  return call([&] { driver::meet_every(Use<Sim>(sim, "sim")->simulation, interval); });
}

int gasjet_sim_set_vent(gasjet_handle sim, int64_t vent, double area) {
  return call([&] { driver::set_vent_area(Use<Sim>(sim, "sim")->simulation, index_of(vent, "vent"), area); });
}

int gasjet_sim_set_sensor(gasjet_handle sim, const char* name, int on) {
  return call([&] { driver::set_sensor(Use<Sim>(sim, "sim")->simulation, text(name, "name"), on != 0); });
}

int gasjet_sim_set_ambient(gasjet_handle sim, double pressure, double temperature) {
  return call([&] { driver::set_ambient(Use<Sim>(sim, "sim")->simulation, pressure, temperature); });
}

int gasjet_sim_set_inflow(gasjet_handle sim, int64_t inflator, double mass_flow, double temperature) {
  return call([&] {
    driver::set_inflow(Use<Sim>(sim, "sim")->simulation, index_of(inflator, "inflator"), mass_flow,
                       temperature);
  });
}

int gasjet_sim_set_outlet(gasjet_handle sim, int64_t jet, const double centre[3], const double axis[3]) {
  return call([&] {
    driver::set_outlet(Use<Sim>(sim, "sim")->simulation, index_of(jet, "jet"), vector_of(centre, "centre"),
                       vector_of(axis, "axis"));
  });
}

int gasjet_sim_set_gravity(gasjet_handle sim, const double gravity[3]) {
  return call([&] { driver::set_gravity(Use<Sim>(sim, "sim")->simulation, vector_of(gravity, "gravity")); });
}

int gasjet_sim_set_impactor(gasjet_handle sim, const double centre[3], const double axes[9],
                            const double velocity[3], const double angular_velocity[3]) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    driver::ImpactorPlace place{vector_of(centre, "centre")};
    place.velocity = vector_of(velocity, "velocity");
    if (angular_velocity != nullptr) place.angular_velocity = vector_of(angular_velocity, "angular_velocity");
    if (axes != nullptr)
      for (int i = 0; i < 3; ++i) place.axes.col(i) = vector_of(axes + 3 * i, "axes");
    else if (use->state().body)
      place.axes = use->state().body->motion.axes;
    driver::set_impactor(use->simulation, place);
  });
}

int gasjet_sim_set_impactor_speed(gasjet_handle sim, const double velocity[3],
                                  const double angular_velocity[3]) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    driver::set_impactor_speed(
        use->simulation, vector_of(velocity, "velocity"),
        angular_velocity ? vector_of(angular_velocity, "angular_velocity") : Eigen::Vector3d(0.0, 0.0, 0.0));
  });
}
