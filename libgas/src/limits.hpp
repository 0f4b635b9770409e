// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

namespace gas {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();  // a time that never comes
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();    // of rounding, relative

}  // namespace gas
