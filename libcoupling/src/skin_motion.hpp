// SPDX-License-Identifier: Apache-2.0
// How far the groups of a skin have moved: since a mark a common shift and how far nodes are from that, and
// in the last step. A skin vibrates, so that positions say more than path lengths.
#pragma once
#include <vector>

#include "coupling/element_groups.hpp"
#include "coupling/skin.hpp"

namespace coupling::detail {

class SkinMotion {
 public:
  explicit SkinMotion(const ElementGroups& groups);

  /// Goes on to the next positions. Throws ContactError if one is not finite.
  void update(const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before);
  /// Measures from these positions on.
  void mark(const Eigen::Matrix3Xd& now);

  /// [m] No node moved farther since the mark.
  double moved() const;
  /// [m] No node of the first group moved farther relative to one of the second since the mark.
  double since_mark(int first, int second) const;
  /// The same in the last step.
  double step(int first, int second) const;
  /// [m] No node moved farther in the last step.
  double largest_step() const;

 private:
  const ElementGroups* groups_;
  Eigen::Matrix3Xd marked_;     // (3 x places in groups.nodes) [m]
  Eigen::Matrix3Xd shift_;      // (3 x groups) [m] mean of x - marked
  std::vector<double> spread_;  // [m] largest distance of x - marked from the mean
  std::vector<double> step_;    // [m] largest motion in the last step
};

}  // namespace coupling::detail
