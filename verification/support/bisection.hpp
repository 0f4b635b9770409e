// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

namespace claim {

// Largest value for which `passes` holds, halfway between two values less than the share `width` apart.
// Expects it to hold at `low` and not at `high` > low > 0; between them it has to change once.
template <class Passes>
double largest_passing(double low, double high, double width, Passes&& passes) {
  EXPECT_TRUE(passes(low)) << low;
  EXPECT_FALSE(passes(high)) << high;
  while (high > low * (1.0 + width)) {
    const double middle = 0.5 * (low + high);
    (passes(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace claim
