// SPDX-License-Identifier: Apache-2.0
// Tree of boxes of elements, for rays without a frustum. Only leaves test the blocking rule.
#pragma once

#include <vector>

#include "visibility/sides.hpp"

namespace jet {

/// Binary tree over the elements of one surface at one instant; each node is halved at its middle element
/// along its longest side. Boxes contain their corners exactly. The search skips a box only if the ray
/// certainly misses it, so no ray loses a blocker.
class BoxTree {
 public:
  explicit BoxTree(const Surface& surface);

  /// True if `accept(element)` is true for an element whose box the ray's segment may meet.
  template <class Accept>
  bool any(const blocking::Ray& ray, Accept&& accept) const {
    return any(ray, accept, 0, 0, static_cast<int>(elements_.size()));
  }

 private:
  static constexpr int kLeaf = 4;  // elements

  /// Node `place` holds elements_[first] to elements_[last - 1]; its halves are 2 place + 1 and 2 place + 2.
  template <class Accept>
  bool any(const blocking::Ray& ray, Accept& accept, std::size_t place, int first, int last) const {
    if (boxes_[place].apart_from_line(ray, size_)) return false;
    if (last - first <= kLeaf) {
      for (int i = first; i < last; ++i)
        if (accept(elements_[static_cast<std::size_t>(i)])) return true;
      return false;
    }
    const int middle = first + (last - first) / 2;
    return any(ray, accept, 2 * place + 1, first, middle) || any(ray, accept, 2 * place + 2, middle, last);
  }
  void build(const Surface& surface, std::size_t place, int first, int last);

  std::vector<int> elements_;
  std::vector<Box> boxes_;  // by place
  double size_ = 0.0;       // [m] largest magnitude of a coordinate
};

}  // namespace jet
