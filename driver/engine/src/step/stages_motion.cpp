// SPDX-License-Identifier: Apache-2.0
// S3 forces, the size of the step, S8 advance, S9 volume.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/channel_filter.hpp"
#include "engine/drift.hpp"
#include "engine/stages.hpp"
#include "step/step_limits.hpp"

namespace driver {
namespace {

// Rate at which all jets damp the skin, at most (J.9) [1/s].
double jet_damping(const Scene& scene, const State& state) {
  double sum = 0.0;
  for (std::size_t j = 0; j < scene.jets.size(); ++j)
    sum += jet::damping_rate(scene.jets[j].field.model(), state.jets[j].outlet, state.jets[j].load(),
                             state.bag->area_vector.map(), scene.bag->element_mass);
  return sum;
}

void update_bound(const Scene& scene, State& state) {
  if (!state.bag) {
    const double swing = state.pendulum ? scene.pendulum->model.omega_squared(Eigen::Vector3d::Zero()) : 0.0;
    state.step.critical = swing > 0.0 ? 2.0 / std::sqrt(swing) : std::numeric_limits<double>::infinity();
    return;
  }
  const bool gas = scene.gas.has_value();
  state.step.shares =
      membrane::stiffness_shares(scene.bag->model, *state.bag, gas ? state.gas_point.gamma : 0.0,
                                 gas ? state.gas_point.pressure : 0.0, contact_stiffness(scene, state));
  state.step.jet_damping = jet_damping(scene, state);
  state.step.critical = membrane::critical_time_step(state.step.shares, state.step.jet_damping);
  state.step.drift_limit = drift_limit(scene, state);
}

// Step by stability, energy and deformation [s]. The bound jumps as crumpled elements come and go, and a step
// that jumps with it heats the skin, so its share grows slowly (M.33).
double free_step(const Scene& scene, State& state) {
  constexpr double steady_growth = 1.0002;
  StepSizes& step = state.step;
  step.steady = std::min(scene.time.safety * step.critical, steady_growth * step.steady);
  const double wanted = std::min(step.steady, scene.time.safety * step.drift_limit);
  if (!state.bag) return wanted;
  const double most = membrane::kLargestDeformation;
  const auto fastest = membrane::deformation_rate(scene.bag->model, *state.bag, most / wanted);
  if (fastest.element < 0) return wanted;
  ++step.deformation_limited;
  step.deformed_element = fastest.element;
  return most / fastest.rate;
}

// A given step is kept; its worst change of the deformation gradient is told.
void book_deformation(const Scene& scene, State& state) {
  StepSizes& step = state.step;
  const auto fastest =
      membrane::deformation_rate(scene.bag->model, *state.bag, step.deformation / step.after);
  if (fastest.element < 0) return;
  step.deformation = fastest.rate * step.after;
  step.deformed_element = fastest.element;
}

void book_step(StepSizes& step) {
  step.minimum = step.minimum == 0.0 ? step.after : std::min(step.minimum, step.after);
  step.maximum = std::max(step.maximum, step.after);
  if (step.drift_limit < step.critical) ++step.drift_limited;
  const double all = step.shares.total();
  if (!(all > 0.0)) return;
  step.share_sums.element += step.shares.element / all;
  step.share_sums.gas += step.shares.gas / all;
  step.share_sums.contact += step.shares.contact / all;
  step.share_sums.strap += step.shares.strap / all;
  step.share_sums.plate += step.shares.plate / all;
}

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

void choose_step(const Scene& scene, State& state, bool last) {
  StageTimer timer(state, Stage::advance);
  StepSizes& step = state.step;
  update_bound(scene, state);
  if (last && step.before > 0.0) {
    step.after = step.before;
    return;
  }
  double wanted = scene.output.history_every;
  if (scene.time.step)
    wanted = *scene.time.step;
  else if (scene.moves())
    wanted = free_step(scene, state);
  // Of what is filtered there are samples enough; a fixed step is refused before it comes here.
  if (!scene.output.channel_classes.empty())
    wanted = std::min(wanted, widest_interval(scene.output.channel_classes.back()));
  if (scene.time.step && wanted > step.critical && !scene.time.unsafe_step) refuse_step(scene, state, wanted);
  // The last steps share what is left, so that the end is met without a shorter one: the energy of a level
  // contains the step (K.40). Of steps that the case gives two share, and gas alone keeps to its rows. Up to
  // a row all of them share, or steps that alternate at each row could resonate with a mode.
  const double left = next_stop(scene, state.time) - state.time;
  const double sharing = !scene.moves() ? 1.0 : scene.time.step ? 2.0 : 100.0;
  const double steps = std::max(1.0, std::ceil(left / wanted * (1.0 - 1e-9)));
  if (scene.output.history_exact || steps <= sharing) wanted = left / steps;
  step.after = std::min(wanted, left);
  if (scene.time.step && state.bag) book_deformation(scene, state);
  if (step.after < left && step.after < 1e-9 * scene.time.end) refuse_short_step(scene, state);
  book_step(step);
}

double next_stop(const Scene& scene, double time) {
  const double end = scene.time.end, every = scene.output.history_every;
  if (!scene.output.history_exact) return end;
  const double next = (std::floor(time / every * (1.0 + 1e-12)) + 1.0) * every;
  return next < end * (1.0 - 1e-12) ? next : end;
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
