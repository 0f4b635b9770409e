// SPDX-License-Identifier: Apache-2.0
// A level of a skin in contact with itself allocates nothing once its lists have their size, unless groups
// are paired anew.
#include <gtest/gtest.h>

#include <cmath>

#include "skin_scenes.hpp"
#include "support/allocation_counter.hpp"

namespace {

TEST(SkinContactAllocation, most_levels_after_the_first_swing_allocate_nothing) {
  const scenes::Skin skin = scenes::two_plates(12, 11, 0.6, 0.03);
  const auto model = scenes::skin_contact(skin, 0.01, 1e6, 0.3);
  auto state = model.make_state();
  Eigen::Matrix4Xd padded = Eigen::Matrix4Xd::Zero(4, skin.nodes.cols()), forces = padded;
  int touching = 0, allocating = 0;
  const auto swing = [&] {  // two periods
    touching = allocating = 0;
    for (int n = 0; n < 252; ++n) {
      const double t = 0.05 * n;
      padded.topRows<3>() = skin.nodes;
      padded.row(2).tail(144).setConstant(0.011 + 0.004 * std::cos(t));
      padded.row(0).tail(144).array() += 0.002 * std::sin(2.0 * t);
      const long before = support::allocations();
      touching += model.evaluate(state, padded.topRows<3>(), forces.topRows<3>()).contacts > 0;
      allocating += support::allocations() != before;
    }
  };
  swing();
  ASSERT_GT(support::allocations(), 0);  // the counter counts
  swing();
  EXPECT_LE(allocating, 84);  // a third: where near groups are paired anew, as looks get dear
  EXPECT_GT(touching, 50);
  EXPECT_LT(touching, 200);
}

}  // namespace
