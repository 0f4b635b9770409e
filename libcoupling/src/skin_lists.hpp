// SPDX-License-Identifier: Apache-2.0
// Boxes of the paths of a skin's groups and parts over a step, and parts that are near each other.
#pragma once
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "skin_pair.hpp"
#include "skin_parts.hpp"

namespace coupling::detail {

inline constexpr double kEverywhere = std::numeric_limits<double>::infinity();

/// Box [m] of positions at two levels, and of the straight paths between them.
struct PathBox {
  Eigen::Array3d low = Eigen::Array3d::Constant(kEverywhere), high = Eigen::Array3d::Constant(-kEverywhere);
  void add(const Eigen::Array3d& x) {
    low = low.min(x);
    high = high.max(x);
  }
  /// True if the boxes are farther apart than `distance` [m] along an axis.
  bool apart(const PathBox& other, double distance) const {
    return (low > other.high + distance).any() || (high < other.low - distance).any();
  }
  /// Distance of the boxes [m], rounded down.
  double gap(const PathBox& other) const {
    return (1.0 - 1e-12) * (low - other.high).max(other.low - high).max(0.0).matrix().norm();
  }
};

/// Boxes of the paths of a group and its parts, in their order in the group.
struct GroupPaths {
  PathBox whole;
  std::vector<PathBox> nodes, elements, edges;
};

/// The paths of a skin's groups between two levels; each is worked out when it is first asked for.
class SkinPaths {
 public:
  explicit SkinPaths(const SkinParts& parts);
  /// Goes on to the next positions, 3 x N [m].
  void advance(const Nodes& nodes);
  const Eigen::Matrix3Xd& now() const { return now_; }
  const Eigen::Matrix3Xd& before() const { return before_; }
  /// Box of the group's nodes.
  const PathBox& whole(const SkinParts& parts, int group);
  const GroupPaths& of(const SkinParts& parts, int group);

 private:
  template <class Corners>
  PathBox box(const Corners& nodes) const;

  Eigen::Matrix3Xd now_, before_;
  std::vector<GroupPaths> groups_;
  std::vector<long> whole_level_, parts_level_;
  long level_ = -1;
};

/// Pairs of boxes not farther apart than `reach` [m], each with itself too; lower number first, ascending.
std::vector<std::pair<int, int>> near_boxes(const std::vector<PathBox>& boxes, double reach);

/// Looks at parts of two groups, without neighbours, in an order of the mesh: at all of which the paths come
/// closer than `near`, and at others that may be closest at the last level.
class PartSearch {
 public:
  using Look = std::function<double(const PartPair&)>;  // at a pair: the distance [m] at the last level
  /// `near` [m]. Parts are not closer than the least distance of what was looked at, or `range` [m].
  PartSearch(const SkinParts& parts, double near, double range, const Look& look)
      : parts_(parts), near_(near), least_(range), look_(look) {}

  /// Returns a lower bound of the distance of the groups' parts, at most the range.
  double search(int first, const GroupPaths& first_paths, int second, const GroupPaths& second_paths);

 private:
  void search_nodes(int first, const GroupPaths& first_paths, int second, const GroupPaths& second_paths);
  void search_edges(int first, const GroupPaths& first_paths, int second, const GroupPaths& second_paths);
  void consider(const PartPair& pair, const PathBox& first, const PathBox& second);
  double range() const { return std::max(near_, least_); }

  const SkinParts& parts_;
  double near_, least_;
  const Look& look_;
};

}  // namespace coupling::detail
