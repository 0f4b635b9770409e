// SPDX-License-Identifier: Apache-2.0
#include "engine/drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/energy_terms.hpp"
#include "engine/impactor.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

// The shares of (M.22) and (M.24) were measured at 0.8 of the limit; `safety` is 0.95 by default.
constexpr double measured = 0.8 / 0.95;
constexpr double limit_growth = 1.01;  // of the limit in a step: a spring that has just opened closes again

// Sensible energies count from the internal energy at ambient temperature. p V is there because gas at that
// temperature has none.
double gas_scale(const State& state) {
  const Level& level = state.level;
  return std::max({level.flows.enthalpy_in - level.ambient.inflow,
                   std::abs(level.internal_energy - level.ambient.held),
                   state.gas_point.pressure * level.volume});
}

// That the limit of level n may draw on [J].
double energy_at_hand(const State& state) {
  const membrane::ForceSums& forces = state.bag->forces;
  return std::max({state.peaks.energy_scale, gas_scale(state), state.bag->advance.kinetic_after,
                   forces.strain_energy + forces.strap_energy + forces.plate_energy});
}

using Named = std::pair<const char*, double>;

Named largest(std::initializer_list<Named> list) {
  return *std::max_element(list.begin(), list.end(),
                           [](const Named& a, const Named& b) { return a.second < b.second; });
}

std::string governing_share(const State& state) {
  const membrane::StiffnessShares& s = state.step.share_sums;
  const double self = state.step.self_contact_sum;
  const Named governing = largest({{"fabric", s.element},
                                   {"gas", s.gas},
                                   {"contact", s.contact - self},
                                   {"self-contact", self},
                                   {"straps", s.strap},
                                   {"plate", s.plate}});
  return fmt::format("; on average {:.0f} % of the step's limit comes from the {}",
                     100.0 * governing.second / s.total(), governing.first);
}

// Where steps change the skin most.
std::string deformed_text(const Scene& scene, const State& state) {
  if (!state.bag) return "";
  const auto fastest = membrane::deformation_rate(scene.bag->model, *state.bag);
  if (!(fastest.rate * state.step.after > 0.01)) return "";
  return fmt::format("; element {} deforms fastest, by {:.2g} in a step", fastest.element,
                     fastest.rate * state.step.after);
}

// A step that should do: of second order, with a tenth to spare, where that still is what happens.
std::string shorter_step(const Scene& scene, const State& state, double drift) {
  const double ratio = 0.9 * std::sqrt(kDriftWarned / drift);
  if (!scene.time.step && ratio < 0.05)
    return "; a smaller time.safety will hardly help: check the mesh (gasjet mesh convert --report)";
  if (!scene.time.step) return fmt::format("; try time.safety = {:.2g}", ratio * scene.time.safety);
  const double deformed = membrane::kLargestDeformation / std::max(state.step.deformation, 1e-300);
  return fmt::format("; try time.step = {:.2g}, or leave it out",
                     std::min(ratio, deformed) * *scene.time.step);
}

// With as many digits as show that it is above the limit.
std::string above_limit(double drift) {
  for (int digits = 2; digits < 17; ++digits)
    if (const std::string text = fmt::format("{:.{}g}", drift, digits); std::stod(text) > kDriftWarned)
      return text;
  return fmt::format("{}", drift);
}

}  // namespace

// Of a skin strained by 1e-6. Below, a drift is that of rounding, or of a load that has just begun.
double smallest_energy(const Scene& scene) {
  if (!scene.bag) return 0.0;
  double stiffness = 0.0;
  for (const membrane::ElementStiffness& e : scene.bag->model.stiffness)
    stiffness += e.volume * e.factor(0, 0) * e.factor(0, 0);
  return 0.5e-12 * stiffness;
}

double energy_scale(const Scene& scene, const State& state) {
  const double kinetic = sum_of(Role::kinetic, scene, state), elastic = sum_of(Role::elastic, scene, state);
  return std::max({gas_scale(state), kinetic, std::abs(impactor_weight(scene, state)), elastic,
                   state.start.smallest_energy});
}

double mechanical_energy(const Scene& scene, const State& state) {
  return sum_of(Role::kinetic, scene, state) + sum_of(Role::elastic, scene, state) +
         std::abs(impactor_weight(scene, state));
}

double mechanical_drift(const State& state) {
  const Peaks& peaks = state.peaks;
  return peaks.mechanical > 0.0 ? peaks.energy_residual / peaks.mechanical : 0.0;
}

double energy_drift(const State& state) {
  const Peaks& peaks = state.peaks;
  return peaks.energy_scale > 0.0 ? peaks.energy_residual / peaks.energy_scale : peaks.energy_residual;
}

double drift_limit(const Scene& scene, const State& state) {
  if (!state.bag) return std::numeric_limits<double>::infinity();
  const membrane::BagModel& model = scene.bag->model;
  if (!scene.gas) return measured * membrane::bounce_time_step(model);
  const bool start = state.step.before == 0.0;
  const double mobility = start ? membrane::force_mobility(model, *state.bag) : state.step.force_mobility;
  return std::min(
      measured * membrane::energy_time_step(model, *state.bag, energy_at_hand(state), mobility, start),
      limit_growth * state.step.drift_limit);
}

double kink_limit(const Scene& scene, const State& state) {
  constexpr double share = 1e-3;
  const double kinks = state.skin_contact.kink_energy;
  if (!scene.skin_contact || !(kinks > 0.0)) return std::numeric_limits<double>::infinity();
  const double energy = std::max(energy_at_hand(state), state.start.smallest_energy);
  return state.step.before * std::sqrt(8.0 * share * energy / kinks);
}

std::string drift_text(const Scene& scene, const State& state) {
  const double drift = energy_drift(state);
  const LargestTerm& term = state.peaks.largest_term;
  std::string text =
      fmt::format("the energy drifts by {} of its value (residual.energy_rel), the limit is {:g}",
                  above_limit(drift), kDriftWarned);
  if (const double share = mechanical_drift(state); share > 0.0)
    text += fmt::format("; by {:.3g} J, {:.2g} % of the mechanical energy", state.peaks.energy_residual,
                        100.0 * share);
  text += fmt::format("; largest term that the step integrates: {}, {:.3g} J", term.name, term.magnitude);
  if (state.step.share_sums.total() > 0.0) text += governing_share(state);
  if (!scene.moves()) return text;
  return text + deformed_text(scene, state) + shorter_step(scene, state, drift);
}

}  // namespace driver
