// SPDX-License-Identifier: Apache-2.0
// How long the next step is: by stability, energy, deformation and layers of the skin, and by what the
// output asks for.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/channel_filter.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
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
    const double swing = scene.has_impactor() ? impactor_omega_squared(scene, Eigen::Vector3d::Zero()) : 0.0;
    state.step.critical = swing > 0.0 ? 2.0 / std::sqrt(swing) : std::numeric_limits<double>::infinity();
    return;
  }
  const bool gas = scene.gas.has_value();
  state.step.self_contact = skin_contact_stiffness(scene, state);
  state.step.shares = membrane::stiffness_shares(
      scene.bag->model, *state.bag, gas ? state.gas_point.gamma : 0.0, gas ? state.gas_point.pressure : 0.0,
      contact_stiffness(scene, state) + state.step.self_contact);
  state.step.jet_damping = jet_damping(scene, state);
  state.step.critical = membrane::critical_time_step(state.step.shares, state.step.jet_damping);
  state.step.drift_limit = drift_limit(scene, state);
}

// `wanted` [s], or a shorter step in which no element deforms too much (M.32).
double within_deformation(const Scene& scene, State& state, double wanted) {
  StepSizes& step = state.step;
  const double most = membrane::kLargestDeformation;
  const auto fastest = membrane::deformation_rate(scene.bag->model, *state.bag, most / wanted);
  if (fastest.element < 0) return wanted;
  ++step.deformation_limited;
  step.deformed_element = fastest.element;
  return most / fastest.rate;
}

// `wanted` [s], or a shorter step where layers of the skin close much or are close (K.47), or many begin to
// touch at once (K.48). They are for a few steps only, from which the slow growth of (M.33) would not
// recover; this limit grows faster.
double within_contact(const Scene& scene, State& state, double wanted) {
  if (!scene.skin_contact) return wanted;
  constexpr double growth = 1.02;
  StepSizes& step = state.step;
  const double stable =
      scene.time.safety * 2.0 / std::sqrt(step.shares.total() + deep_contact_stiffness(scene, state));
  step.touching = std::min({stable, approach_limit(scene, state),
                            scene.time.safety * kink_limit(scene, state), growth * step.touching});
  if (!(step.touching < wanted)) return wanted;
  ++step.approach_limited;
  return step.touching;
}

// Step by stability, energy, deformation and layers [s]. The bound jumps as crumpled elements come and go,
// and a step that jumps with it heats the skin, so its share grows slowly (M.33).
double free_step(const Scene& scene, State& state) {
  constexpr double steady_growth = 1.0002;
  StepSizes& step = state.step;
  step.steady = std::min(scene.time.safety * step.critical, steady_growth * step.steady);
  const double wanted = std::min(step.steady, scene.time.safety * step.drift_limit);
  if (!state.bag) return wanted;
  return within_contact(scene, state, within_deformation(scene, state, wanted));
}

// A given step is kept. Its worst change of the deformation gradient is reported, and how far layers closed.
void book_given_step(const Scene& scene, State& state) {
  StepSizes& step = state.step;
  step.approach = std::max(step.approach, kLargestApproach * step.after / approach_limit(scene, state));
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
  step.self_contact_sum += step.self_contact / all;
  step.share_sums.strap += step.shares.strap / all;
  step.share_sums.plate += step.shares.plate / all;
}

}  // namespace

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
  const double left = next_stop(scene, state) - state.time;
  const double sharing = !scene.moves() ? 1.0 : scene.time.step ? 2.0 : 100.0;
  const double steps = std::max(1.0, std::ceil(left / wanted * (1.0 - 1e-9)));
  if (scene.output.history_exact || steps <= sharing) wanted = left / steps;
  step.after = std::min(wanted, left);
  if (scene.time.step && state.bag) book_given_step(scene, state);
  if (step.after < left && step.after < 1e-9 * scene.time.end) refuse_short_step(scene, state);
  book_step(step);
}

double next_stop(const Scene& scene, const State& state) {
  const double end = std::min(scene.time.end, state.step.stop);
  const auto before = [&](double every, double stop) {  // the next multiple, if it is before
    const double next = (std::floor(state.time / every * (1.0 + 1e-12)) + 1.0) * every;
    return next < stop * (1.0 - 1e-12) ? next : stop;
  };
  double stop = end;
  if (scene.output.history_exact) stop = before(scene.output.history_every, stop);
  if (state.step.meet_every > 0.0) stop = before(state.step.meet_every, stop);
  return stop;
}

}  // namespace driver
