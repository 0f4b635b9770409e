// SPDX-License-Identifier: Apache-2.0
// S3 forces, S8 advance, S9 volume.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/stages.hpp"

namespace driver {
namespace {

// Largest distance of a node from where it started [m].
double skin_displacement(const Scene& scene, const State& state) {
  return (state.bag->position.map() - scene.bag->initial_position).colwise().norm().maxCoeff();
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
  if (state.bag) {
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
  if (!state.pendulum) return;
  PendulumRun& run = *state.pendulum;
  const auto& model = scene.pendulum->model;
  const double tau = 0.5 * (step.before + step.after);
  if (const auto& curve = scene.pendulum->driving_moment) run.driving_moment = kick_mean(*curve, step);
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
  level.displacement = skin_displacement(scene, state);
  level.skin_gravity = skin_gravity(scene, state);
  const auto velocity = state.bag->velocity.map();
  if (!state.jets.empty()) level.jet_power = state.bag->jet_force.map().cwiseProduct(velocity).sum();
  if (scene.bag->overpressure)
    level.pressure_power =
        state.bag->gauge_pressure * state.bag->volume_gradient.map().cwiseProduct(velocity).sum();
}

}  // namespace driver
