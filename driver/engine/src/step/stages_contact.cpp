// SPDX-License-Identifier: Apache-2.0
// S4: the impactor's sphere against the skin, and both contacts in order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/stages.hpp"

namespace driver {
namespace {

// No skin point moves faster than the fastest node.
double motion_bound(const State& state, const Eigen::Vector3d& centre) {
  return state.step.before * std::sqrt(state.bag->advance.max_speed_squared) +
         (centre - state.pendulum->centre).norm();
}

// What skin and sphere may move towards each other in a step that contact does not limit [m]: twice what
// their speeds give.
double motion_ahead(const Scene& scene, const State& state) {
  membrane::StiffnessShares others = state.step.shares;
  others.contact = 0.0;
  if (!(others.total() > 0.0)) return 0.0;  // before the first step
  const double arm = scene.pendulum->model.parameters().impactor_distance;
  const double speed = std::sqrt(state.bag->advance.max_speed_squared) +
                       arm * std::abs(state.pendulum->motion.angular_velocity);
  return 2.0 * speed * membrane::critical_time_step(others);
}

// The depth falls at least with the root of the stiffness (K.23): to a third, then to a tenth.
std::string stiffer(const Scene& scene) {
  const double now = scene.contact_share.value_or(scene.contact->parameters().stiffness);
  const char* key = scene.contact_share ? "stiffness_share" : "stiffness";
  return fmt::format("contact.{} = {:.3g}, then {:.3g} (now {:.3g})", key, 10.0 * now, 100.0 * now, now);
}

coupling::ContactResult evaluate(const Scene& scene, State& state, const Eigen::Vector3d& centre,
                                 const Eigen::Vector3d& turn) {
  try {
    return scene.contact->evaluate(*state.contact_cache, state.bag->position.map(), {centre},
                                   state.bag->contact_force.map(), turn);
  } catch (const coupling::PenetrationError& error) {
    const bool is_null = std::ranges::binary_search(scene.bag->null_elements, error.element());
    throw coupling::PenetrationError(
        is_null
            ? fmt::format("{}, of a null panel, which has no fabric and pushes nothing: let the sphere "
                          "swing past the hole, or give the panel fabric",
                          error.what())
            : fmt::format("{}; try {}: the sphere then sinks in less, and steps near the skin are shorter",
                          error.what(), stiffer(scene)),
        error.element());
  }
}

void sphere_contact(const Scene& scene, State& state) {
  PendulumRun& pendulum = *state.pendulum;
  const auto& model = scene.pendulum->model;
  state.level.pendulum_angle = pendulum.motion.angle;
  pendulum.moment = model.gravity_moment(pendulum.motion.angle);
  pendulum.contact_moment = 0.0;
  if (!scene.contact) return;
  // The central difference turned the pendulum by this since the last level.
  const double turn = state.step.before * pendulum.motion.angular_velocity;
  model.require_followed(turn);
  const Eigen::Vector3d centre = model.impactor_centre(pendulum.motion.angle);
  const double motion = motion_bound(state, centre);
  pendulum.centre = centre;
  if (scene.contact->stays_clear(*state.contact_cache, motion, motion_ahead(scene, state))) {
    state.contact = {};
    return;
  }
  const auto& axis = model.parameters().axis;
  state.contact = evaluate(scene, state, centre, turn * axis);
  pendulum.contact_moment = model.moment(state.contact.force, centre) + axis.dot(state.contact.couple);
  pendulum.moment += pendulum.contact_moment;
  state.flows.friction_loss += state.contact.friction_loss;
}

}  // namespace

void contact(const Scene& scene, State& state) {
  if (!state.pendulum && !scene.skin_contact) return;
  StageTimer timer(state, Stage::contact);
  // The forces of the last level, if there were any.
  if (state.contact.area > 0.0 || state.skin_contact.contacts > 0) state.bag->contact_force.map().setZero();
  if (state.pendulum) sphere_contact(scene, state);
  if (scene.skin_contact) skin_contact(scene, state);
}

double contact_stiffness(const Scene& scene, const State& state) {
  if (!scene.contact) return 0.0;
  const double free = coupling::ContactModel::free_gap(*state.contact_cache);
  if (free > motion_ahead(scene, state)) return 0.0;
  // The turning of the contact force about the pivot; the pendulum's own swing is slower by far than any
  // skin.
  return scene.contact->full_omega_squared() + state.contact.omega_squared_sphere +
         scene.pendulum->model.omega_squared(state.contact.force);
}

}  // namespace driver
