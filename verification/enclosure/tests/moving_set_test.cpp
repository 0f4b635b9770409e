// SPDX-License-Identifier: Apache-2.0
#include "moving_set.hpp"

#include "known.hpp"

namespace {

using namespace test;
using enclosure::Balls;
using enclosure::Matrix;
using enclosure::MovingSet;

// A box that turns about the origin stays as it is, where a box around each box would grow by (|cos| +
// |sin|)^1000 = 1e13. After whole turns it contains its corners.
TEST(moving_set, turns_without_wrapping) {
  const double radius = 1e-9;
  MovingSet set({enclosure::wider(Ball(1.0), radius), enclosure::wider(Ball(2.0), radius)});
  Ball angle;
  arb_const_pi(angle.get(), enclosure::bits);
  angle = angle / Ball(100.0);
  Matrix turn(2);
  arb_sin_cos(turn.at(1, 0).get(), turn.at(0, 0).get(), angle.get(), enclosure::bits);
  turn.at(1, 1) = turn.at(0, 0);
  turn.at(0, 1) = Ball(0.0) - turn.at(1, 0);
  for (int i = 0; i < 1000; ++i) set.advance(turn * set.centre(), turn, {1.0, 1.0});
  const Balls box = set.box();
  EXPECT_TRUE(box[0].contains(Ball(1.0 + 0.999 * radius)));
  EXPECT_TRUE(box[0].contains(Ball(1.0 - 0.999 * radius)));
  EXPECT_TRUE(box[1].contains(Ball(2.0 + 0.999 * radius)));
  EXPECT_LT(box[0].radius(), 1.5 * radius);
}

// One direction shrinks by 1e-3 a step while the other stays: the set keeps both.
TEST(moving_set, keeps_contraction) {
  Matrix map(2);
  map.at(0, 0) = Ball(0.5005), map.at(0, 1) = Ball(0.4995);
  map.at(1, 0) = Ball(0.4995), map.at(1, 1) = Ball(0.5005);
  MovingSet set({enclosure::wider(Ball(1.0), 1e-6), enclosure::wider(Ball(1.0), 1e-6)});
  for (int i = 0; i < 20; ++i) set.advance(map * set.centre(), map, {1.0, 1.0});
  const Balls box = set.box();
  EXPECT_TRUE(box[0].contains(Ball(1.0 + 0.999e-6)));  // of (1, 1) direction
  EXPECT_LT(box[0].radius(), 3e-6);
}

// What is added widens.
TEST(moving_set, adds_an_interval) {
  MovingSet set({Ball(1.0), Ball(0.0)});
  set.add({enclosure::wider(Ball(0.5), 0.25), Ball(1.0)});
  EXPECT_TRUE(set.box()[0].contains(Ball(1.75)));
  EXPECT_TRUE(set.box()[0].contains(Ball(1.25)));
  EXPECT_TRUE(set.box()[1].contains(Ball(1.0)));
}

TEST(moving_set, inverse_of_a_singular_matrix_is_not_finite) {
  Matrix a(2);
  a.at(0, 0) = a.at(0, 1) = a.at(1, 0) = a.at(1, 1) = Ball(1.0);
  EXPECT_FALSE(enclosure::inverse(a).at(0, 0).is_finite());
}

}  // namespace
