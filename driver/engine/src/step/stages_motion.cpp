// SPDX-License-Identifier: Apache-2.0
// S3 forces, S8 advance, S9 volume.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/impactor.hpp"
#include "engine/stages.hpp"

namespace driver {
namespace {

// Largest distance of a node from where it started [m].
double skin_displacement(const Scene& scene, const State& state) {
  return std::sqrt(
      (state.bag->position.map() - scene.bag->initial_position).colwise().squaredNorm().maxCoeff());
}

// Power of the jets' forces [W]. Of the other nodes, which are most, the force is zero.
double jet_power(const membrane::BagState& bag) {
  double power = 0.0;
  for (std::size_t node = 0; node < bag.has_jet_force.size(); ++node) {
    if (!bag.has_jet_force[node]) continue;
    const double *force = bag.jet_force.data() + 4 * node, *velocity = bag.velocity.data() + 4 * node;
    for (int c = 0; c < 3; ++c) power += force[c] * velocity[c];
  }
  return power;
}

// Potential energy of the weight at the current positions [J].
double skin_gravity(const Scene& scene, const State& state) {
  if (scene.gravity.isZero(0.0)) return 0.0;
  const auto position = state.bag->position.map();
  double energy = 0.0;
  for (Eigen::Index node = 0; node < position.cols(); ++node)
    energy -=
        scene.bag->model.node_mass[static_cast<std::size_t>(node)] * scene.gravity.dot(position.col(node));
  return energy;
}

void advance_pendulum(const Scene& scene, State& state) {
  const StepSizes& step = state.step;
  PendulumRun& run = *state.pendulum;
  const auto& model = scene.pendulum->model;
  const double tau = 0.5 * (step.before + step.after);
  const auto& curve = scene.pendulum->driving_moment;
  run.driving_moment = curve ? kick_mean(*curve, step) : 0.0;
  if (scene.field)
    run.driving_moment +=
        model.moment(model.parameters().mass * state.level.field, model.cg_position(run.motion.angle));
  const double moment = run.moment + run.driving_moment;
  run.angular_velocity = model.angular_velocity_at_level(run.motion, moment, step.before);
  run.acceleration = model.cg_acceleration(moment, run.angular_velocity);
  const double before = run.motion.angular_velocity;
  run.motion = model.advance(run.motion, moment, tau, step.after);
  const double after = run.motion.angular_velocity;
  run.kinetic_before = model.kinetic_energy(before);
  run.kinetic_after = model.kinetic_energy(after);
  run.kinetic = membrane::level_kinetic(run.kinetic_before, run.kinetic_after,
                                        0.5 * model.axis_inertia() * before * after, step.before, step.after);
  state.flows.kick_work += tau * moment * 0.5 * (before + after);
  run.driving_work = tau * run.driving_moment * 0.5 * (before + after);
  run.driving_work_before = work_before_level(step, run.driving_moment * before, run.driving_work);
}

// The caller's work on the contact from level to level is that of the mean force. The body's own mass takes
// no part.
void follow_caller(const Scene& scene, State& state) {
  BodyRun& run = *state.body;
  const StepSizes& step = state.step;
  const coupling::RigidBodyModel& model = scene.body->model;
  const Eigen::Vector3d path = run.motion.centre - run.last_pose.centre,
                        turn = turn_between(run.last_pose.axes, run.motion.axes);
  const double work = -0.5 * ((run.contact.force + run.last_contact.force).dot(path) +
                              (run.contact.couple + run.last_contact.couple).dot(turn));
  state.flows.driving_work += work;
  state.level.flows.driving_work += work;
  const double tau = kick_length(step);
  const Eigen::Vector3d change = run.motion.velocity - run.last_velocity;
  run.velocity = run.last_velocity + kick_share(step) * change;
  if (step.before > 0.0 && tau > 0.0) run.acceleration = change / tau;
  run.angular_velocity = model.angular_velocity(run.motion);
  run.last_pose = {run.motion.centre, run.motion.axes};
  run.last_contact = run.contact;
  run.last_velocity = run.motion.velocity;
  run.kick = {};
  run.kinetic = run.driving_work = run.driving_work_before = 0.0;
  run.motion.centre += step.after * run.motion.velocity;
  run.motion.axes = turned(run.motion.axes, step.after * run.angular_velocity);
}

void advance_body(const Scene& scene, State& state) {
  if (state.body->driven) return follow_caller(scene, state);
  const StepSizes& step = state.step;
  const BodyPart& part = *scene.body;
  BodyRun& run = *state.body;
  const double tau = 0.5 * (step.before + step.after);
  const coupling::RigidBodyState before = run.motion;
  coupling::RigidBodyLoad load = run.contact;
  Eigen::Vector3d drive = part.model.parameters().mass * state.level.field;
  if (part.force) drive += kick_mean(*part.force, step) * part.model.parameters().rail->direction;
  load.force += drive;
  const double after_last_kick = run.kick.kinetic_after;
  run.kick = part.model.advance(run.motion, load, tau, step.after);
  // A free rotation between two kicks keeps its energy but for an error of its step (K.56), which the drift
  // shows, not the kicks.
  if (step.before > 0.0) state.flows.kick_work += run.kick.kinetic_before - after_last_kick;
  state.flows.kick_work += run.kick.work;
  const double share = tau > 0.0 ? 0.5 * step.before / tau : 0.0;  // of the kick that is before n
  const Eigen::Vector3d change = run.motion.velocity - before.velocity;
  run.velocity = before.velocity + share * change;
  if (tau > 0.0) run.acceleration = change / tau;
  coupling::RigidBodyState level = before;
  level.angular_momentum += share * (run.motion.angular_momentum - before.angular_momentum);
  run.angular_velocity = part.model.angular_velocity(level);
  run.kinetic = membrane::level_kinetic(run.kick.kinetic_before, run.kick.kinetic_after,
                                        run.kick.kinetic_mixed, step.before, step.after);
  run.driving_work = 0.5 * tau * drive.dot(before.velocity + run.motion.velocity);
  run.driving_work_before = work_before_level(step, drive.dot(before.velocity), run.driving_work);
}

}  // namespace

void forces(const Scene& scene, State& state, const Executor& executor) {
  if (!state.bag) return;
  StageTimer timer(state, Stage::forces);
  // The fabric's forces at these positions came with the surface: S9 of the step before.
  const auto& model = scene.bag->model;
  state.level.skin_strain = state.bag->forces.strain_energy;
  membrane::support_forces(model, *state.bag, ParallelBlocks{executor});
  if (scene.gas) membrane::pressure_forces(*state.bag, state.gas_point.pressure - scene.ambient.pressure);
  membrane::viscous_forces(model, *state.bag, state.step.before, ParallelBlocks{executor});
}

void prescribed_pressure(const Scene& scene, State& state) {
  if (!state.bag || !scene.bag->overpressure) return;
  StageTimer timer(state, Stage::forces);
  membrane::pressure_forces(*state.bag, kick_mean(*scene.bag->overpressure, state.step));
}

void advance(const Scene& scene, State& state, const Executor& executor) {
  StageTimer timer(state, Stage::advance);
  StepSizes& step = state.step;
  if (scene.field)
    for (int c = 0; c < 3; ++c)
      state.level.field[c] = kick_mean((*scene.field)[static_cast<std::size_t>(c)], step);
  if (state.bag) {
    if (scene.field) state.bag->gravity = state.level.field;
    if (!state.bag->own_force.empty())
      state.level.own_power = state.bag->own_force.map().cwiseProduct(state.bag->velocity.map()).sum();
    membrane::advance(scene.bag->model, *state.bag, step.before, step.after, ParallelBlocks{executor});
    const double tau = 0.5 * (step.before + step.after);
    const membrane::AdvanceSums& sums = state.bag->advance;  // of squares: |v+ - v-|^2 = (tau f / m)^2
    step.force_mobility =
        2.0 / (tau * tau) *
        std::max(0.0, sums.kinetic_before + sums.kinetic_after - 2.0 * sums.kinetic_product);
    const double motion = step.after * std::sqrt(state.bag->advance.max_speed_squared);
    step.displacement_bound =
        std::nextafter(step.displacement_bound + motion, std::numeric_limits<double>::infinity());
  }
  if (state.pendulum) advance_pendulum(scene, state);
  if (state.body) advance_body(scene, state);
}

void volume(const Scene& scene, State& state, const Executor& executor) {
  if (!state.bag) return;
  StageTimer timer(state, Stage::volume);
  membrane::update_skin(scene.bag->model, *state.bag, ParallelBlocks{executor});
  constexpr int shares_every = 256;  // steps: a round may cost as much as ten of them
  if ((state.steps + 1) % shares_every == 0)
    membrane::update_mass_shares(scene.bag->model, *state.bag, ParallelBlocks{executor});
}

double kick_share(const StepSizes& step) {
  return step.before > 0.0 ? step.before / (step.before + step.after) : 0.0;
}

double kick_mean(const gas::Curve& curve, const StepSizes& step) {
  const double begin = step.kick_begin, end = step.kick_end;
  if (curve.next_knot(begin) < end) return curve.integral(begin, end) / kick_length(step);
  return curve.value(0.5 * (begin + end));  // of a line, rounded less than its integral
}

double work_before_level(const StepSizes& step, double power_before, double work) {
  const double length = kick_length(step);
  if (!(length > 0.0)) return 0.0;
  const double rise = 2.0 * (work / length - power_before);  // of the power, from n-1/2 to n+1/2
  return 0.5 * step.before * (power_before + (step.before - step.after) / (4.0 * length) * rise);
}

void look_at_level(const Scene& scene, State& state) {
  if (!state.bag) return;
  Level& level = state.level;
  level.skin_gravity = skin_gravity(scene, state);
  if (!state.jets.empty()) level.jet_power = jet_power(*state.bag);
  if (!scene.bag->overpressure) return;
  level.displacement = skin_displacement(scene, state);
  level.pressure_power = state.bag->gauge_pressure *
                         state.bag->volume_gradient.map().cwiseProduct(state.bag->velocity.map()).sum();
}

}  // namespace driver
