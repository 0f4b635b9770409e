// SPDX-License-Identifier: Apache-2.0
// Pyramid of boxes in a plane: one box above eight, in the order given. The mesh's order keeps neighbours
// together, so the upper boxes are small.
#pragma once

#include <cmath>
#include <vector>

#include "kernel_table.hpp"

namespace jet {

class Pyramid {
 public:
  /// Reserves room for this number of blocks of eight boxes and for the levels above.
  void reserve(std::size_t blocks) {
    std::size_t all = blocks;
    for (std::size_t n = blocks; n > 1; n = (n + 7) / 8) all += (n + 7) / 8;
    boxes_.resize(kBoxFloats * all);
  }

  /// Boxes of the lowest level, written by the caller, kBoxFloats for eight: low p, high p, low q, high q,
  /// lowest depth.
  float* boxes() { return boxes_.data(); }

  /// Builds the levels above this number of blocks. Precondition: all their boxes are written.
  void build(int blocks) {
    const auto merge = kernel_table().merge;
    view_ = {boxes_.data(), 1, {}, {blocks}};
    for (; blocks > 1; blocks = (blocks + 7) / 8) {
      const int below = view_.first[view_.levels - 1], above = below + blocks;
      merge(block(below), blocks, block(above));
      clear(above, blocks);
      view_.first[view_.levels] = above;
      view_.last[view_.levels++] = above + (blocks + 7) / 8;
    }
  }

  const PyramidView& view() const { return view_; }

 private:
  float* block(int b) { return boxes_.data() + kBoxFloats * b; }
  void clear(int first_block, int count) {
    for (int i = count; i % 8 != 0; ++i) {
      float* box = block(first_block + i / 8) + i % 8;
      box[0] = box[16] = HUGE_VALF;
      box[8] = box[24] = -HUGE_VALF;
    }
  }

  std::vector<float> boxes_;
  PyramidView view_{};
};

}  // namespace jet
