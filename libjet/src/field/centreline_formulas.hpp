// SPDX-License-Identifier: Apache-2.0
// Formulas of centreline.hpp for decay and width, for one point (T = double) or for lanes of points.
#pragma once

#include <cmath>
#include <numbers>

namespace jet::formulas {

inline constexpr double kRoundDecay = 0.96;
inline constexpr double kRoundOffset = 0.29;
inline constexpr double kPlaneDecay = 1.2;
inline constexpr double kPlaneOffset = 0.41;

inline double min(double a, double b) {
  return b < a ? b : a;
}
inline double max(double a, double b) {
  return a < b ? b : a;
}

template <class T>
T round_decay(T distance, double decay_coefficient) {
  return min(T(1.0), kRoundDecay / (kRoundOffset + decay_coefficient * distance));
}

template <class T>
T plane_decay(T distance, double decay_coefficient) {
  using std::sqrt;
  return min(T(1.0), kPlaneDecay / sqrt(kPlaneOffset + decay_coefficient * distance));
}

template <class T>
T round_momentum_width(T decay) {
  return std::numbers::sqrt2 / decay;
}

template <class T>
T plane_momentum_width(T decay) {
  return 2.0 * std::numbers::sqrt2 * std::numbers::inv_sqrtpi / (decay * decay);
}

}  // namespace jet::formulas
