// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "random_rows.hpp"

// 10,440 rows, some 30,000 values.
TEST(printed_long, digits_are_right_at_random_parameters) {
  const auto count = test::expect_printed_at_random(120, 2);
  EXPECT_GT(count.values, 25000);
  EXPECT_LT(count.shortened, count.values / 50);
}
