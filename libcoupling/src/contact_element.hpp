// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "bodies.hpp"
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

// A quadrature point inside the impactor.
struct ContactPoint {
  int number;
  double shape[3];
  Eigen::Vector3d x;       // [m] from the centre
  Eigen::Vector3d normal;  // of the impactor's surface, outwards
  double depth;            // [m]
};

// The bristle of this point at the last level, or null. Bristles skipped before it have left the impactor.
const Bristle* find_bristle(Grip& grip, int number);

// Friction loss [J] divided by kappa, including points that left the impactor since the last level.
double release_rest(Grip& grip);

// (K.16), (K.17): the stretch follows the skin's motion against the impactor, limited to mu times the depth.
inline void add_friction(const Element& element, const ContactPoint& point, Grip& grip, ElementSums& sums) {
  Eigen::Vector3d stretch = Eigen::Vector3d::Zero();
  if (const Bristle* last = find_bristle(grip, point.number)) {
    const Eigen::Vector3d moved =
        grip.origin + point.shape[1] * grip.first + point.shape[2] * grip.second - grip.turn.cross(point.x);
    const Eigen::Vector3d trial = last->stretch + moved;
    stretch = trial - trial.dot(point.normal) * point.normal;
    const double length = stretch.norm(), longest = grip.coefficient * point.depth;
    if (length > longest) stretch *= longest / length;
    grip.loss += 0.5 * element.weight * (last->stretch + stretch).dot(trial - stretch);
  }
  grip.now.push_back({grip.element, point.number, stretch, element.weight});
  const Eigen::Vector3d drag = -element.weight * stretch;
  for (int i = 0; i < 3; ++i) sums.force[i] += point.shape[i] * drag;
  sums.couple += point.x.cross(drag);
  sums.energy += 0.5 * element.weight * stretch.squaredNorm();
}

template <class Body>
void add_point(const Element& element, const Body& impactor, int number, double xi, double eta, Grip* grip,
               ElementSums& sums) {
  const double shape[3] = {1.0 - xi - eta, xi, eta};
  const Eigen::Vector3d x = element.origin + xi * element.first + eta * element.second;
  const auto inside = impactor.depth(x);
  if (!inside) return;
  const double depth = inside->depth;
  sums.depth = std::max(sums.depth, depth);
  // Without a normal the depth exceeds the limit, and the caller throws.
  const bool has_normal = inside->length > 0.0;
  const Eigen::Vector3d push = (has_normal ? element.weight * depth / inside->length : 0.0) * inside->outward;
  for (int i = 0; i < 3; ++i) {
    sums.force[i] += shape[i] * push;
    sums.shape[i] += shape[i] * element.weight;
  }
  if constexpr (Body::kTurns) sums.couple += x.cross(push);
  sums.energy += 0.5 * element.weight * depth * depth;
  sums.area += element.weight;
  if (!grip || !has_normal) return;
  add_friction(element, {number, {shape[0], shape[1], shape[2]}, x, inside->normal(), depth}, *grip, sums);
}

// Adds the points (j + offset)/n of one row; of a long one only those that can lie in the impactor, and one
// more on either side. A chord costs as much as some eight points. `number` is the number of point j = 0.
template <class Body>
void add_row(const Element& element, const Body& impactor, int row, double offset, int count, int number,
             Grip* grip, ElementSums& sums) {
  const double n = element.subdivision;
  const double eta = (row + offset) / n;
  int begin = 0, end = count;
  if (constexpr int long_row = 8; count > long_row) {
    const auto inside = impactor.inside(element.origin + eta * element.second, element.first);
    if (!inside) return;
    const double low = inside->begin * n - offset - 1.0, high = inside->end * n - offset + 1.0;
    begin = static_cast<int>(std::clamp(std::ceil(low), 0.0, static_cast<double>(count)));
    end = static_cast<int>(std::clamp(std::floor(high) + 1.0, 0.0, static_cast<double>(count)));
  }
  for (int j = begin; j < end; ++j)
    add_point(element, impactor, number + j, (j + offset) / n, eta, grip, sums);
}

// Sums over the element's quadrature points inside the impactor. Null `grip`: no friction.
template <class Body>
ElementSums integrate(const Element& element, const Body& impactor, Grip* grip) {
  ElementSums sums;
  for (int row = 0, number = 0; row < element.subdivision; ++row) {
    const int up = element.subdivision - row, down = up - 1;
    add_row(element, impactor, row, 1.0 / 3.0, up, number, grip, sums);
    add_row(element, impactor, row, 2.0 / 3.0, down, number + up, grip, sums);
    number += up + down;
  }
  return sums;
}

}  // namespace coupling::detail
