// SPDX-License-Identifier: Apache-2.0
// The rays of one query and a funnel that holds them, beyond their targets, too. The funnel only sorts out
// what no ray can meet; its bounds carry margins far above rounding, so they cost work at worst, never an
// answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blocking.hpp"
#include "frame.hpp"

namespace jet {

/// Convex region in the jet's frame, and a way out of the surface along which the winding number is counted.
///   u <= high_u + slope_high_u w,  u >= low_u + slope_low_u w, the same for v,  w >= low_w
struct Funnel {
  using Bits = long long __attribute__((vector_size(2 * sizeof(double))));

  double low_w = 0.0;
  Pair slope_low, slope_high, low, high;
  Pair way_slope, way_offset, way_margin;

  /// Bits of the sides on which a point lies outside. Corners that share one keep the element out: of the
  /// funnel if it is among kOutside, off the way if it is among kOffWay.
  static constexpr unsigned kOutside = 0x1f;
  static constexpr unsigned kOffWay = 0x1f0;
  unsigned code(const Local& x) const {
    const Pair off_way = x.side - (way_offset + way_slope * x.w);
    const Bits bits = ((x.side < low + slope_low * x.w) & Bits{1, 2}) |
                      ((x.side > high + slope_high * x.w) & Bits{4, 8}) |
                      ((off_way < -way_margin) & Bits{32, 64}) | ((off_way > way_margin) & Bits{128, 256});
    return static_cast<unsigned>(bits[0] | bits[1]) | (x.w < low_w ? 16u : 0u);
  }
};

/// Rays of the candidates, in their order. Allocates at reserve() alone.
class RayBundle {
 public:
  void reserve(std::size_t count);

  /// `size` bounds every coordinate of nodes and sources.
  void build(const Surface& surface, const RaySource& source, std::span<const int> candidates, double size);

  /// Certain that the element meets no way from one source to another, so that none lies on it.
  bool beside_sources(const Surface& surface, int element) const;

  std::vector<blocking::Ray> rays;
  bool bounded = false;  // there is a frame, and the funnel holds all rays but those in `aside`
  Frame frame;
  Funnel funnel;
  std::vector<std::uint32_t> aside;  // rays without length, too steep against the jet, or upstream
  blocking::Ray way_ray;  // the way from the first ray's source, moved, to a point outside the surface

 private:
  bool bound_slopes();
  void bound(const RaySource& source);
  void set_way(double size);

  double margin_ = 0.0;                      // [m] above rounding
  Eigen::Array3d low_source_, high_source_;  // box of all sources
};

}  // namespace jet
