// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>

namespace coupling {

/// Views of the skin's arrays, one column per node or element. Any outer stride is accepted: arrays padded to
/// four doubles a node are passed as matrix.topRows<3>() without a copy.
using Nodes = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;      // (3 x N) [m]
using NodalForces = Eigen::Ref<Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;      // (3 x N) [N]
using Triangles = Eigen::Ref<const Eigen::Matrix3Xi, 0, Eigen::OuterStride<>>;  // (3 x M) node numbers

}  // namespace coupling
