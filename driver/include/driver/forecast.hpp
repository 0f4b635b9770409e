// SPDX-License-Identifier: Apache-2.0
// Forecast of what matters in a scene, from dimensionless groups of its case alone (docs/theory/forecast.md):
// vents choked (K.32), leak (K.33), sonic outlet (K.34), jet against pressure (K.35), gas against fabric
// (K.36), gas against step (K.37), mesh (K.38).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/scene.hpp"
#include "driver/state.hpp"

namespace driver {

/// Supply of the inflators up to the scene's end, as if every trigger came on at 0.
struct Supply {
  double mass = 0.0;       // [kg]
  double peak_flow = 0.0;  // [kg/s] of all inflators together
  double work = 0.0;       // [J] sum of gamma R int mdot T dt
  std::vector<double> mass_fractions;
  double temperature = 0.0;  // [K] mean by mass
};

/// Gas in the full volume, or at the start if nothing flows in. If the supply does not fill the volume, there
/// is no pressure of (K.31), and no group that uses it.
struct FullState {
  double volume = 0.0;           // [m3] as sewn, or at the start if that is larger
  double closed_pressure = 0.0;  // [Pa] if nothing flowed out (K.30)
  /// True if the closed pressure is at least ambient, or nothing flows in.
  bool fills = true;
  /// [Pa] The closed pressure or, if lower, that at which the openings let out the peak flow (K.31).
  double pressure = 0.0;
  double vent_flow = 0.0, fabric_flow = 0.0;  // [kg/s] at that pressure
  /// [1/s] Faster relaxation rate of the outflow at that pressure (G.14).
  double relaxation = 0.0;
  double relaxations = 0.0;  // [-] in the whole scene (K.39)
  double gamma = 0.0;
};

/// Size [-] from which an effect matters.
inline constexpr double kMatters = 0.1;

/// One group. If `is_size`, its value is the share of an effect in what drives the scene, and it is judged.
/// Else the value is a number to report.
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
  std::optional<FullState> full;  // none without a volume of gas
  /// [s] At the start; 0: nothing takes steps.
  double step = 0.0;
  std::vector<Group> groups;  // those that apply to the scene
};

/// Forecast for a scene in `state`. Throws gas::DomainError if the supply's gas leaves its temperature range.
Forecast forecast(const Scene& scene, const State& state);

/// Sub-steps that the scene's gas method takes, under error control, for this many relaxations (K.39). An
/// explicit method goes to its stability limit, for each half step if its error is by step doubling. 0 for
/// the implicit method and for fixed sub-steps.
double gas_substeps(const Scene& scene, double relaxations);

/// Advice to use the implicit gas method, if the explicit one is expensive or ends the run; else empty.
std::string gas_advice(const Scene& scene, const Forecast& forecast);

/// Verdict on a size: "matters" from 0.1, "shows" from 0.01, else "negligible"; empty for a number.
const char* verdict(const Group& group);

}  // namespace driver
