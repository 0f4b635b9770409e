// SPDX-License-Identifier: Apache-2.0
// Proved bounds of a tank over time (docs/theory/enclosure.md).
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "enclosure/scene.hpp"

namespace enclosure {

/// What cannot be enclosed. The message has the reason.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A proved interval.
struct Bounds {
  double lower, upper;                 // rounded outward
  std::string lower_text, upper_text;  // decimal, rounded outward, to two digits beyond the common ones
};

/// Bounds at one time; one for each column.
struct Moment {
  double time;  // [s], exact
  std::vector<Bounds> bounds;
};

/// The tube of a scene.
struct Tube {
  std::vector<std::string> columns;  // as a history has them (docs/results.md)
  std::vector<Moment> moments;       // as asked for
  long steps = 0;                    // by Taylor series
  long crossings = 0;                // steps across a switch or an uncertain time
};

/// What is asked for.
struct Request {
  std::vector<double> times;  // [s] >= 0, rising
  double width = 1e-12;    // [-] of an interval, relative to the value; of masses, to the gas and what flowed
  double longest = 600.0;  // [s] of computing, of the process's time
};

/// Encloses pressure, temperature, volume, mass, mass of each species and of each stream since the start at
/// the requested times. Throws std::invalid_argument for a scene or request out of range, and Refusal for one
/// that cannot be enclosed.
Tube enclose(const Scene& scene, const Request& request);

}  // namespace enclosure
