// SPDX-License-Identifier: Apache-2.0
// A rigid target as in frames.bin.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/scene.hpp"
#include "jet_loads.hpp"

namespace driver {

/// A grid of at most 30 by 30 cells, because a target may have millions. Its lines are lines of the target's
/// own grid, so each cell contains whole cells of the target, and its mean overpressure gives the same force.
class TargetPicture {
 public:
  explicit TargetPicture(const TargetPart& target);
  const Eigen::Matrix3Xd& nodes() const { return nodes_; }          // [m]
  const Eigen::Matrix3Xi& triangles() const { return triangles_; }  // two for each cell
  /// The mean overpressure of each cell, and its largest mask, for both of its triangles.
  JetLoads loads(const State& state) const;

 private:
  Eigen::Matrix3Xd nodes_;
  Eigen::Matrix3Xi triangles_;
  std::vector<std::size_t> cell_of_;  // [cell of the target]
  std::vector<double> share_;         // [cell] 1 / number of the target's elements in it
};

}  // namespace driver
