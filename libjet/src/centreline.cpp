// SPDX-License-Identifier: Apache-2.0
#include "jet/centreline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jet {
namespace {
constexpr double kRoundDecay = 0.96;
constexpr double kRoundOffset = 0.29;
constexpr double kPlaneDecay = 1.2;
constexpr double kPlaneOffset = 0.41;
}  // namespace

double decay_coefficient(OutletType type) {
  constexpr double table[] = {0.066, 0.08, 0.12, 0.108, 0.118, 0.155};
  return table[static_cast<int>(type)];
}

double round_decay(double distance, double decay_coefficient) {
  return std::min(1.0, kRoundDecay / (decay_coefficient * distance + kRoundOffset));
}

double plane_decay(double distance, double decay_coefficient) {
  return std::min(1.0, kPlaneDecay / std::sqrt(decay_coefficient * distance + kPlaneOffset));
}

double round_core_length(double decay_coefficient) {
  return (kRoundDecay - kRoundOffset) / decay_coefficient;
}

double plane_core_length(double decay_coefficient) {
  return (kPlaneDecay * kPlaneDecay - kPlaneOffset) / decay_coefficient;
}

double round_virtual_origin(double decay_coefficient) {
  return kRoundOffset / decay_coefficient;
}

double plane_virtual_origin(double decay_coefficient) {
  return kPlaneOffset / decay_coefficient;
}

double round_momentum_width(double decay) {
  return std::numbers::sqrt2 / decay;
}

double plane_momentum_width(double decay) {
  return 2.0 * std::numbers::sqrt2 * std::numbers::inv_sqrtpi / (decay * decay);
}

}  // namespace jet
