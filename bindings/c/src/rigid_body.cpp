// SPDX-License-Identifier: Apache-2.0
#include "coupling/rigid_body.hpp"

#include <gasjet/coupling.h>

#include <cmath>
#include <limits>

#include "arrays.hpp"
#include "engine/channel_filter.hpp"
#include "membrane/stages.hpp"

using namespace border;
using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr double kLongest = 10.0;  // [s] of a signal; it is resampled to 100 kHz

coupling::Rail rail_of(const gasjet_rigid_body_model& given) {
  coupling::Rail rail{Eigen::Map<const Vector3d>(given.direction)};
  for (const gasjet_rail_spring& spring : given.springs)
    if (spring.stiffness != 0.0 || spring.damping != 0.0)
      rail.springs.push_back({spring.stiffness, spring.damping, spring.at, spring.one_sided != 0});
  return rail;
}

coupling::RigidBodyModel body_of(const gasjet_rigid_body_model* pointer) {
  const gasjet_rigid_body_model& given = needed(pointer, "model");
  if (given.motion != GASJET_FREE_BODY && given.motion != GASJET_ON_RAIL)
    refuse("body.motion", "is " + std::to_string(given.motion) + ", allowed: a gasjet_motion, 0 or 1");
  coupling::RigidBodyParameters parameters;
  parameters.mass = given.mass;
  parameters.centre = Eigen::Map<const Vector3d>(given.centre);
  parameters.axes = Eigen::Map<const Matrix3d>(given.axes);
  parameters.velocity = Eigen::Map<const Vector3d>(given.velocity);
  parameters.angular_velocity = Eigen::Map<const Vector3d>(given.angular_velocity);
  parameters.inertia = Eigen::Map<const Matrix3d>(given.inertia);
  parameters.gravity = Eigen::Map<const Vector3d>(given.gravity);
  if (given.motion == GASJET_ON_RAIL) parameters.rail = rail_of(given);
  return coupling::RigidBodyModel(parameters);
}

coupling::RigidBodyState state_of(const gasjet_rigid_body_state* pointer) {
  const gasjet_rigid_body_state& given = needed(pointer, "state");
  const Matrix3d axes = Eigen::Map<const Matrix3d>(given.axes);
  const bool unit = (axes.transpose() * axes - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 1e-9;
  if (!(unit && axes.determinant() > 0.0))
    refuse("state.axes", "are other rows, allowed: three unit vectors at right angles, right-handed");
  return {vector_of(given.centre, "state.centre"), axes, vector_of(given.velocity, "state.velocity"),
          vector_of(given.angular_momentum, "state.angular_momentum")};
}

gasjet_rigid_body_state written(const coupling::RigidBodyState& state) {
  gasjet_rigid_body_state out;
  write_vector(state.centre, out.centre);
  Eigen::Map<Matrix3d>(out.axes) = state.axes;
  write_vector(state.velocity, out.velocity);
  write_vector(state.angular_momentum, out.angular_momentum);
  return finite(out, "state");
}

struct Steps {
  double before, after;  // [s]
  double tau() const { return 0.5 * (before + after); }
};

gasjet_rigid_body_kick written(const coupling::RigidBodyKick& kick, const Steps& step,
                               const Vector3d& velocity_before, const Vector3d& velocity_after) {
  gasjet_rigid_body_kick out;
  const Vector3d change = velocity_after - velocity_before;
  write_vector(velocity_before + 0.5 * step.before / step.tau() * change, out.velocity);
  write_vector(change / step.tau(), out.acceleration);
  out.kinetic_energy = kick.kinetic_after;
  if (step.after > 0.0)
    out.kinetic_energy = membrane::level_kinetic(kick.kinetic_before, kick.kinetic_after, kick.kinetic_mixed,
                                                 step.before, step.after);
  out.kinetic_before = kick.kinetic_before;
  out.kinetic_after = kick.kinetic_after;
  out.load_work = kick.load_work;
  out.damping_loss = kick.damping_loss;
  out.work = kick.work;
  return finite(out, "kick");
}

void require_rising(std::span<const double> time) {
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      refuse("time", "of row " + std::to_string(i) + " is " + shown(time[i]) + ", allowed: more than " +
                         shown(time[i - 1]) + ", the one before");
  if (!(time.back() - time.front() <= kLongest))
    refuse("time", "spans " + shown(time.back() - time.front()) + " s, allowed: at most " + shown(kLongest));
}

}  // namespace

