// SPDX-License-Identifier: Apache-2.0
// The kernels give the same bits on every instruction set, and their exponential is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernel_table.hpp"
#include "mesh_order.hpp"
#include "pyramid.hpp"
#include "scenes.hpp"

namespace {

using scenes::Mesh;

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
               std::vector<double>(count / 32 * 8 + 8, -1.0), std::vector<std::uint8_t>(count / 32 * 8 + 8)};
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
  std::vector<float> local, points, targets, ray_boxes, boxes, near_points;
  std::vector<std::uint8_t> codes, inner, outer, between, on_way, aside, blocked, apart;
  std::vector<int> hits;
  bool operator==(const Looked&) const = default;
};

void project(const jet::KernelTable& kernels, const Mesh& mesh, const Eigen::Matrix3Xi& triangles,
             const std::vector<int>& elements, Looked& p) {
  const Eigen::Matrix3Xd nodes = mesh.points();
  jet::ProjectArrays a{rows(nodes),
                       static_cast<int>(mesh.nodes.size()),
                       {0.1, 0.02, 0.03},
                       {},
                       p.local.data(),
                       triangles.data(),
                       elements.data(),
                       p.codes.data(),
                       {-0.5f, 0.5f, -0.5f, 0.5f, 0.0f},
                       {0.1f, 0.1f, 0.1f, 0.1f, 0.1f},
                       nullptr};
  for (int i = 0; i < 3; ++i) a.column[i][(i + 1) % 3] = 0.25;
  const jet::ProjectFlags flags = kernels.project_nodes(a);
  EXPECT_FALSE(flags.outside || flags.small || flags.tiny);
  std::vector<int> listed(mesh.nodes.size() / 8 * 8);
  std::iota(listed.rbegin(), listed.rend(), 0);
  const Looked whole = p;
  a.listed = listed.data();
  std::fill_n(p.local.begin(), 4 * listed.size(), 0.0f);
  kernels.project_listed(a, static_cast<int>(listed.size()));
  EXPECT_EQ(p, whole);
  a.local = p.targets.data();
  kernels.project_centroids(a, static_cast<int>(elements.size()));
}

/// All that the fast route asks of its kernels, with all elements in all roles.
Looked look(const jet::KernelTable& kernels, const Mesh& mesh, float half_long) {
  const Eigen::Matrix3Xi triangles = mesh.triangles();
  const std::size_t nodes = mesh.nodes.size(), count = mesh.elements.size(), patches = count / 8;
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  const auto bytes = [&] { return std::vector<std::uint8_t>(patches); };
  Looked p{std::vector<float>(4 * nodes + 32),
           std::vector<float>(jet::kElementFloats * patches),
           std::vector<float>(4 * count),
           std::vector<float>(jet::kBoxFloats / 8 * count),
           std::vector<float>(jet::kBoxFloats / 8 * count),
           std::vector<float>(jet::kElementFloats * patches),
           std::vector<std::uint8_t>(nodes + 8),
           bytes(),
           bytes(),
           bytes(),
           bytes(),
           bytes(),
           bytes(),
           bytes(),
           {}};
  project(kernels, mesh, triangles, all, p);
  const int n = static_cast<int>(count);
  const jet::RayArrays rays{p.targets.data(), half_long, p.ray_boxes.data()};
  kernels.make_rays(rays, n, p.aside.data());
  kernels.look_at_patches({p.local.data(),
                           half_long,
                           triangles.data(),
                           n,
                           all.data(),
                           n / 8,
                           1e-12f,
                           {0.1f, 0.2f, 0.01f},
                           p.points.data(),
                           p.inner.data(),
                           p.outer.data(),
                           p.between.data(),
                           p.on_way.data()});
  kernels.meet_pairs({p.targets.data(), p.local.data(), half_long, triangles.data(), all.data(),
                      all.data() + 8, p.blocked.data(), p.apart.data()},
                     n - 8);
  kernels.gather_elements(
      {p.local.data(), half_long, triangles.data(), all.data(), p.boxes.data(), p.near_points.data()}, n);
  const jet::PyramidView view{p.boxes.data(), 1, {}, {8}};  // the first 64 elements
  std::vector<int> hits(8 * count), first(count + 8), second(count + 8);
  const jet::HitLists lists{hits.data(), first.data(), second.data()};
  for (int block = 0; block < n / 8; ++block) {
    const int found = kernels.meet_blocks(rays, block, 0xf7u, view, p.near_points.data(), lists);
    p.hits.insert(p.hits.end(), hits.begin(), hits.begin() + found);
  }
  kernels.element_boxes(p.points.data(), half_long, n / 8, p.boxes.data());
  for (int ray = 0; ray < n; ++ray) {
    const int found = kernels.meet_elements(rays, ray, view, p.points.data(), lists);
    p.hits.insert(p.hits.end(), hits.begin(), hits.begin() + found);
  }
  return p;
}

TEST(kernels, visibility_has_the_same_bits_on_every_instruction_set) {
  const Mesh mesh = scenes::crumpled(3, 0.05, 42);
  for (const float half_long : {0.0f, 0.05f}) {
    const Looked reference = look(*kTables[0], mesh, half_long);
    EXPECT_EQ(look(*kTables[1], mesh, half_long), reference);
    EXPECT_GT(reference.hits.size(), 0u);
  }
}

TEST(mesh_order, patches_of_eight_are_compact_and_hold_each_element_once) {
  for (const Mesh& mesh : {scenes::sphere(4), scenes::soup(37, 0.3, 1), scenes::lattice_cube(4)}) {
    std::vector<jet::Triangle> triangles;
    for (const auto& t : mesh.elements) triangles.push_back({t[0], t[1], t[2]});
    const jet::OrderedMesh ordered(triangles);
    std::vector<int> seen(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto e = static_cast<std::size_t>(ordered.elements[i]);
      ++seen[e];
      EXPECT_EQ(ordered.rank[e], static_cast<int>(i));
      EXPECT_EQ(ordered.triangles[i], triangles[e]);
      const auto begin = ordered.patch_nodes.begin() + ordered.patch_begin[i / 8],
                 end = ordered.patch_nodes.begin() + ordered.patch_begin[i / 8 + 1];
      for (const int node : triangles[e]) EXPECT_NE(std::find(begin, end, node), end);
    }
    EXPECT_EQ(seen, std::vector<int>(triangles.size(), 1));
    EXPECT_EQ(ordered.patches, static_cast<int>((triangles.size() + 7) / 8));
    if (mesh.elements.size() == 2048) {
      // Eight triangles in a strip have 10 nodes, around a node 9; blocks need not begin where a patch does.
      // At random they have 24. Filled to a multiple of four, most have 12.
      EXPECT_LT(static_cast<double>(ordered.patch_nodes.size()) / ordered.patches, 13.0);
    }
  }
}

}  // namespace
