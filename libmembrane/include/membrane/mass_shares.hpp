// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "membrane/element_group.hpp"
#include "membrane/vectors.hpp"

namespace membrane {

/// Data of an element in its reference shape, for the bound of omega^2. A null element has volume 0.
struct ElementStiffness {
  double volume = 0.0;  // h A [m3]
  /// [1/m] gradients of the corner functions.
  Eigen::Matrix<double, 2, 3> gradient = Eigen::Matrix<double, 2, 3>::Zero();
  /// [Pa^(1/2)] L of the taut stiffness D = L L^T (engineering shear).
  Eigen::Matrix3d factor = Eigen::Matrix3d::Zero();
};

/// Mass of each node, divided among the corners of its elements (M.15). Any shares give a safe bound of
/// omega^2; well-chosen shares give a sharp one.
struct MassShares {
  Eigen::Matrix3Xd mass;                    // [kg] 3 x elements, 0 for null elements
  AlignedVector<FrequencyGroup> frequency;  // bounds of each group of elements; they follow from `mass`
};

}  // namespace membrane
