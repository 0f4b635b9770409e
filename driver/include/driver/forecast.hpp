// SPDX-License-Identifier: Apache-2.0
// What will matter in a scene, by dimensionless groups of its case alone (docs/theory/forecast.md): vents
// choked (K.32), leak (K.33), sonic outlet (K.34), jet against pressure (K.35), gas against fabric (K.36),
// gas against step (K.37), mesh (K.38).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/scene.hpp"
#include "driver/state.hpp"

namespace driver {

/// What the inflators send in up to the scene's end, triggers taken to fire at 0.
struct Supply {
  double mass = 0.0;       // [kg]
  double peak_flow = 0.0;  // [kg/s] of all inflators together
  double work = 0.0;       // [J] sum of gamma R int mdot T dt
  std::vector<double> mass_fractions;
  double temperature = 0.0;  // [K] mean by mass
};

/// The gas of the full volume, or of the start where nothing flows in. What flows in may not fill it: then
/// there is no pressure of (K.31), and no group that refers to it.
struct FullState {
  double volume = 0.0;                        // [m3] as sewn, or at the start if that is more
  double closed_pressure = 0.0;               // [Pa] if nothing left, (K.30)
  bool fills = true;                          // the closed pressure is ambient at least, or nothing flows in
  double pressure = 0.0;                      // [Pa] with what the openings let out at the peak flow, (K.31)
  double vent_flow = 0.0, fabric_flow = 0.0;  // [kg/s] at that pressure
  double relaxation = 0.0;                    // [1/s] the faster rate of what flows out there, (G.14)
  double relaxations = 0.0;                   // [-] in the whole scene, (K.39)
  double gamma = 0.0;
};

/// A size from which an effect matters [-].
inline constexpr double kMatters = 0.1;

/// One group. A `size` is the share that an effect has in what drives the scene, and is judged; a number is
/// told as it is.
struct Group {
  std::string name;      // key in JSON
  const char* equation;  // tag in docs/theory
  std::string meaning;
  double value;
  bool is_size;
};

struct Forecast {
  Supply supply;
  std::optional<FullState> full;  // none without a volume of gas
  double step = 0.0;              // [s] at the start; 0: nothing steps
  std::vector<Group> groups;      // of what the scene has
};

/// Of that state. Throws gas::DomainError where the supply's gas leaves its range.
Forecast forecast(const Scene& scene, const State& state);

/// Sub-steps that the scene's gas method takes under error control for that many relaxations (K.39): an
/// explicit one goes to its limit, of each half where its error is by doubling. 0 for the implicit one and
/// for fixed sub-steps.
double gas_substeps(const Scene& scene, double relaxations);

/// To take the implicit gas method, if the explicit one is dear or ends the run; else empty.
std::string gas_advice(const Scene& scene, const Forecast& forecast);

/// "matters" from 0.1, "shows" from 0.01, else "negligible"; empty for a number.
const char* verdict(const Group& group);

}  // namespace driver
