// SPDX-License-Identifier: Apache-2.0
// What the kernels say of small triangles close to a ray is true, and they say it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernel_table.hpp"
#include "scenes.hpp"

namespace {

/// A segment from (0, y, 0) to `target`, and a triangle that its line passes at the distance `gap` from one
/// edge, inside or outside, before or behind the target.
struct Pass {
  Eigen::Vector3d target, corners[3];
  bool inside, before;
  double gap;
};

constexpr double kSize = 1e-3;  // of the triangles, over the largest coordinate

Pass random_pass(scenes::Random& random, double half_long) {
  Pass p;
  p.target = random.vector(0.3);
  p.target.z() = 0.6 + random.vector(0.3).x();
  const Eigen::Vector3d source(0.0, std::clamp(p.target.y(), -half_long, half_long), 0.0);
  const Eigen::Vector3d along = p.target - source, first = along.cross(random.vector(1.0)).normalized(),
                        second = along.cross(first).normalized();
  p.inside = random.vector(1.0).x() > 0.0;
  p.before = random.vector(1.0).x() > 0.0;
  p.gap = kSize * std::pow(10.0, -3.0 + 3.0 * random.vector(1.0).x());
  const Eigen::Vector3d at = source + ((p.before ? 0.5 : 1.4) + random.vector(0.2).x()) * along;
  const auto tilt = [&] { return random.vector(kSize).x() * along; };
  p.corners[0] = at + p.gap * first - kSize * second + tilt();
  p.corners[1] = at + p.gap * first + kSize * second + tilt();
  p.corners[2] = at + (p.inside ? -kSize : p.gap + kSize) * first + tilt();
  return p;
}

TEST(kernels, what_is_certain_of_segments_and_small_triangles_is_true) {
  for (const double half_long : {0.0, 0.2}) {
    scenes::Random random(43);
    const int count = 20000;
    std::vector<Pass> passes;
    std::vector<float> targets, nodes;
    const auto append = [](const Eigen::Vector3d& x, std::vector<float>& to) {
      for (int i = 0; i < 3; ++i) to.push_back(static_cast<float>(x[i]));
      to.push_back(0.0f);
    };
    for (int k = 0; k < count; ++k) {
      passes.push_back(random_pass(random, half_long));
      append(passes.back().target, targets);
      for (const Eigen::Vector3d& x : passes.back().corners) append(x, nodes);
    }
    std::vector<int> rays(count);
    std::iota(rays.begin(), rays.end(), 0);
    std::vector<std::uint32_t> corner_rows;
    for (unsigned i = 0; i < 3 * count; ++i)
      corner_rows.push_back(4 * (3 * (i / 24 * 8 + i % 8) + i / 8 % 3));
    std::vector<std::uint8_t> blocked(count / 8), pierced(blocked), apart(blocked), missed(blocked);
    for (const jet::KernelTable* kernels : {&jet::baseline::kTable, &jet::kernel_table()}) {
      kernels->meet_pairs(
          {targets.data(), nodes.data(), static_cast<float>(half_long), corner_rows.data(), rays.data(),
           rays.data(), blocked.data(), pierced.data(), apart.data(), missed.data()},
          count);
      for (int k = 0; k < count; ++k) {
        const auto says = [&](const std::vector<std::uint8_t>& bits) {
          return (bits[static_cast<std::size_t>(k / 8)] >> k % 8 & 1) != 0;
        };
        const Pass& p = passes[static_cast<std::size_t>(k)];
        const bool blocks = p.inside && p.before;
        EXPECT_FALSE(says(blocks ? apart : blocked)) << k;
        EXPECT_FALSE(says(p.inside ? missed : pierced)) << k;
        // Slopes are below 1.5, so places err by 5e-7 (1 + 1.5) (1 + 1.6) at most, times 6 and the size twice
        // over an edge of two sizes, seen shorter by the slope: a twentieth of the size is enough.
        if (p.gap > 0.05 * kSize) {
          EXPECT_TRUE(says(blocks ? blocked : apart)) << k;
          EXPECT_TRUE(says(p.inside ? pierced : missed)) << k;
        }
      }
    }
  }
}

}  // namespace
