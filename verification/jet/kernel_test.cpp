// SPDX-License-Identifier: Apache-2.0
// The kernels give the same bits on every instruction set, and their exponential is one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include "kernel_table.hpp"
#include "scenes.hpp"

namespace {

using scenes::Mesh;

/// Codes stand among the numbers, and may be none.
bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), 4 * a.size()) == 0;
}

const jet::KernelTable* const kTables[] = {&jet::baseline::kTable, &jet::kernel_table()};

jet::Rows rows(const Eigen::Matrix3Xd& points) {
  const Eigen::Index last = points.cols() - 1;
  return {points.data(), 3, static_cast<int>(last), {points(0, last), points(1, last), points(2, last), 0.0}};
}

jet::JetShape shape(bool round, bool axial) {
  jet::JetShape s{
      round, axial, axial, {0.1, 0.0, -0.1}, {0, 0, 1}, {}, {}, 0.1, 0.0, 0.1, 0.1, 0.2, 0.3, 0.4, 0.0,
      0.5,   0.89,  0.1};
  if (round) return s;
  s.across[0] = s.along[1] = 1.0;
  s.half_long = 0.5;
  return s;
}

struct Field {
  std::vector<double> overpressure;
  std::vector<int> candidates;
  std::vector<double> slack;
  std::vector<std::uint8_t> inside;
  bool operator==(const Field&) const = default;
};

Field field(const jet::KernelTable& kernels, const jet::JetShape& jet, const Eigen::Matrix3Xd& centroids,
            const Eigen::Matrix3Xd& areas) {
  const auto count = static_cast<std::size_t>(centroids.cols());
  Field result{std::vector<double>(count), std::vector<int>(count + 8),
               std::vector<double>(count / 128 * 32 + 32, -1.0),
               std::vector<std::uint8_t>(count / 128 * 32 + 32)};
  std::vector<std::uint8_t> loaded(count / 4 + 1, 0xf);
  loaded.back() = static_cast<std::uint8_t>((1 << count % 4) - 1);
  jet::FieldArrays a{rows(areas),
                     rows(centroids),
                     {},
                     false,
                     loaded.data(),
                     static_cast<int>(count),
                     0.0,
                     result.slack.data(),
                     result.inside.data(),
                     410.0,
                     1.9,
                     result.overpressure.data(),
                     result.candidates.data()};
  const int left = kernels.evaluate(jet, a, kernels.select(jet, a));
  EXPECT_GE(left, 0);
  result.candidates.resize(static_cast<std::size_t>(left));
  return result;
}

TEST(kernels, field_has_the_same_bits_on_every_instruction_set) {
  scenes::Random random(41);
  for (const int count : {1, 2, 3, 4, 5, 1003}) {
    Eigen::Matrix3Xd centroids(3, count), areas(3, count);
    for (int e = 0; e < count; ++e) {
      centroids.col(e) = random.vector(0.6) + Eigen::Vector3d(0, 0, 0.6);
      areas.col(e) = random.vector(1e-3);
    }
    for (const bool round : {true, false}) {
      for (const bool axial : {true, false}) {
        const Field reference = field(*kTables[0], shape(round, axial), centroids, areas);
        EXPECT_EQ(field(*kTables[1], shape(round, axial), centroids, areas), reference);
        if (count > 100) {
          EXPECT_GT(reference.candidates.size(), 20u);
        }
      }
    }
  }
}

