// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "membrane/element_group.hpp"
#include "membrane/vectors.hpp"

namespace membrane {

// What the bound of omega^2 needs of an element in its reference shape. A null element has volume 0.
struct ElementStiffness {
  double volume = 0.0;  // h A [m3]
  Eigen::Matrix<double, 2, 3> gradient =
      Eigen::Matrix<double, 2, 3>::Zero();  // of the corner functions [1/m]
  Eigen::Matrix3d factor =
      Eigen::Matrix3d::Zero();  // L of the taut stiffness D = L L^T (engineering shear) [Pa^(1/2)]
};

// The mass of each node shared out among the corners of its elements (M.15). Any shares give a bound of
// omega^2 that is safe; good ones give one that is near.
struct MassShares {
  Eigen::Matrix3Xd mass;                    // 3 x elements, 0 for null [kg]
  AlignedVector<FrequencyGroup> frequency;  // of each group of elements, follows from mass
};

}  // namespace membrane
