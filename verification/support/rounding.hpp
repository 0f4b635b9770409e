// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace support {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

}  // namespace support