TEST(kernels, profile_eq_exponential) {
  // Round jet of constant width 0.1 without decay: the overpressure is factor (V0 exp(-(r/R)^2))^2.
  jet::JetShape jet = shape(true, true);
  jet.momentum = false;
  jet.decay_coefficient = 1e-30;
  jet.cone_width = 0.1;
  jet.cone_slope = 0.0;
  jet.cut_core = 1e100;
  const int count = 1000;
  Eigen::Matrix3Xd centroids(3, count), areas(3, count);
  for (int e = 0; e < count; ++e) {
    centroids.col(e) =
        Eigen::Vector3d(0.1 + 0.0018 * e, 0.0, 0.3);  // exp of 0 to -323: its square is a number
    areas.col(e) = Eigen::Vector3d(0, 0, 1);
  }
  for (const jet::KernelTable* kernels : kTables) {
    const Field result = field(*kernels, jet, centroids, areas);
    ASSERT_EQ(result.candidates.size(), static_cast<std::size_t>(count));
    for (int e = 0; e < count; ++e) {
      const long double r = (static_cast<long double>(centroids(0, e)) - 0.1L) / 0.1L, x = r * r;
      const long double exact = 1.9L * 410.0L * 410.0L * std::exp(-2.0L * x);
      // Two roundings of the exponential and six others, doubled by the square; four roundings of the
      // exponent, which is 2 x, and of the given 0.1.
      const double error = (16.0 + 12.0 * static_cast<double>(x)) * std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(static_cast<double>(result.overpressure[static_cast<std::size_t>(e)] / exact), 1.0, error)
          << x;
    }
  }
}

struct Looked {
  std::vector<float> local, targets, boxes, chosen_boxes, merged, bounds;
  std::vector<std::uint8_t> inner, not_inner, blocked, pierced, apart, missed;
  std::vector<int> near, uncertain, between, on_winding_ray, upstream, chosen, pairs;
  std::vector<std::int32_t> codes;
  bool operator==(const Looked&) const = default;
};

void append(const jet::Frustum& b, std::vector<float>& to) {
  to.insert(to.end(), {b.low_u, b.high_u, b.low_v, b.high_v});
}

void project(const jet::KernelTable& kernels, const Mesh& mesh, const Eigen::Matrix3Xi& triangles,
             const std::vector<int>& elements, float half_long, Looked& p) {
  const Eigen::Matrix3Xd nodes = mesh.points();
  jet::ProjectArrays a{rows(nodes),
                       static_cast<int>(mesh.nodes.size()),
                       {0.1, 0.02, 0.03},
                       {},
                       p.local.data(),
                       p.codes.data(),
                       triangles.data(),
                       elements.data(),
                       {-0.5f, 0.5f, -0.5f, 0.5f},
                       {0.1f, 0.1f, 0.1f, 0.1f, 0.1f},
                       nullptr};
  for (int i = 0; i < 3; ++i) a.column[i][(i + 1) % 3] = 0.25;
  const jet::ProjectFlags flags = kernels.project_nodes(a);
  EXPECT_FALSE(flags.outside || flags.small || flags.tiny);
  append(kernels.frustum_of(a, half_long, static_cast<int>(elements.size())), p.bounds);
}

