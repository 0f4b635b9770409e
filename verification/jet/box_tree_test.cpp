// SPDX-License-Identifier: Apache-2.0
// Boxes of the tree that serves rays without a frustum.
#include <gtest/gtest.h>

#include "scenes.hpp"
#include "visibility/sides.hpp"

namespace {

/// A segment that begins on or in a box meets it without any rounding; far from the origin boxes are a few
/// ulps wide.
TEST(box, segment_that_meets_it_is_never_apart) {
  scenes::Random random(1);
  int apart = 0;
  for (const double shift : {0.0, 1e3, 1e6, 1e9}) {
    for (int i = 0; i < 20000; ++i) {
      double nodes[9];
      for (double& x : nodes) x = shift + random.uniform(-0.1, 0.1);
      const std::array<int, 3> triangle{0, 1, 2};
      const jet::Role role{};
      jet::Box box({nodes, 3, &triangle, &role, 1, 3}, 0);
      if (i % 3 == 0) box.high[0] = box.low[0];  // flat
      jet::blocking::Ray ray{{}, {}, nullptr, jet::blocking::Moved::no};
      const Eigen::Vector3d way = random.vector(1.0);
      for (int k = 0; k < 3; ++k) {
        const double place = i % 2 == 0 ? random.uniform() : random.integer(0, 1);
        ray.source[k] = std::clamp(box.low[k] + place * (box.high[k] - box.low[k]), box.low[k], box.high[k]);
        ray.target[k] = ray.source[k] + (i % 5 == k ? 0.0 : way[k]);
      }
      EXPECT_FALSE(box.apart_from_line(ray, shift + 0.1)) << shift << " " << i;
      for (int k = 0; k < 3; ++k) {
        ray.source[k] = shift + random.uniform(-1.0, 1.0);
        ray.target[k] = shift + random.uniform(-1.0, 1.0);
      }
      apart += box.apart_from_line(ray, shift + 0.1) && !box.apart_from_segment(ray);
    }
  }
  EXPECT_GT(apart, 10000);  // what the lines say beyond the boxes of the segments
}

}  // namespace
