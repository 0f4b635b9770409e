// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gas {

// Pressures closer to a switch than this, relative, are on it: some hundred roundings of p.
inline constexpr double kNear = 1e-12;

}  // namespace gas
