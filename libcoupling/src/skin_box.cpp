// SPDX-License-Identifier: Apache-2.0
#include "skin_box.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace coupling::detail {

Point along_directions(const Eigen::Vector3d& x) {
  // The axes and the diagonals of a cube.
  constexpr float third = 0.57735026F;
  const auto a = static_cast<float>(x[0]), b = static_cast<float>(x[1]), c = static_cast<float>(x[2]);
  const float sum = third * (a + b), difference = third * (a - b), d = third * c;
  return {a, b, c, sum + d, sum - d, difference + d, difference - d, 0.0F};
}

float gap(const Box& a, const Box& b) {
  float gap = -std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < kDirections; ++k)
    gap = std::max(gap, std::max(a.low[k] - b.high[k], b.low[k] - a.high[k]));
  return gap;
}

std::vector<std::pair<int, int>> near_boxes(const std::vector<Box>& boxes, float reach) {
  Box all = empty_box();
  for (const Box& box : boxes) add(all, box);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (all.high[k] - all.low[k] > all.high[axis] - all.low[axis]) axis = k;
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box_of = [&](int g) -> const Box& { return boxes[static_cast<std::size_t>(g)]; };
  std::ranges::sort(order, {}, [&](int g) { return std::pair(box_of(g).low[axis], g); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& a = box_of(order[i]);
    for (std::size_t j = i; j < order.size() && box_of(order[j]).low[axis] - a.high[axis] <= reach; ++j)
      if (gap(a, box_of(order[j])) <= reach) pairs.push_back(std::minmax(order[i], order[j]));
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace coupling::detail
