// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a skin are, and how long their paths are. (A skin vibrates, but bounds by positions last
// no longer than paths. Tried: balls and boxes around homes of groups, and motion along directions.)
#pragma once
#include <vector>

#include "coupling/element_groups.hpp"
#include "coupling/skin.hpp"
#include "skin_box.hpp"

namespace coupling::detail {

class SkinMotion {
 public:
  SkinMotion(const ElementGroups& groups, double ahead);

  /// Goes on to the next positions. Throws ContactError if one is not finite.
  void advance(const Nodes& nodes);

  const Eigen::Matrix3Xd& now() const { return now_; }
  const Eigen::Matrix3Xd& before() const { return before_; }
  /// Box of the node's path in the last step and `ahead` steps like that, from some origin.
  const Box& path_box(int node) const { return path_boxes_[static_cast<std::size_t>(node)]; }
  /// Box of those of the group.
  Box group_box(int group) const;

  /// [m] Length of a path as long as that of any node of the group, since the start and in the last step, in
  /// a frame that moves with the skin.
  double path(int group) const { return paths_[static_cast<std::size_t>(group)]; }
  float step(int group) const { return steps_[static_cast<std::size_t>(group)]; }
  float largest_step() const { return largest_step_; }
  /// [m] Largest error of a difference of coordinates in single precision.
  float rounding() const { return rounding_; }

 private:
  void step();

  const ElementGroups* groups_;
  float ahead_;
  Eigen::Matrix3Xd now_, before_;
  Eigen::Vector3d origin_;                         // [m] where points are counted from
  std::vector<Point> points_now_, points_before_;  // (N)
  std::vector<Box> path_boxes_;                    // (N)
  std::vector<float> node_steps_;                  // (N) [m2] squares
  std::vector<double> paths_;                      // (groups)
  std::vector<float> steps_;                       // (groups)
  float largest_step_ = 0.0F, rounding_ = 0.0F;
};

}  // namespace coupling::detail
