// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

namespace gas {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();  // stands for a time that never
                                                                              // comes
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();    // relative rounding
// Relative round-off of an energy after some hundred operations. Energies this close to an end of the range
// count as its end.
inline constexpr double kEnergyRoundOff = 2e-14;

}  // namespace gas
