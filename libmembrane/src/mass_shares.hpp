// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "membrane/bag_model.hpp"

namespace membrane {

// What the bound of omega^2 needs of an element of fabric in its reference shape.
struct ElementStiffness {
  int element;
  double volume;                         // h A [m3]
  double mass;                           // rho h A [kg]
  Eigen::Matrix<double, 2, 3> gradient;  // of the corner functions [1/m]
  Eigen::Matrix3d factor;                // L of the taut stiffness D = L L^T (engineering shear) [Pa^(1/2)]
};

// Shares out the mass of each node among its elements so that the largest bound becomes small (M.15), and
// sets material_frequency and geometric_frequency of all groups and fabric_frequency. Needs node_mass.
void set_frequencies(BagModel& model, const std::vector<ElementStiffness>& fabric);

}  // namespace membrane
