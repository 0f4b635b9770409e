// SPDX-License-Identifier: Apache-2.0
#include "jet/centreline.hpp"

#include "field/centreline_formulas.hpp"
#include "refuse.hpp"

namespace jet {

using namespace formulas;

double decay_coefficient(OutletType type) {
  constexpr double table[] = {0.066, 0.08, 0.12, 0.108, 0.118, 0.155};
  if (static_cast<int>(type) < 0 || type > OutletType::rounded_slot)
    refuse_value("outlet type", static_cast<double>(type), "an enumerator");
  return table[static_cast<int>(type)];
}

double round_decay(double distance, double decay_coefficient) {
  return formulas::round_decay(distance, decay_coefficient);
}

double plane_decay(double distance, double decay_coefficient) {
  return formulas::plane_decay(distance, decay_coefficient);
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
  return formulas::round_momentum_width(decay);
}

double plane_momentum_width(double decay) {
  return formulas::plane_momentum_width(decay);
}

}  // namespace jet