/// All that the fast route asks of its kernels, with all elements in all roles.
Looked look(const jet::KernelTable& kernels, const Mesh& mesh, float half_long) {
  const Eigen::Matrix3Xi triangles = mesh.triangles();
  const std::size_t nodes = mesh.nodes.size(), count = mesh.elements.size(), patches = count / 8;
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::uint32_t> corner_rows(3 * count);
  for (std::size_t i = 0; i < corner_rows.size(); ++i) {
    const auto e = static_cast<Eigen::Index>(i / 24 * 8 + i % 8),
               corner = static_cast<Eigen::Index>(i / 8 % 3);
    corner_rows[i] = 4 * static_cast<std::uint32_t>(triangles(corner, e));
  }
  const auto bytes = [&] { return std::vector<std::uint8_t>(patches); };
  const auto places = [&] { return std::vector<int>(count + 8); };
  Looked p;
  p.local.resize(4 * nodes + 32);
  p.codes.resize(nodes + 8);
  p.targets.resize(4 * count);
  p.boxes.resize(jet::kBoxFloats * patches);
  p.chosen_boxes = p.boxes;
  p.merged.resize(jet::kBoxFloats * (patches / 8 + 1));
  p.inner = p.not_inner = p.blocked = p.pierced = p.apart = p.missed = bytes();
  p.near = p.uncertain = p.between = p.on_winding_ray = p.upstream = p.chosen = places();
  project(kernels, mesh, triangles, all, half_long, p);
  const int n = static_cast<int>(count);
  const std::vector<std::uint8_t> asked(patches, 0xd7);
  const float wide = 1e-4f;  // bound of the orientation: some sides stay open
  const jet::PatchesFound found = kernels.classify_patches({p.local.data(),
                                                            half_long,
                                                            corner_rows.data(),
                                                            n,
                                                            all.data(),
                                                            n / 8,
                                                            0x9f,
                                                            asked.data(),
                                                            wide,
                                                            0.1f,
                                                            0.1f,
                                                            p.near.data(),
                                                            p.boxes.data(),
                                                            p.targets.data(),
                                                            p.inner.data(),
                                                            p.not_inner.data(),
                                                            p.uncertain.data(),
                                                            p.between.data(),
                                                            p.on_winding_ray.data(),
                                                            p.upstream.data()});
  EXPECT_EQ(found.asked, found.near);
  EXPECT_GE(found.near, 8);  // as many blocks as are met below
  EXPECT_LT(found.near, n / 8);
  EXPECT_GT(found.uncertain, 0);
  EXPECT_GT(found.on_winding_ray, 0);
  p.near.resize(static_cast<std::size_t>(found.near));
  p.uncertain.resize(static_cast<std::size_t>(found.uncertain));
  p.between.resize(static_cast<std::size_t>(found.between));
  p.on_winding_ray.resize(static_cast<std::size_t>(found.on_winding_ray));
  p.upstream.resize(static_cast<std::size_t>(found.upstream));
  append(found.bounds, p.bounds);
  kernels.meet_pairs({p.targets.data(), p.local.data(), half_long, corner_rows.data(), all.data(),
                      all.data() + 8, p.blocked.data(), p.pierced.data(), p.apart.data(), p.missed.data()},
                     n - 8);
  const int chosen = kernels.choose_boxes({p.boxes.data(), p.near.data(), found.near}, p.not_inner.data(),
                                          p.chosen_boxes.data(), p.chosen.data());
  EXPECT_GE(chosen, 8);
  kernels.merge(p.boxes.data(), found.near, p.merged.data());
  std::vector<int> pair_rays(8 * count + 8), pair_elements(pair_rays), first(count + 8), second(first);
  const jet::PairLists lists{pair_rays.data(), pair_elements.data(), first.data(), second.data()};
  const auto find = [&](bool to_targets, const std::vector<float>& boxes, const std::vector<int>& blocks) {
    const jet::PyramidView view{boxes.data(), 1, {}, {8}};  // the first 64 elements
    for (int ray = 0; ray + 8 <= n; ray += 8) {
      const jet::RayArrays rays{p.targets.data(), half_long, all.data() + ray, ray % 16 == 0 ? 8 : 3};
      const int found_pairs = kernels.find_pairs(rays, n, to_targets, view, blocks.data(), lists);
      for (const auto* list : {&pair_rays, &pair_elements})
        p.pairs.insert(p.pairs.end(), list->begin(), list->begin() + found_pairs);
    }
  };
  find(false, p.chosen_boxes, p.chosen);
  find(true, p.boxes, p.near);
  return p;
}

TEST(kernels, visibility_has_the_same_bits_on_every_instruction_set) {
  const Mesh mesh = scenes::crumpled(3, 0.05, 42);
  for (const float half_long : {0.0f, 0.05f}) {
    Looked reference = look(*kTables[0], mesh, half_long), fast = look(*kTables[1], mesh, half_long);
    EXPECT_TRUE(same_bits(std::exchange(reference.local, {}), std::exchange(fast.local, {})));
    EXPECT_EQ(fast, reference);
    EXPECT_GT(reference.pairs.size(), 0u);
  }
}

}  // namespace
