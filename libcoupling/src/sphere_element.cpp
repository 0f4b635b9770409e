// SPDX-License-Identifier: Apache-2.0
#include "sphere_element.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

struct Point {
  int number;
  double shape[3];
  Vector3d x;       // [m] from the centre
  Vector3d normal;  // of the impactor's surface, outwards
  double depth;     // [m]
};

// The bristle of this point at the last level. Bristles skipped before it have left the sphere.
const Bristle* find(Grip& grip, int number) {
  for (; grip.passed < grip.before.size(); ++grip.passed) {
    const Bristle& b = grip.before[grip.passed];
    if (b.element > grip.element || (b.element == grip.element && b.point > number)) return nullptr;
    if (b.element == grip.element && b.point == number) return &grip.before[grip.passed++];
    grip.loss += 0.5 * b.weight * b.stretch.squaredNorm();
  }
  return nullptr;
}

// (K.16), (K.17): the stretch follows the skin's motion against the sphere, limited to mu times the depth.
void add_friction(const Element& element, const Point& point, Grip& grip, ElementSums& sums) {
  Vector3d stretch = Vector3d::Zero();
  if (const Bristle* last = find(grip, point.number)) {
    const Vector3d moved =
        grip.origin + point.shape[1] * grip.first + point.shape[2] * grip.second - grip.turn.cross(point.x);
    const Vector3d trial = last->stretch + moved;
    stretch = trial - trial.dot(point.normal) * point.normal;
    const double length = stretch.norm(), longest = grip.coefficient * point.depth;
    if (length > longest) stretch *= longest / length;
    grip.loss += 0.5 * element.weight * (last->stretch + stretch).dot(trial - stretch);
  }
  grip.now.push_back({grip.element, point.number, stretch, element.weight});
  const Vector3d drag = -element.weight * stretch;
  for (int i = 0; i < 3; ++i) sums.force[i] += point.shape[i] * drag;
  sums.couple += point.x.cross(drag);
  sums.energy += 0.5 * element.weight * stretch.squaredNorm();
}

void add_point(const Element& element, const Impactor& impactor, int number, double xi, double eta,
               Grip* grip, ElementSums& sums) {
  Point point{number,
              {1.0 - xi - eta, xi, eta},
              element.origin + xi * element.first + eta * element.second,
              Vector3d::Zero(),
              0.0};
  const auto inside = impactor.depth(point.x);
  if (!inside) return;
  point.depth = inside->depth;
  sums.depth = std::max(sums.depth, point.depth);
  // Without a normal the depth exceeds the limit, and the caller throws.
  const bool has_normal = inside->length > 0.0;
  const Vector3d push = (has_normal ? element.weight * point.depth / inside->length : 0.0) * inside->outward;
  for (int i = 0; i < 3; ++i) {
    sums.force[i] += point.shape[i] * push;
    sums.shape[i] += point.shape[i] * element.weight;
  }
  sums.energy += 0.5 * element.weight * point.depth * point.depth;
  sums.area += element.weight;
  if (!grip || !has_normal) return;
  point.normal = inside->normal();
  add_friction(element, point, *grip, sums);
}

// Adds the points (j + offset)/n of one row that can lie in the impactor, and one more on either side.
// `number` is the number of point j = 0.
void add_row(const Element& element, const Impactor& impactor, int row, double offset, int count, int number,
             Grip* grip, ElementSums& sums) {
  const double n = element.subdivision;
  const double eta = (row + offset) / n;
  const auto inside = impactor.inside(element.origin + eta * element.second, element.first);
  if (!inside) return;
  const double low = inside->begin * n - offset - 1.0, high = inside->end * n - offset + 1.0;
  const int begin = static_cast<int>(std::clamp(std::ceil(low), 0.0, static_cast<double>(count)));
  const int end = static_cast<int>(std::clamp(std::floor(high) + 1.0, 0.0, static_cast<double>(count)));
  for (int j = begin; j < end; ++j)
    add_point(element, impactor, number + j, (j + offset) / n, eta, grip, sums);
}

}  // namespace

ElementSums integrate(const Element& element, const Impactor& impactor, Grip* grip) {
  ElementSums sums;
  for (int row = 0, number = 0; row < element.subdivision; ++row) {
    const int up = element.subdivision - row, down = up - 1;
    add_row(element, impactor, row, 1.0 / 3.0, up, number, grip, sums);
    add_row(element, impactor, row, 2.0 / 3.0, down, number + up, grip, sums);
    number += up + down;
  }
  return sums;
}

double release_rest(Grip& grip) {
  grip.element = std::numeric_limits<int>::max();
  find(grip, 0);
  return grip.loss;
}

}  // namespace coupling::detail
