// SPDX-License-Identifier: Apache-2.0
// Forecast of what matters in a scene, from dimensionless groups of its case (docs/theory/forecast.md): vents
// choked (K.32), leak (K.33), sonic outlet (K.34), jet against pressure (K.35), gas against fabric (K.36),
// gas against step (K.37), mesh (K.38).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/supply.hpp"
#include "forecast/full_state.hpp"

namespace driver {

/// Size [-] above which an effect matters.
inline constexpr double kMatters = 0.1;

/// One group. If `is_size`, its value is the share of an effect in what drives the scene, and it gets a
/// verdict. Otherwise it is only a number to report.
struct Group {
  std::string name;      // key in JSON
  const char* equation;  // tag in docs/theory
  std::string meaning;
  double value;
  bool is_size;
};

/// Forecast of one scene.
struct Forecast {
  Supply supply;
  std::optional<FullState> full;  // empty without a volume of gas
  /// [s] at the start; 0 if nothing takes steps.
  double step = 0.0;
  std::vector<Group> groups;  // groups that apply to the scene
};

/// Forecast for a scene in `state`. Throws gas::DomainError if the supply's gas leaves its temperature range.
Forecast forecast(const Scene& scene, const State& state);

/// Sub-steps of the scene's gas method, under error control, for this many relaxations (K.39). Explicit
/// methods step at their stability limit (with step doubling, each half step does). 0 for the implicit method
/// and for fixed sub-steps.
double gas_substeps(const Scene& scene, double relaxations);

/// Advice to use the implicit gas method, if the explicit one is expensive or ends the run; else empty.
std::string gas_advice(const Scene& scene, const Forecast& forecast);

/// cp/cv of the gas at the start [-]; for an empty volume, of the gas that fills it; 0 for a scene without a
/// volume of gas.
double gamma_at_start(const State& state, const Forecast& f);

/// Verdict on a size: "matters" from 0.1, "shows" from 0.01, else "negligible"; empty for a number.
const char* verdict(const Group& group);

}  // namespace driver
