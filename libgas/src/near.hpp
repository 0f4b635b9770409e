// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gas {

// Pressures closer to a switch than this, relative, are on it: some hundred roundings of p.
inline constexpr double kNear = 1e-12;

// A balance that is closer to p_a than this, relative, holds p; a hundred times what is on p_a.
inline constexpr double kHoldNear = 1e-10;

// The share of the flow at which p is let go is located to this.
inline constexpr double kShareNear = 1e-9;

}  // namespace gas
