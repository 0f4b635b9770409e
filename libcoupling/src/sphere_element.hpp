// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <vector>

#include "coupling/sphere_contact.hpp"

namespace coupling::detail {

// One element in the impactor's frame: x(xi, eta) = origin + xi first + eta second.
struct Element {
  Eigen::Vector3d origin, first, second;  // [m]
  double weight;                          // [m2] of one quadrature point
  int subdivision;
};

// Friction of one evaluation. It reads the bristles of the last level, in ascending order of element and
// point, and writes those of this level.
struct Grip {
  Eigen::Vector3d origin, first, second;  // [m] displacement of the element since then, minus the centre's
  Eigen::Vector3d turn;                   // [rad] rotation of the impactor since then
  double coefficient;
  int element;
  const std::vector<Bristle>& before;
  std::size_t passed;
  std::vector<Bristle>& now;
  double loss;  // [J] divided by kappa
};

// Sums over the touched points of one element, divided by kappa.
struct ElementSums {
  Eigen::Vector3d force[3] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                              Eigen::Vector3d::Zero()};  // on the corners
  Eigen::Vector3d couple = Eigen::Vector3d::Zero();      // moment of the forces on the skin about the centre
  double shape[3] = {0.0, 0.0, 0.0};                     // [m2] sum_q w_q N_a
  double energy = 0.0, area = 0.0;
  double depth = 0.0;  // [m] of the deepest point
};

// Sums over the element's quadrature points inside the impactor. Null `grip`: no friction.
ElementSums integrate(const Element& element, const Impactor& impactor, Grip* grip);

// Friction loss [J] divided by kappa, including points that left the sphere since the last level.
double release_rest(Grip& grip);

}  // namespace coupling::detail
