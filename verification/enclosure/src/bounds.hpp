// SPDX-License-Identifier: Apache-2.0
// A ball as two decimal numbers.
#pragma once

#include "ball.hpp"
#include "enclosure/enclose.hpp"

namespace enclosure {

/// Lower and upper end, rounded outward: as doubles and as decimals.
Bounds bounds(const Ball& ball);

}  // namespace enclosure
