// SPDX-License-Identifier: Apache-2.0
// Exact winding number of a ray's source: outward minus inward crossings of the winding ray, which runs to a
// point outside the surface.
#pragma once

#include <optional>

#include "visibility/blocking.hpp"

namespace jet::winding {

struct Box {
  double low[3];
  double high[3];
};

inline Box bounding_box(const Surface& surface) {
  const double* first = surface.corner(0, 0);
  Box box{{first[0], first[1], first[2]}, {first[0], first[1], first[2]}};
  for (int e = 0; e < surface.count; ++e) {
    for (int corner = 0; corner < 3; ++corner) {
      const double* x = surface.corner(e, corner);
      for (int i = 0; i < 3; ++i) {
        box.low[i] = std::min(box.low[i], x[i]);
        box.high[i] = std::max(box.high[i], x[i]);
      }
    }
  }
  return box;
}

/// Contribution of one element to the crossings; std::nullopt if the winding ray is not generic.
template <class Kernel>
std::optional<int> crossing(Kernel& kernel, const blocking::Ray& ray, const Surface& surface, int element) {
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  const int near = blocking::orientation_from_source(kernel, ray, a, b, c);
  const int far = kernel.orientation(ray.target, a, b, c);
  if (near == 0) {
    // The source is in the plane. It crosses only if it stays on the element or the whole ray lies in the
    // plane.
    if (kernel.moved(ray) && exact::stays_on_triangle(ray.source, ray.axis, a, b, c)) return std::nullopt;
    if (far == 0 && !exact::collinear(a, b, c)) return std::nullopt;
    return 0;
  }
  if (near * far >= 0) return 0;
  const blocking::Passage passage = blocking::passage(kernel, ray, surface, element);
  if (passage.pierces()) return near;
  if (passage.touches()) return std::nullopt;
  return 0;
}

inline constexpr int kDirections = 8;

/// Point `k` outside the box; each is in another direction. False if rounding leaves it inside.
inline bool far_point(const Box& box, int k, double* point) {
  constexpr double directions[kDirections][3] = {
      {1.0, 0.137, 0.291},  {-0.173, 1.0, 0.319},  {0.231, -0.113, 1.0}, {-1.0, 0.271, -0.193},
      {0.157, -1.0, 0.211}, {-0.311, 0.187, -1.0}, {1.0, 0.719, -0.653}, {-0.593, 1.0, 0.811}};
  const double size =
      std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
  bool outside = false;
  for (int i = 0; i < 3; ++i) {
    point[i] = 0.5 * (box.low[i] + box.high[i]) + 2.0 * size * directions[k][i];
    outside = outside || point[i] < box.low[i] || point[i] > box.high[i];
  }
  return outside;
}

/// Winding number of `ray`'s source, moved if the ray is marked as moved. Preconditions: the surface is
/// closed, and `box` contains it.
template <class Kernel>
std::optional<int> number(Kernel& kernel, const blocking::Ray& ray, const Surface& surface, const Box& box) {
  blocking::Ray winding_ray = ray;
  for (int k = 0; k < kDirections; ++k) {
    if (!far_point(box, k, winding_ray.target)) continue;
    int sum = 0;
    bool generic = true;
    for (int e = 0; e < surface.count && generic; ++e) {
      const std::optional<int> part = crossing(kernel, winding_ray, surface, e);
      generic = part.has_value();
      sum += part.value_or(0);
    }
    if (generic) return sum;
  }
  return std::nullopt;
}

}  // namespace jet::winding
