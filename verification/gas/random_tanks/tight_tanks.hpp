// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "tank.hpp"

namespace random_tanks {

/// Tanks in which every law acts, at a tolerance of 1e-13.
std::vector<Tank> tight_tanks();

}  // namespace random_tanks
