// SPDX-License-Identifier: Apache-2.0
// The rays of one query and a funnel that holds all of them, beyond their targets, too. The funnel only sorts
// out what no ray can meet; its bounds carry margins far above rounding, so they cost work at worst, never an
// answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blocking.hpp"

namespace jet {

/// Convex region in coordinates chosen along the jet: xw the coordinate nearest the axis, counted along it.
///   xu <= high_u + slope_high_u xw,  xu >= low_u + slope_low_u xw, the same for xv,  xw >= low_w
/// and the line of one ray in it, towards which the winding number is counted.
struct Funnel {
  /// The values for xu and xv side by side: the compiler's portable vectors.
  using Pair = double __attribute__((vector_size(2 * sizeof(double))));
  using Bits = long long __attribute__((vector_size(2 * sizeof(double))));

  bool bounded = false;
  int u = 1, v = 2, w = 0;
  double sign = 1.0;
  double low_w = 0.0;
  Pair slope_low, slope_high, low, high;
  Pair way_slope, way_offset, way_margin;

  /// Bits of the sides on which a point lies outside. Corners that share a bit keep the element out: the low
  /// five bits out of the funnel, the others away from the way.
  static constexpr unsigned kOutside = 0x1f;
  unsigned code(const double* x) const {
    const double xw = sign * x[w];
    const Pair at = {x[u], x[v]};
    const Pair off_way = at - (way_offset + way_slope * xw);
    const Bits bits = ((at < low + slope_low * xw) & Bits{1, 2}) |
                      ((at > high + slope_high * xw) & Bits{4, 8}) |
                      ((off_way < -way_margin) & Bits{32, 64}) | ((off_way > way_margin) & Bits{128, 256});
    return static_cast<unsigned>(bits[0] | bits[1]) | (xw < low_w ? 16u : 0u);
  }
};

/// Rays of the candidates, in their order. Allocates at reserve() alone.
class RayBundle {
 public:
  void reserve(std::size_t count);

  /// `size` bounds every coordinate of nodes and sources.
  void build(const Surface& surface, const RaySource& source, std::span<const int> candidates, double size);

  std::vector<blocking::Ray> rays;
  Funnel funnel;
  std::size_t way = 0;    // ray along which the winding number is counted
  blocking::Ray way_ray;  // that ray from its source, moved, to a point outside the surface; set if bounded

 private:
  void bound(const RaySource& source, double size);
  bool bound_slopes(double size);
  void set_way(double size);
};

}  // namespace jet
