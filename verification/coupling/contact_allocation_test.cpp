// SPDX-License-Identifier: Apache-2.0
// No allocation inside a step.
#include <gtest/gtest.h>

#include "scenes.hpp"
#include "support/allocation_counter.hpp"

namespace {

TEST(ContactAllocation, evaluate_and_advance_allocate_nothing) {
  using scenes::kRadius;
  const auto skin = scenes::plate(30, 0.4 * kRadius);
  const auto model = scenes::contact(skin, kRadius, 1e8);
  const coupling::PendulumModel pendulum(scenes::paper_pendulum());
  auto state = model.make_state();
  Eigen::Matrix4Xd nodes = Eigen::Matrix4Xd::Zero(4, skin.nodes.cols()), forces = nodes;
  nodes.topRows<3>() = skin.nodes;
  coupling::PendulumState swing{0.0, 1.0};
  const long before = support::allocations();
  ASSERT_GT(before, 0);  // the counter counts
  int touching = 0;
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector3d centre(0.2 * std::sin(0.02 * n), 0.0, kRadius * (1.5 + 0.9 * std::sin(0.05 * n)));
    const auto t = model.evaluate(state, nodes.topRows<3>(), {centre}, forces.topRows<3>());
    touching += t.deepest_element >= 0;
    swing = pendulum.advance(swing, pendulum.moment(t.force, centre), 1e-9, 1e-9);
  }
  EXPECT_EQ(support::allocations(), before);
  EXPECT_GT(touching, 50);
  EXPECT_GT(state.looks, 2 * model.element_count());
}

}  // namespace
