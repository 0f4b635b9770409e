// SPDX-License-Identifier: Apache-2.0
#include "second_route.hpp"

namespace {

TEST(enclosure, contains_second_route_of_random_scenes) {
  EXPECT_EQ(test::expect_tubes_contain(1, 2).compared, 2);
  EXPECT_EQ(test::expect_tubes_contain(5, 6).compared, 2);
}

}  // namespace
