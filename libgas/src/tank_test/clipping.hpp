// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "tank_test/identify.hpp"

namespace gas {

/// Finds where a gauge is cut off at the end of its range: many readings equal the largest one, and hardly
/// any equal the next lower value. At a smooth peak of rounded readings the ratio is at most 2.4.
///
/// A pressure that comes to rest at the end of the record does not count: it does so slowly, and its readings
/// still scatter. If readings do not scatter at all, a flow that stops at once is mistaken for a cut-off
/// gauge.
std::optional<Clipping> find_clipping(std::span<const double> times, std::span<const double> readings);

}  // namespace gas
