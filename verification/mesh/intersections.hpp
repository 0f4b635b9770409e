// SPDX-License-Identifier: Apache-2.0
// Pairs of elements that meet where they should not, by CGAL's exact predicates.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace intersections {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Corners = std::array<int, 3>;

inline Point point(const Eigen::Matrix3Xd& nodes, int i) {
  return {nodes(0, i), nodes(1, i), nodes(2, i)};
}

inline Triangle triangle(const Eigen::Matrix3Xd& nodes, const Corners& c) {
  return {point(nodes, c[0]), point(nodes, c[1]), point(nodes, c[2])};
}

// Corners turned so that those shared with `other` come last.
inline Corners shared_last(Corners corners, const Corners& other, int& shared) {
  const auto is_shared = [&](int n) { return std::find(other.begin(), other.end(), n) != other.end(); };
  const auto first =
      std::stable_partition(corners.begin(), corners.end(), [&](int n) { return !is_shared(n); });
  shared = static_cast<int>(corners.end() - first);
  return corners;
}

// Whether two elements meet anywhere but at the nodes they share.
inline bool intersect(const Eigen::Matrix3Xd& nodes, const Corners& p, const Corners& q) {
  int shared = 0;
  const Corners a = shared_last(p, q, shared), b = shared_last(q, p, shared);
  const Triangle ta = triangle(nodes, a), tb = triangle(nodes, b);
  if (shared == 0) return CGAL::do_intersect(ta, tb);
  if (shared == 1)  // beyond the common node one of the two opposite sides enters the other element
    return CGAL::do_intersect(Segment(ta[0], ta[1]), tb) || CGAL::do_intersect(Segment(tb[0], tb[1]), ta);
  return CGAL::coplanar(ta[0], ta[1], ta[2], tb[0]) &&
         CGAL::coplanar_orientation(ta[1], ta[2], ta[0], tb[0]) == CGAL::POSITIVE;
}

inline int intersecting_pairs(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements) {
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

}  // namespace intersections
