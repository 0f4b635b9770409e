// SPDX-License-Identifier: Apache-2.0
#include "visibility/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace jet {

BoxTree::BoxTree(const Surface& surface) : elements_(static_cast<std::size_t>(surface.count)) {
  std::iota(elements_.begin(), elements_.end(), 0);
  std::size_t places = 1;
  for (int count = surface.count; count > kLeaf; count -= count / 2) places = 2 * places + 1;
  boxes_.assign(places, Box(surface, 0));
  build(surface, 0, 0, surface.count);
  for (int i = 0; i < 3; ++i)
    size_ = std::max({size_, std::abs(boxes_[0].low[i]), std::abs(boxes_[0].high[i])});
}

void BoxTree::build(const Surface& surface, std::size_t place, int first, int last) {
  const auto at = [&](int i) { return elements_.begin() + i; };
  Box& box = boxes_[place] = Box(surface, elements_[static_cast<std::size_t>(first)]);
  std::for_each(at(first), at(last), [&](int e) { box.take(Box(surface, e)); });
  if (last - first <= kLeaf) return;
  int side = 0;
  for (int i = 1; i < 3; ++i)
    if (box.high[i] - box.low[i] > box.high[side] - box.low[side]) side = i;
  const auto middle_of = [&](int e) {
    const Box own(surface, e);
    return own.low[side] / 2 + own.high[side] / 2;
  };
  const int middle = first + (last - first) / 2;
  std::nth_element(at(first), at(middle), at(last), [&](int e, int other) {
    const double x = middle_of(e), y = middle_of(other);
    return x < y || (x == y && e < other);
  });
  build(surface, 2 * place + 1, first, middle);
  build(surface, 2 * place + 2, middle, last);
}

}  // namespace jet