int gasjet_rigid_body_defaults(gasjet_rigid_body_model* model) {
  return call([&] {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    gasjet_rigid_body_model defaults{};
    defaults.mass = nan;
    for (int i = 0; i < 3; ++i) defaults.centre[i] = nan, defaults.axes[4 * i] = 1.0;
    needed(model, "model") = defaults;
  });
}

int gasjet_rigid_body_start(const gasjet_rigid_body_model* model, gasjet_rigid_body_state* state) {
  return call([&] { needed(state, "state") = written(body_of(model).initial()); });
}

int gasjet_rigid_body_evaluate(const gasjet_rigid_body_model* model, const gasjet_rigid_body_state* state,
                               gasjet_rigid_body_point* point) {
  return call([&] {
    const auto body = body_of(model);
    const auto now = state_of(state);
    gasjet_rigid_body_point out;
    out.displacement = body.displacement(now);
    out.speed = body.speed(now.velocity);
    write_vector(body.angular_velocity(now), out.angular_velocity);
    write_vector(body.own_force(now), out.own_force);
    out.gravity_energy = body.gravity_energy(now);
    out.spring_energy = body.spring_energy(now);
    out.kinetic_energy = body.kinetic_energy(now);
    needed(point, "point") = finite(out, "point");
  });
}

int gasjet_rigid_body_advance(const gasjet_rigid_body_model* model, const double force[3],
                              const double couple[3], double dt_before, double dt_after,
                              gasjet_rigid_body_state* state, gasjet_rigid_body_kick* kick) {
  return call([&] {
    const auto body = body_of(model);
    const auto before = state_of(state);
    coupling::RigidBodyLoad load{vector_of(force, "force")};
    if (couple != nullptr) load.couple = vector_of(couple, "couple");
    const Steps step{number(dt_before, "dt_before", 0.0), number(dt_after, "dt_after", 0.0)};
    if (!(step.tau() > 0.0 && std::isfinite(step.tau())))
      refuse("dt_after", "is " + shown(dt_after) + " after a step of " + shown(dt_before) +
                             ", allowed: a number above 0 at the start");
    auto after = before;
    const auto done = body.advance(after, load, step.tau(), dt_after);
    const auto next = written(after);
    const auto what = written(done, step, before.velocity, after.velocity);
    if (kick != nullptr) needed(kick, "kick") = what;
    *state = next;
  });
}

int gasjet_rigid_body_limits(const gasjet_rigid_body_model* model, double reach, double contact_force,
                             double* effective_mass, double* frequency) {
  return call([&] {
    const auto body = body_of(model);
    number(reach, "reach", 0.0);
    number(contact_force, "contact_force", 0.0);
    needed(effective_mass, "effective_mass");
    needed(frequency, "frequency");
    const double mass = finite(body.effective_mass(reach), "effective_mass");
    *frequency = finite(body.omega_squared(contact_force, reach), "frequency");
    *effective_mass = mass;
  });
}

int gasjet_head_injury_criterion(const double time[], const double acceleration[], int64_t count,
                                 const int64_t stride[], double window, double* criterion) {
  return call([&] {
    needed(time, "time");
    count_of(count, "count", 2);
    const Points rows(acceleration, count, stride, "acceleration");
    const std::span all(time, static_cast<std::size_t>(count));
    for (const double one : all) number(one, "time");
    require_rising(all);
    number(window, "window", 1e-4, 0.1);
    driver::VectorSignal signal{{all.begin(), all.end()}, {}, {}, {}};
    for (Eigen::Index i = 0; i < count; ++i) {
      signal.first.push_back(rows.view()(0, i));
      signal.second.push_back(rows.view()(1, i));
      signal.third.push_back(rows.view()(2, i));
    }
    const double found = driver::head_injury_criterion(signal, window);
    needed(criterion, "criterion") = finite(found, "criterion");
  });
}
