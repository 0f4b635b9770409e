// SPDX-License-Identifier: Apache-2.0
// Eight rays at a time, with the elements that they may touch.
#pragma once

#include "visibility/touch_kernels.hpp"

namespace jet::JET_KERNELS {

/// Handles up to eight rays.
inline int find_pairs(const RayArrays& rays, int far_places, bool to_targets, const PyramidView& pyramid,
                      const int* patches, const PairLists& to) {
  const auto places = *reinterpret_cast<const UnalignedInts*>(rays.list);
  const auto step = __builtin_shufflevector(places, places, 1, 2, 3, 4, 5, 6, 7, 7) - places;
  const unsigned far = bits(Floats::Mask(step > far_places)) & ((1u << (rays.count - 1)) - 1u);
  if (far != 0) return -1 - __builtin_ctz(far);
  const Vec3<Floats> g = gather_rows(rays.targets, [&](int i) { return rays.list[i < rays.count ? i : 0]; });
  const unsigned there = 0xffu >> (8 - rays.count);
  const RayRanges own = ranges(g, rays.half_long);
  const Floats depth = to_targets ? g.z + kSlack : Floats(kFar);
  const Box box(own, depth);
  const Blocks blocks = blocks_near(pyramid, box, to);
  int *const boxes = blocks.next, near = 0;
  for (int i = 0; i < blocks.count; ++i) {
    const int block = blocks.list[i];
    near += append_bits(box.overlaps(pyramid.boxes + kBoxFloats * std::ptrdiff_t{block}), kBoxFloats * block,
                        boxes + near);
  }
  // Drops boxes beside all rays, without a branch.
  int *const meeting = blocks.list, met = 0;
  for (int i = 0; i < near; ++i) {
    const float* b = pyramid.boxes + static_cast<unsigned>(boxes[i]);
    const auto overlaps = (repeat(b) <= own.p.high) & (own.p.low <= repeat(b + 8)) &
                          (repeat(b + 16) <= own.q.high) & (own.q.low <= repeat(b + 24)) &
                          (repeat(b + 32) <= depth);
    const unsigned which = bits(overlaps) & there;
    boxes[met] = boxes[i];
    meeting[met] = static_cast<int>(which);
    met += which != 0;
  }
  int count = 0;
  for (int i = 0; i < met; ++i) {
    const unsigned at = static_cast<unsigned>(boxes[i]), block = at / kBoxFloats, lane = at % kBoxFloats;
    const int e = 8 * patches[block] + static_cast<int>(lane);
    const unsigned others = to_targets ? ~bits(places == e) : ~0u;
    *reinterpret_cast<UnalignedInts*>(to.elements + count) = UnalignedInts{} + e;
    count += append_chosen(static_cast<unsigned>(meeting[i]) & others, places, to.rays + count);
  }
  return count;
}

}  // namespace jet::JET_KERNELS
