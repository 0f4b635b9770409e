// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "membrane/bag_model.hpp"

namespace membrane {

// Shares of model.shares tuned to the reference shape, from own masses (set before, like node_mass), and
// fabric_frequency.
void tune_shares_as_sewn(BagModel& model);

}  // namespace membrane
