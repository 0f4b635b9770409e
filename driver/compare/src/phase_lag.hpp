// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

namespace driver {

/// Time [s] by which `mine` is late: the shift of at most a quarter of the window that brings it nearest to
/// `reference`, in the mean square over the overlap. There is none if one of the signals does not change, if
/// no such shift brings them nearer, or if there are fewer than 8 rows.
std::optional<double> phase_lag(std::span<const double> time, std::span<const double> mine,
                                std::span<const double> reference);

}  // namespace driver
