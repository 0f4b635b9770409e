// SPDX-License-Identifier: Apache-2.0
// The blocking rule (J.7), shared by all routes. `Kernel` has exact predicates (orientation, slope,
// on_triangle), by CGAL alone or after a filter, and knows whether a source is moved.
#pragma once

#include <algorithm>

#include "jet/visibility.hpp"
#include "visibility/surface.hpp"

namespace jet::blocking {

/// True if the source lies on an element, so that source + eps axis replaces it. The fast route determines
/// this only when a predicate needs it.
enum class Moved : std::uint8_t { no, yes, unknown };
inline Moved moved_if(bool on_surface) {
  return on_surface ? Moved::yes : Moved::no;
}

/// The open segment of one candidate, from source to target.
struct Ray {
  double source[3];
  double target[3];
  const double* axis;
  mutable Moved moved;
};

/// End points in double arithmetic, in the order that the definition fixes. The source is not moved.
inline Ray make_ray(const Surface& surface, int element, const RaySource& from) {
  Ray ray{{from.centre[0], from.centre[1], from.centre[2]}, {}, from.axis.data(), Moved::no};
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  for (int i = 0; i < 3; ++i) ray.target[i] = ((a[i] + b[i]) + c[i]) / 3.0;
  if (from.half_long == 0.0) return ray;
  const double dx = ray.target[0] - from.centre[0];
  const double dy = ray.target[1] - from.centre[1];
  const double dz = ray.target[2] - from.centre[2];
  const Eigen::Vector3d& l = from.long_direction;
  const double t = std::clamp((dx * l[0] + dy * l[1]) + dz * l[2], -from.half_long, from.half_long);
  for (int i = 0; i < 3; ++i) ray.source[i] = from.centre[i] + t * l[i];
  return ray;
}

/// Sign of orientation(source, p, q, r); for eps -> 0+ if the source is moved.
template <class Kernel>
int orientation_from_source(Kernel& kernel, const Ray& ray, const double* p, const double* q,
                            const double* r) {
  const int sign = kernel.orientation(ray.source, p, q, r);
  if (sign != 0 || !kernel.moved(ray)) return sign;
  return -kernel.slope(ray.axis, p, q, r);
}

/// Side of an element that the source sees: 1 inner (facing), -1 outer, 0 none, as it lies in the plane.
template <class Kernel>
int facing(Kernel& kernel, const Ray& ray, const Surface& surface, int element) {
  return orientation_from_source(kernel, ray, surface.corner(element, 0), surface.corner(element, 1),
                                 surface.corner(element, 2));
}

/// Signs with which the line of the segment passes the three edges of an element.
struct Passage {
  int ab, bc, ca;
  bool touches() const { return std::min({ab, bc, ca}) >= 0 || std::max({ab, bc, ca}) <= 0; }
  bool pierces() const { return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0); }
};

template <class Kernel>
Passage passage(Kernel& kernel, const Ray& ray, const Surface& surface, int element) {
  const double* g = ray.target;
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  const int ab = orientation_from_source(kernel, ray, g, a, b);
  const int bc = orientation_from_source(kernel, ray, g, b, c);
  if (ab * bc < 0) return {ab, bc, 0};
  return {ab, bc, orientation_from_source(kernel, ray, g, c, a)};
}

/// True if the open segment meets the closed element and does not lie in its plane. Then the ends are
/// strictly on opposite sides of the plane. A degenerate element has no sides and never blocks.
template <class Kernel>
bool blocks(Kernel& kernel, const Ray& ray, const Surface& surface, int element) {
  const int near = facing(kernel, ray, surface, element);
  if (near == 0) return false;
  const int far = kernel.orientation(ray.target, surface.corner(element, 0), surface.corner(element, 1),
                                     surface.corner(element, 2));
  return near * far < 0 && passage(kernel, ray, surface, element).touches();
}

/// True if the source, not moved, lies on a closed element of non-zero area that is not absent.
template <class Kernel>
bool source_on(Kernel& kernel, const Ray& ray, const Surface& surface, int element) {
  return !surface.absent(element) &&
         kernel.on_triangle(ray.source, surface.corner(element, 0), surface.corner(element, 1),
                            surface.corner(element, 2));
}

}  // namespace jet::blocking
