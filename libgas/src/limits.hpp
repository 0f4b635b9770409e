// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

namespace gas {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();  // a time that never comes
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();    // of rounding, relative
// Of an energy, relative: some hundred operations. What is so close to an end of the range is there.
inline constexpr double kEnergyRoundOff = 2e-14;

}  // namespace gas
