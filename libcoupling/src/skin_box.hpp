// SPDX-License-Identifier: Apache-2.0
// Boxes with bounds along seven directions, in single precision.
#pragma once
#include <Eigen/Core>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "skin_lanes.hpp"

namespace coupling::detail {

// Directions along which a box has bounds: the axes first.
inline constexpr int kDirections = 7;
/// Coordinates [m] of a point along the directions; the last number is 0.
using Point = std::array<float, 8>;
Point along_directions(const Eigen::Vector3d& x);

/// Bounds [m] along the directions.
struct Box {
  std::array<float, 8> low, high;  // the last one is not used
};
inline Box empty_box() {
  Box box;
  box.low.fill(std::numeric_limits<float>::infinity());
  box.high.fill(-std::numeric_limits<float>::infinity());
  return box;
}
/// Makes the box hold another one, or a point.
inline void add(Box& box, const Box& other) {
  for (std::size_t k = 0; k < 8; k += 4) {
    store(box.low.data() + k, smaller(load(box.low.data() + k), load(other.low.data() + k)));
    store(box.high.data() + k, larger(load(box.high.data() + k), load(other.high.data() + k)));
  }
}
inline void add(Box& box, const Point& point) {
  add(box, {point, point});
}
/// Distance of two boxes along one of the directions [m]; negative if they overlap.
float gap(const Box& a, const Box& b);

/// Pairs of boxes not farther apart than `reach` [m], each with itself too; lower number first, ascending.
std::vector<std::pair<int, int>> near_boxes(const std::vector<Box>& boxes, float reach);

}  // namespace coupling::detail
