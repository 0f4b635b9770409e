// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "gas/integrator.hpp"
#include "plain_route.hpp"

namespace random_tanks {

gas::ControlVolumeModel model_of(const Tank& tank);

/// A run by libgas.
struct Computed {
  std::vector<Sample> samples;  // at the start and at the end of each call
  double balance =
      0.0;  // residual of mass or energy of a call, the largest, over the sum of the terms' magnitudes
  std::string refusal;      // what the DomainError says; empty: none
  double refused_at = 0.0;  // its time [s]
};
Computed libgas_route(const Tank& tank);

}  // namespace random_tanks
