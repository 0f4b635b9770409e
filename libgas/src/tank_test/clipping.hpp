// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "tank_test/identify.hpp"

namespace gas {

/// Where a gauge is cut off at the end of its range: many readings equal the largest one, and hardly any the
/// next lower one. A smooth peak of rounded readings has 2.4 times as many at the top at most.
///
/// A pressure that rests at the end of the record is no such place: it comes to rest slowly, and readings
/// scatter there as before. A flow that stops at once looks like a gauge that is cut off, and is taken for
/// one, if readings do not scatter at all.
std::optional<Clipping> find_clipping(std::span<const double> times, std::span<const double> readings);

}  // namespace gas
