// SPDX-License-Identifier: Apache-2.0
// Orthonormal coordinates along a jet: w downstream, u across and v along the outlet's long side.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "jet/visibility.hpp"

namespace jet {

/// u and v side by side: the compiler's portable vectors.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

struct Local {
  double w;
  Pair side;  // u, v
};

struct Frame {
  Eigen::Vector3d centre, forward, across, along;
  bool line = false;  // sources lie on a line, not in one point

  /// False if the source has no usable frame: a long direction of another length than 1, or along the axis.
  /// Sources of a line lie beside `along` by 1e-14 of its length at most.
  bool build(const RaySource& source) {
    centre = source.centre;
    line = source.half_long > 0.0;
    forward = (source.axis / source.axis.cwiseAbs().maxCoeff()).normalized();
    along = line ? source.long_direction : forward.unitOrthogonal();
    if (std::abs(along.squaredNorm() - 1.0) > 1e-14) return false;
    forward -= forward.dot(along) * along;  // must not cancel, to be square to a few roundings
    if (forward.squaredNorm() < 0.01) return false;
    forward.normalize();
    across = forward.cross(along);
    return true;
  }

  Local direction(double x, double y, double z) const {
    const Pair side = x * Pair{across[0], along[0]} + y * Pair{across[1], along[1]};
    return {x * forward[0] + y * forward[1] + z * forward[2], side + z * Pair{across[2], along[2]}};
  }
  Local direction(const double* from, const double* to) const {
    return direction(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  }
  Local at(const double* x) const { return direction(centre.data(), x); }
};

}  // namespace jet
