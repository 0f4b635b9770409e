// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "second_route.hpp"

namespace {

TEST(enclosure, contains_second_route_of_thousand_random_scenes) {
  const test::Tally tally = test::expect_tubes_contain(1, 1150);
  std::cout << tally.compared << " compared, " << tally.refused << " refused, " << tally.stiff
            << " too stiff\n";
  EXPECT_GE(tally.compared, 1000);
}

}  // namespace
