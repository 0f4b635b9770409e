// SPDX-License-Identifier: Apache-2.0
// Elements that a line from a source may touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "kernel_table.hpp"
#include "scenes.hpp"

namespace {

/// Triangles that the way pierces downstream are among those listed: of patches that reach upstream, and of
/// those that do not, which are looked at in another way.
TEST(kernels, elements_on_the_way_are_listed) {
  scenes::Random random(11);
  const int patches = 200;
  const float u = 0.1f, v = 0.2f;  // v: slope, or place along the line
  std::vector<float> local(4 * 24 * patches), boxes(jet::kBoxFloats * patches);
  std::vector<std::uint32_t> corner_rows;
  std::vector<int> all(patches), near(all), uncertain(8 * patches + 8), between(uncertain),
      on_winding_ray(uncertain);
  std::iota(all.begin(), all.end(), 0);
  for (int i = 0; i < 24 * patches; ++i) {
    const auto row = static_cast<std::size_t>(4 * i);
    corner_rows.push_back(static_cast<std::uint32_t>(row));
    for (std::size_t j = 0; j < 2; ++j) local[row + j] = static_cast<float>(random.uniform(-0.5, 0.5));
    local[row + 2] = static_cast<float>(random.uniform(i / 24 % 2 == 0 ? -0.2 : 0.01, 0.8));
  }
  const auto pierced = [&](int place, bool line) {
    double x[3], y[3], w[3];  // of the corners beside the way
    for (int j = 0; j < 3; ++j) {
      const float* at = &local[corner_rows[static_cast<std::size_t>(place / 8 * 24 + 8 * j + place % 8)]];
      w[j] = at[2];
      x[j] = at[0] - u * w[j];
      y[j] = at[1] - v * (line ? 1.0 : w[j]);
    }
    const auto part = [&](int j, int k) { return x[j] * y[k] - x[k] * y[j]; };
    const double a = part(1, 2), b = part(2, 0), c = part(0, 1), depth = a * w[0] + b * w[1] + c * w[2];
    return ((a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0)) && depth / (a + b + c) > 0.0;
  };
  for (const jet::KernelTable* kernels : {&jet::baseline::kTable, &jet::kernel_table()}) {
    for (const float half_long : {0.0f, 0.3f}) {
      const std::vector<std::uint8_t> asked(patches);
      std::vector<std::uint8_t> inner(asked), not_inner(asked);
      const int found = kernels
                            ->classify_patches({local.data(),
                                                half_long,
                                                corner_rows.data(),
                                                8 * patches,
                                                all.data(),
                                                patches,
                                                0,
                                                asked.data(),
                                                0.0f,
                                                u,
                                                v,
                                                near.data(),
                                                boxes.data(),
                                                nullptr,
                                                inner.data(),
                                                not_inner.data(),
                                                uncertain.data(),
                                                between.data(),
                                                on_winding_ray.data(),
                                                nullptr})
                            .on_winding_ray;
      const std::vector<int> listed(on_winding_ray.begin(), on_winding_ray.begin() + found);
      int hits = 0;
      for (int place = 0; place < 8 * patches; ++place) {
        if (!pierced(place, half_long > 0.0f)) continue;
        ++hits;
        EXPECT_TRUE(std::binary_search(listed.begin(), listed.end(), place));
      }
      EXPECT_GT(hits, 8 * patches / 20);
      EXPECT_LT(found, 8 * patches);
    }
  }
}

}  // namespace
