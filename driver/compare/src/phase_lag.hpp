// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

namespace driver {

/// Delay [s] of `mine`: the shift, of at most a quarter of the window, with the smallest mean square
/// difference from `reference` over the overlap. Empty if one of the signals is constant, if no such shift
/// brings them closer, or if there are fewer than 8 rows.
std::optional<double> phase_lag(std::span<const double> time, std::span<const double> mine,
                                std::span<const double> reference);

}  // namespace driver
