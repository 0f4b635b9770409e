// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "membrane/bag_model.hpp"

namespace membrane {

// Tunes model.shares to the reference shape and sets fabric_frequency. Preconditions: each element's shares
// are its own mass, and node_mass is set.
void tune_shares_as_sewn(BagModel& model);

}  // namespace membrane
