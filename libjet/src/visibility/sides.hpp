// SPDX-License-Identifier: Apache-2.0
// Geometry of the fast route that is certain in double arithmetic. Each function has a stated bound of its
// roundings, or only compares coordinates, without rounding.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "visibility/blocking.hpp"
#include "visibility/filter.hpp"
#include "visibility/surface.hpp"

namespace jet {

/// Side of an element on which all sources are: 1 inner, -1 outer, 0 not certain. The plane's height over the
/// line of sources is linear, so its ends decide. Roundings: 186 u size |ab| |ac| with maximum norms,
/// u = 2^-53; doubled.
inline int common_side(const Surface& surface, int element, const RaySource& source, double size) {
  using Map = Eigen::Map<const Eigen::Vector3d>;
  const Map a(surface.corner(element, 0)), b(surface.corner(element, 1)), c(surface.corner(element, 2));
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const Eigen::Vector3d &o = source.centre, &l = source.long_direction;
  const double height = (a[0] - o[0]) * nx + (a[1] - o[1]) * ny + (a[2] - o[2]) * nz;
  const double change = source.half_long * std::abs(l[0] * nx + l[1] * ny + l[2] * nz);
  const double error = 4e-14 * size * filter::max3(std::abs(ux), std::abs(uy), std::abs(uz)) *
                           filter::max3(std::abs(vx), std::abs(vy), std::abs(vz)) +
                       filter::kUnderflow;
  return height - change > error ? 1 : height + change < -error ? -1 : 0;
}

/// True if all sources and the element lie in one coordinate plane. Every orientation is then 0, without any
/// arithmetic.
inline bool in_one_coordinate_plane(const Surface& surface, int element, const RaySource& source) {
  for (int i = 0; i < 3; ++i) {
    const double x = source.centre[i];
    const bool flat_source = source.half_long == 0.0 || source.long_direction[i] == 0.0;
    if (flat_source && surface.corner(element, 0)[i] == x && surface.corner(element, 1)[i] == x &&
        surface.corner(element, 2)[i] == x) {
      return true;
    }
  }
  return false;
}

struct Box {
  double low[3], high[3];

  Box(const Surface& surface, int element) {
    const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
                 *c = surface.corner(element, 2);
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(std::min(a[i], b[i]), c[i]);
      high[i] = std::max(std::max(a[i], b[i]), c[i]);
    }
  }
  bool holds(const double* s) const {
    return s[0] >= low[0] && s[0] <= high[0] && s[1] >= low[1] && s[1] <= high[1] && s[2] >= low[2] &&
           s[2] <= high[2];
  }
  /// True if the closed segment is on one side of the box; nothing is rounded.
  bool apart_from_segment(const blocking::Ray& ray) const {
    bool apart = false;
    for (int i = 0; i < 3; ++i) {
      apart |= (ray.source[i] < low[i]) & (ray.target[i] < low[i]);
      apart |= (ray.source[i] > high[i]) & (ray.target[i] > high[i]);
    }
    return apart;
  }
  /// The same; also true if the segment's line passes beside the box by more than the rounding. With m from
  /// the box's middle to the segment's, d half the segment and e half the box: |(m x d)_i| > e_j |d_k| + e_k
  /// |d_j|. `size` bounds the box's coordinates. Roundings: m and e err by 4 u size' each, size' >= size and
  /// the segment's ends, u = 2^-53, and every product by u: 16 u size' (|d_j| + |d_k|) in total; doubled.
  bool apart_from_line(const blocking::Ray& ray, double size) const {
    if (apart_from_segment(ray)) return true;
    double m[3], d[3], e[3], largest = size;
    for (int i = 0; i < 3; ++i) {
      m[i] = (ray.source[i] / 2 + ray.target[i] / 2) - (low[i] / 2 + high[i] / 2);
      d[i] = std::abs(ray.target[i] - ray.source[i]) / 2;
      e[i] = (high[i] - low[i]) / 2;
      largest = filter::max3(largest, std::abs(ray.source[i]), std::abs(ray.target[i]));
    }
    const double noise = 4e-15 * largest;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double side =
          m[j] * (ray.target[k] - ray.source[k]) / 2 - m[k] * (ray.target[j] - ray.source[j]) / 2;
      if (std::abs(side) > (e[j] + noise) * d[k] + (e[k] + noise) * d[j] + filter::kUnderflow) return true;
    }
    return false;
  }
  /// Grows to contain another box.
  void take(const Box& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};

}  // namespace jet
