// SPDX-License-Identifier: Apache-2.0
// The flattened initial shape: attachment kept, no element inverted, no two elements intersecting (CGAL,
// exact).
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include "membrane/icosphere.hpp"
#include "membrane/passenger_bag.hpp"
#include "membrane/surface_check.hpp"

namespace {

using membrane::Mesh;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Corners = std::array<int, 3>;

Point point(const Eigen::Matrix3Xd& nodes, int i) {
  return {nodes(0, i), nodes(1, i), nodes(2, i)};
}

Triangle triangle(const Eigen::Matrix3Xd& nodes, const Corners& c) {
  return {point(nodes, c[0]), point(nodes, c[1]), point(nodes, c[2])};
}

// Corners turned so that those shared with `other` come last.
Corners shared_last(Corners corners, const Corners& other, int& shared) {
  const auto is_shared = [&](int n) { return std::find(other.begin(), other.end(), n) != other.end(); };
  const auto first =
      std::stable_partition(corners.begin(), corners.end(), [&](int n) { return !is_shared(n); });
  shared = static_cast<int>(corners.end() - first);
  return corners;
}

// Whether two elements meet anywhere but at the nodes they share.
bool intersect(const Eigen::Matrix3Xd& nodes, const Corners& p, const Corners& q) {
  int shared = 0;
  const Corners a = shared_last(p, q, shared), b = shared_last(q, p, shared);
  const Triangle ta = triangle(nodes, a), tb = triangle(nodes, b);
  if (shared == 0) return CGAL::do_intersect(ta, tb);
  if (shared == 1)  // beyond the common node one of the two opposite sides enters the other element
    return CGAL::do_intersect(Segment(ta[0], ta[1]), tb) || CGAL::do_intersect(Segment(tb[0], tb[1]), ta);
  return CGAL::coplanar(ta[0], ta[1], ta[2], tb[0]) &&
         CGAL::coplanar_orientation(ta[1], ta[2], ta[0], tb[0]) == CGAL::POSITIVE;
}

int intersecting_pairs(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements) {
  const auto count = static_cast<std::size_t>(elements.cols());
  std::vector<CGAL::Bbox_3> boxes;
  std::vector<Corners> corners;
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    corners.push_back({elements(0, e), elements(1, e), elements(2, e)});
    boxes.push_back(triangle(nodes, corners.back()).bbox());
  }
  int pairs = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j])) pairs += intersect(nodes, corners[i], corners[j]);
  return pairs;
}

TEST(Flattening, attachment_stays_and_depth_shrinks) {
  const Mesh mesh = membrane::passenger_bag().mesh;
  const Eigen::Matrix3Xd nodes = membrane::flatten(mesh, 0.1);
  for (const int node : membrane::panel_nodes(mesh, "attachment"))
    EXPECT_TRUE(nodes.col(node) == mesh.nodes.col(node));
  EXPECT_EQ(nodes.row(0).maxCoeff(), 0.1 * mesh.nodes.row(0).maxCoeff());
  EXPECT_TRUE(nodes.bottomRows(2) == mesh.nodes.bottomRows(2));
}

// x -> f x multiplies the volume by f and every triple product with it: 2744 terms, 20 operations each.
TEST(Flattening, volume_scales_with_the_factor) {
  const Mesh mesh = membrane::passenger_bag().mesh;
  const double design = membrane::enclosed_volume(mesh.nodes, mesh.elements);
  for (const double factor : {1.0, 0.5, 0.1, 0.01})
    EXPECT_NEAR(membrane::enclosed_volume(membrane::flatten(mesh, factor), mesh.elements) / design, factor,
                2744 * 20 * 2.3e-16 * factor);
}

// Convex-like shape: seen from the mid-point every element keeps its side, so that none is inverted.
TEST(Flattening, no_element_is_inverted) {
  const Mesh mesh = membrane::passenger_bag().mesh;
  for (const double factor : {1.0, 0.1, 0.02}) {
    const Eigen::Matrix3Xd nodes = membrane::flatten(mesh, factor);
    EXPECT_TRUE(membrane::check_closed_surface(nodes, mesh.elements).ok());
    const Eigen::Vector3d middle(factor * 0.34, 0.0, 0.0);
    for (int e = 0; e < mesh.element_count(); ++e) {
      const Eigen::Vector3d a = nodes.col(mesh.elements(0, e)) - middle,
                            b = nodes.col(mesh.elements(1, e)) - middle;
      EXPECT_GT(a.dot(b.cross(nodes.col(mesh.elements(2, e)) - middle)), 0.0) << e;
    }
  }
}

TEST(Flattening, no_two_elements_intersect) {
  const Mesh mesh = membrane::passenger_bag().mesh;
  for (const double factor : {1.0, 0.1})
    EXPECT_EQ(intersecting_pairs(membrane::flatten(mesh, factor), mesh.elements), 0) << factor;
}

TEST(Flattening, the_intersection_check_sees_a_folded_shape) {
  Mesh mesh = membrane::passenger_bag().mesh;
  const int front = membrane::passenger_bag().strap_anchors[0][1];
  mesh.nodes(0, front) = -0.01;  // pushed through the back
  EXPECT_GT(intersecting_pairs(mesh.nodes, mesh.elements), 0);
  Mesh sphere = membrane::icosphere(1.0, 1);
  sphere.nodes.col(0) *= -1.1;  // through the opposite side: only elements apart or with a common node meet
  EXPECT_GT(intersecting_pairs(sphere.nodes, sphere.elements), 0);
  Mesh sheet = membrane::rectangle(1, 1, 1.0, 1.0, membrane::Diagonals::uniform);
  EXPECT_EQ(intersecting_pairs(sheet.nodes, sheet.elements), 0);
  sheet.nodes.col(2) << 0.75, 0.25, 0.0;  // folded flat along the common edge
  EXPECT_EQ(intersecting_pairs(sheet.nodes, sheet.elements), 1);
}

TEST(Flattening, factors_outside_zero_to_one_are_refused) {
  const Mesh mesh = membrane::icosphere(1.0, 0);
  for (const double factor : {0.0, -0.1, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(membrane::flatten(mesh, factor), std::invalid_argument);
}

}  // namespace
