// SPDX-License-Identifier: Apache-2.0
// Bounds of rays, rays that part since their bounds together hold too much, and what a ray meets of its own
// patch.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/pyramid.hpp"

namespace {

const jet::KernelTable* const kBoth[] = {&jet::baseline::kTable, &jet::kernel_table()};

/// Targets on both sides of a line's ends, and at them: bounds hold the rays as far as coordinates of 2, and
/// are not far from them.
TEST(kernels, bounds_of_rays_from_a_line_follow_its_ends) {
  const double half_long = 0.0625;
  for (const jet::KernelTable* kernels : kBoth) {
    for (const double beyond : {-0.03, -1e-6, -1e-8, 0.0, 1e-8, 1e-6, 0.003, 0.4}) {
      for (const double side : {-1.0, 1.0}) {
        for (const auto& [u, w] : {std::pair{0.0, 0.3}, {0.3, 0.3}, {-0.5, 0.01}, {0.001, 0.0005}}) {
          const double v = side * (half_long + beyond), from = std::clamp(v, -half_long, half_long);
          const Eigen::Matrix3Xd nodes = Eigen::Vector3d(u, v, w).replicate(1, 3);
          const int triangle[] = {0, 1, 2}, element[] = {0};
          jet::ProjectArrays a{};
          a.nodes = {nodes.data(), 3, 2, {u, v, w, 0.0}};
          for (int i = 0; i < 3; ++i) a.column[i][i] = 1.0;
          a.triangles = triangle;
          a.elements = element;
          const jet::Frustum found = kernels->frustum_of(a, static_cast<float>(half_long), 1);
          const double way = 2.0 * (v - from) / std::max(w, std::abs(u)), margin = 2e-5 / (w + std::abs(u));
          EXPECT_LE(found.low_v, from + std::min(way, 0.0));
          EXPECT_GE(found.high_v, from + std::max(way, 0.0));
          EXPECT_GE(found.low_v, from + 2.02 * std::min(way, 0.0) - margin) << "v " << v;
          EXPECT_LE(found.high_v, from + 2.02 * std::max(way, 0.0) + margin) << "v " << v;
        }
      }
    }
  }
}

using Pair = std::pair<int, int>;  // a ray and an element

/// Rays to two places before a plate of a thousand blocks meet together what they meet apart. Where their
/// elements are far from each other in the mesh they part.
TEST(kernels, rays_to_elements_far_from_each_other_part) {
  const int side = 64, blocks = side * side / 4;
  std::vector<float> local, targets;
  std::vector<std::uint32_t> corner_rows;
  for (int block = 0; block < blocks; ++block) {  // 2 x 2 cells of two triangles
    for (int corner = 0; corner < 3; ++corner) {
      for (int i = 0; i < 8; ++i) {
        const int x = 2 * (block % (side / 2)) + i / 2 % 2, y = 2 * (block / (side / 2)) + i / 4;
        const int corners[3][2] = {{x + i % 2, y + i % 2}, {x + 1, y}, {x, y + 1}};
        const auto place = [&](int axis) {
          return static_cast<float>(corners[corner][axis]) / static_cast<float>(side) - 0.5f;
        };
        corner_rows.push_back(static_cast<std::uint32_t>(local.size()));
        local.insert(local.end(), {place(0), place(1), 0.5f, 0.0f});
      }
    }
  }
  std::vector<int> patches(static_cast<std::size_t>(blocks));
  std::iota(patches.begin(), patches.end(), 0);
  for (const float u : {-0.61f, -0.612f, -0.615f, 0.6f, 0.601f, 0.604f, 0.602f, 0.603f})
    targets.insert(targets.end(), {u, 0.7f * u, 0.8f, 0.0f});
  for (std::size_t i = targets.size(); i < 4 * 80; ++i) targets.push_back(targets[i % 4]);
  const int rows[24] = {0, 1, 2, 3,  4,  5,  6,  7,
                        0, 1, 2, 67, 68, 69, 70, 71};  // eight can be read behind the first of any part
  for (const jet::KernelTable* kernels : kBoth) {
    jet::Pyramid pyramid;
    pyramid.reserve(patches.size());
    std::vector<std::uint8_t> asked(patches.size()), inner(asked), not_inner(asked);
    std::vector<int> near(patches), uncertain(8 * patches.size() + 8), between(uncertain),
        on_winding_ray(uncertain);
    EXPECT_EQ(kernels
                  ->classify_patches({local.data(),
                                      0.0f,
                                      corner_rows.data(),
                                      8 * blocks,
                                      patches.data(),
                                      blocks,
                                      0,
                                      asked.data(),
                                      0.0f,
                                      0.0f,
                                      0.0f,
                                      near.data(),
                                      pyramid.boxes(),
                                      nullptr,
                                      inner.data(),
                                      not_inner.data(),
                                      uncertain.data(),
                                      between.data(),
                                      on_winding_ray.data(),
                                      nullptr})
                  .near,
              blocks);
    pyramid.build(blocks);
    std::vector<int> pair_rays(static_cast<std::size_t>(64 * blocks + 8)), pair_elements(pair_rays),
        first(pair_rays), second(pair_rays);
    const auto find = [&](int begin, int count) {
      const jet::RayArrays rays{targets.data(), 0.0f, rows + begin, count};
      return kernels->find_pairs(rays, 64, true, pyramid.view(), patches.data(),
                                 {pair_rays.data(), pair_elements.data(), first.data(), second.data()});
    };
    const auto found = [&](int begin, int count) {
      std::vector<Pair> out;
      const auto pairs = static_cast<std::size_t>(find(begin, count));
      for (std::size_t i = 0; i < pairs; ++i) out.emplace_back(pair_rays[i], pair_elements[i]);
      return out;
    };
    std::vector<Pair> together = found(0, 8), apart = found(0, 3);
    const std::vector<Pair> others = found(3, 5);
    apart.insert(apart.end(), others.begin(), others.end());
    for (auto* all : {&together, &apart}) std::sort(all->begin(), all->end());
    EXPECT_EQ(together, apart);
    EXPECT_GE(together.size(), 8u);
    EXPECT_EQ(find(8, 8), -3);
    EXPECT_EQ(found(8, 3), found(0, 3));
  }
}

/// Two triangles one behind the other, the others of their patch aside: the ray to the second meets the
/// first, and not its own.
TEST(kernels, element_is_not_in_the_way_to_itself) {
  std::vector<float> local, targets;
  std::vector<std::uint32_t> corner_rows;
  const auto depth = [](int i) { return i < 2 ? 0.3f + 0.1f * static_cast<float>(i) : 0.9f; };
  for (int corner = 0; corner < 3; ++corner) {
    for (int i = 0; i < 8; ++i) {
      const float side = i < 2 ? 0.0f : 2.0f;  // the others stand aside
      corner_rows.push_back(static_cast<std::uint32_t>(local.size()));
      local.insert(local.end(),
                   {side + (corner == 1 ? 0.1f : -0.05f), corner == 2 ? 0.1f : -0.05f, depth(i), 0.0f});
    }
  }
  for (int i = 0; i < 8; ++i) targets.insert(targets.end(), {i < 2 ? 0.0f : 2.0f, 0.0f, depth(i), 0.0f});
  const int patches[] = {0}, rows[16] = {1};
  for (const jet::KernelTable* kernels : kBoth) {
    jet::Pyramid pyramid;
    pyramid.reserve(1);
    const std::uint8_t asked[1] = {0};
    std::uint8_t inner[1], not_inner[1];
    int near[1], uncertain[16], between[16], on_winding_ray[16];
    ASSERT_EQ(kernels
                  ->classify_patches({local.data(),
                                      0.0f,
                                      corner_rows.data(),
                                      8,
                                      patches,
                                      1,
                                      0,
                                      asked,
                                      0.0f,
                                      0.0f,
                                      0.0f,
                                      near,
                                      pyramid.boxes(),
                                      nullptr,
                                      inner,
                                      not_inner,
                                      uncertain,
                                      between,
                                      on_winding_ray,
                                      nullptr})
                  .near,
              1);
    pyramid.build(1);
    using Pairs = std::vector<Pair>;
    const auto find = [&](bool to_targets) {
      int pair_rays[72], pair_elements[72], first[16], second[16];
      Pairs out;
      const int found = kernels->find_pairs({targets.data(), 0.0f, rows, 1}, 64, to_targets, pyramid.view(),
                                            patches, {pair_rays, pair_elements, first, second});
      for (int i = 0; i < found; ++i) out.emplace_back(pair_rays[i], pair_elements[i]);
      return out;
    };
    EXPECT_EQ(find(true), (Pairs{{1, 0}}));
    EXPECT_EQ(find(false), (Pairs{{1, 0}, {1, 1}}));
    targets[4 + 2] = 0.2f;  // now before both: its line goes on to them
    EXPECT_EQ(find(true), Pairs{});
    EXPECT_EQ(find(false), (Pairs{{1, 0}, {1, 1}}));
    targets[4 + 2] = depth(1);
  }
}

}  // namespace
