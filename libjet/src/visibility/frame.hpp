// SPDX-License-Identifier: Apache-2.0
// Orthonormal coordinates along a jet: w downstream or upstream, v along the outlet's long side, u across.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "jet/visibility.hpp"

namespace jet {

/// Direction of w. Sources on the surface are moved downstream in both.
enum class Way { downstream, upstream };

struct Frame {
  // Right-handed in this order: orientations keep their signs.
  Eigen::Vector3d across = Eigen::Vector3d::Zero(), along = across, forward = across;
  bool line = false;    // sources lie on a line, not in one point
  bool usable = false;  // the source has a frame
  Way way = Way::downstream;

  /// Sets all members. The frame is not usable if the long direction is not a unit vector, or is along the
  /// axis. The sources of a line are off `along` by at most 1e-14 of its length.
  void build(const RaySource& source) {
    usable = false;
    line = source.half_long > 0.0;
    forward = (source.axis / source.axis.cwiseAbs().maxCoeff()).normalized();
    along = line ? source.long_direction : forward.unitOrthogonal();
    if (std::abs(along.squaredNorm() - 1.0) > 1e-14) return;
    forward -= forward.dot(along) * along;  // repeated, so that it is perpendicular to a few roundings
    if (forward.squaredNorm() < 0.01) return;
    forward.normalize();
    if (way == Way::upstream) forward = -forward;
    across = along.cross(forward);
    usable = true;
  }

  /// Bound [m] of the motion, seen from this frame at `centre`, of points within `reach` [m] of the centre of
  /// another one, which moved here.
  double motion_from(const Frame& other, const Eigen::Vector3d& other_centre, const Eigen::Vector3d& centre,
                     double reach) const {
    const double turn = (across - other.across).squaredNorm() + (along - other.along).squaredNorm() +
                        (forward - other.forward).squaredNorm();
    return (centre - other_centre).norm() + reach * std::sqrt(turn);
  }

  /// True if no ray reaches w <= 0. Then sources on the surface are moved upwards, and w is one coordinate of
  /// the points, equal for all sources, so that its sign is exact.
  bool has_floor() const {
    if (way == Way::upstream) return false;
    if ((forward.array() == 0.0).count() != 2) return false;
    for (int i = 0; i < 3; ++i)
      if (std::abs(forward[i]) == 1.0 && along[i] == 0.0) return true;
    return false;
  }
};

}  // namespace jet
