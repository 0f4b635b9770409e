// SPDX-License-Identifier: Apache-2.0
// S4: the impactor's sphere against the skin, and both contacts in order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/impactor.hpp"
#include "engine/stages.hpp"

namespace driver {
namespace {

// No skin point moves faster than the fastest node.
double motion_bound(const Scene& scene, const State& state, const ImpactorMotion& now) {
  return state.step.before * std::sqrt(state.bag->advance.max_speed_squared) +
         (now.pose.centre - state.level.impactor.centre).norm() +
         turning_reach(scene.impactor) * now.turn.norm();
}

// What skin and sphere may move towards each other in a step that contact does not limit [m]: twice what
// their speeds give.
double motion_ahead(const Scene& scene, const State& state) {
  membrane::StiffnessShares others = state.step.shares;
  others.contact = 0.0;
  if (!(others.total() > 0.0)) return 0.0;  // before the first step
  const double speed = std::sqrt(state.bag->advance.max_speed_squared) + impactor_speed(scene, state);
  return 2.0 * speed * membrane::critical_time_step(others);
}

// The depth falls at least with the root of the stiffness (K.23): to a third, then to a tenth.
std::string stiffer(const Scene& scene) {
  const double now = scene.contact_share.value_or(scene.contact->parameters().stiffness);
  const char* key = scene.contact_share ? "stiffness_share" : "stiffness";
  return fmt::format("contact.{} = {:.3g}, then {:.3g} (now {:.3g})", key, 10.0 * now, 100.0 * now, now);
}

coupling::ContactResult evaluate(const Scene& scene, State& state, const ImpactorMotion& now) {
  try {
    return scene.contact->evaluate(*state.contact_cache, state.bag->position.map(), now.pose,
                                   state.bag->contact_force.map(), now.turn);
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

// A pendulum's path is an arc, of which contact tests the chord.
void require_followed(const Scene& scene, const State& state) {
  if (state.pendulum)
    return scene.pendulum->model.require_followed(state.step.before *
                                                  state.pendulum->motion.angular_velocity);
  const double path = state.step.before * impactor_speed(scene, state),
               half = 0.5 * coupling::size_of(scene.impactor);
  if (!(path <= half))
    throw coupling::ContactError(
        fmt::format("contact: the impactor moves {:.3g} m within one step, the limit is {:.3g} m, "
                    "half of what it may sink in",
                    path, half));
}

// What the impactor feels besides the contact, at level n.
void start_level(const Scene& scene, State& state) {
  if (state.pendulum) {
    PendulumRun& pendulum = *state.pendulum;
    state.level.pendulum_angle = pendulum.motion.angle;
    pendulum.moment = scene.pendulum->model.gravity_moment(pendulum.motion.angle);
    pendulum.contact_moment = 0.0;
  } else {
    const coupling::RigidBodyModel& model = scene.body->model;
    BodyRun& body = *state.body;
    body.displacement = model.displacement(body.motion);
    body.gravity_energy = body.driven ? 0.0 : model.gravity_energy(body.motion);
    body.spring_energy = body.driven ? 0.0 : model.spring_energy(body.motion);
    body.contact = {};
  }
}

void book_contact(const Scene& scene, State& state) {
  const coupling::ContactResult& found = state.contact;
  state.flows.friction_loss += found.friction_loss;
  if (state.body) {
    state.body->contact = {found.force, found.couple};
    return;
  }
  const coupling::PendulumModel& model = scene.pendulum->model;
  PendulumRun& pendulum = *state.pendulum;
  pendulum.contact_moment =
      model.moment(found.force, state.level.impactor.centre) + model.parameters().axis.dot(found.couple);
  pendulum.moment += pendulum.contact_moment;
}

void impactor_contact(const Scene& scene, State& state) {
  const ImpactorMotion now = impactor_motion(scene, state);
  start_level(scene, state);
  const double motion = scene.contact ? motion_bound(scene, state, now) : 0.0;
  state.level.impactor = now.pose;
  if (!scene.contact) return;
  require_followed(scene, state);
  if (scene.contact->stays_clear(*state.contact_cache, motion, motion_ahead(scene, state))) {
    state.contact = {};
    return;
  }
  state.contact = evaluate(scene, state, now);
  book_contact(scene, state);
}

}  // namespace

void contact(const Scene& scene, State& state) {
  if (!scene.has_impactor() && !scene.skin_contact) return;
  StageTimer timer(state, Stage::contact);
  // The forces of the last level, if there were any.
  if (state.contact.area > 0.0 || state.skin_contact.contacts > 0) state.bag->contact_force.map().setZero();
  if (scene.has_impactor()) impactor_contact(scene, state);
  if (scene.skin_contact) skin_contact(scene, state);
}

double contact_stiffness(const Scene& scene, const State& state) {
  if (!scene.contact) return 0.0;
  const double free = coupling::ContactModel::free_gap(*state.contact_cache);
  if (free > motion_ahead(scene, state)) return 0.0;
  // And the turning of the contact force about a pivot, or the springs of a rail. A pendulum's own swing is
  // slower by far than any skin.
  return scene.contact->full_omega_squared() + state.contact.omega_squared_sphere +
         impactor_omega_squared(scene, state.contact.force);
}

}  // namespace driver
