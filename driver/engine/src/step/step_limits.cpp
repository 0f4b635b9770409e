// SPDX-License-Identifier: Apache-2.0
#include "step/step_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.hpp"
#include "engine/stages.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

// What makes the bag stiff, largest first; shares below half a per cent are left out.
std::string shares_text(const Scene& scene, const State& state) {
  const membrane::StiffnessShares& s = state.step.shares;
  const double self = state.step.self_contact;
  std::vector<std::pair<double, const char*>> shares{{s.element, "fabric"},         {s.gas, "gas"},
                                                     {s.contact - self, "contact"}, {self, "self-contact"},
                                                     {s.strap, "straps"},           {s.plate, "plate"}};
  std::ranges::sort(shares, std::greater{}, &std::pair<double, const char*>::first);
  std::string text;
  for (const auto& [share, name] : shares)
    if (const double percent = 100.0 * share / s.total(); percent >= 0.5)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name, percent);
  if (s.element >= 0.005 * s.total())
    text += fmt::format("; stiffest element {}", membrane::governing_element(scene.bag->model, *state.bag));
  const double rate = 0.5 * state.step.critical;
  if (const double percent = 100.0 * rate * s.damping; percent >= 0.5)
    text += fmt::format("; stiffness damping shortens it by up to {:.0f} %", percent);
  if (const double percent = 100.0 * rate * state.step.jet_damping; percent >= 0.5)
    text += fmt::format("; jets relative to the skin shorten it by up to {:.0f} %", percent);
  return text;
}

// Why the gas, if it is that, lets the skin collapse.
std::string collapse(const Scene& scene, const State& state) {
  if (!scene.has_volume() || state.gas_point.pressure >= 0.01 * scene.ambient.pressure) return "";
  return fmt::format(
      "; the skin collapses, as {:.3g} Pa of gas do not bear the {:.3g} Pa outside: look at "
      "gas.initial.pressure, the areas of vents and the porosity, and at their units",
      state.gas_point.pressure, scene.ambient.pressure);
}

constexpr const char* lower_self_contact =
    "; lower membrane.self_contact.stiffness or membrane.self_contact.stiffness_share";

// The key that lengthens the step most.
std::string advice(const State& state) {
  const membrane::StiffnessShares& s = state.step.shares;
  const double self = state.step.self_contact, sphere = s.contact - self;
  const double most = std::max({s.element, s.gas, sphere, self, s.strap, s.plate});
  if (sphere == most) return "; lower contact.stiffness or contact.stiffness_share";
  if (self == most) return lower_self_contact;
  if (s.strap == most) return "; lower membrane.strap.stiffness";
  if (s.plate == most) return "; lower membrane.plate.stiffness";
  if (s.gas == most) return "; the gas is stiff in so small a volume: begin with a larger one";
  return "; look at the size and shape of that element, and at fabric.young_modulus and its unit";
}

// Which limit it is, and what to do.
std::string cause_of_short_step(const Scene& scene, const State& state) {
  const StepSizes& step = state.step;
  if (step.after * 1.01 >= approach_limit(scene, state))
    return fmt::format(
        " for layers of the skin, which close by {:.3g} of the thickness in a step (K.47); a larger "
        "membrane.self_contact.thickness allows longer steps",
        state.skin_contact.approach * step.after / step.before);
  const bool shortened = step.after * 1.01 < std::min(step.steady, scene.time.safety * step.drift_limit);
  if (shortened && step.after * 1.01 >= step.touching)
    return std::string(" for layers of the skin that touch or may soon (K.46, K.48)") + lower_self_contact;
  if (shortened)
    return fmt::format(
        " for element {}, which deforms at {:.3g} 1/s (M.32); look at the mesh there, and at what loads it",
        step.deformed_element, membrane::kLargestDeformation / step.after);
  if (step.drift_limit < step.critical)
    return " for the energy to drift little (M.22); look at what loads the skin";
  return fmt::format(" ({}){}", shares_text(scene, state), advice(state));
}

}  // namespace

double approach_limit(const Scene& scene, const State& state) {
  if (!scene.skin_contact || !(state.skin_contact.approach > 0.0) || !(state.step.before > 0.0))
    return std::numeric_limits<double>::infinity();
  return kLargestApproach * state.step.before / state.skin_contact.approach;
}

void refuse_step(const Scene& scene, const State& state, double given) {
  std::string cause = state.pendulum ? "the pendulum's swing" : "the springs of the impactor's rail";
  if (state.bag) cause = shares_text(scene, state);
  throw StepError(fmt::format(
      "time.step = {:.3g} s is unstable: the limit is {:.3g} s ({}). Lower time.step, leave it out, or "
      "set time.unsafe_step = true",
      given, three_digits_below(state.step.critical), cause));
}

void refuse_short_step(const Scene& scene, const State& state) {
  const std::string cause = state.bag ? cause_of_short_step(scene, state) + collapse(scene, state) : "";
  throw StepError(fmt::format(
      "more than 1e9 steps of {:.3g} s are left to end_time = {:.3g} s; so short a step is needed{}",
      state.step.after, scene.time.end, cause));
}

}  // namespace driver
