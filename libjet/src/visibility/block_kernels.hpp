// SPDX-License-Identifier: Apache-2.0
// Eight rays at a time, with the elements that they may touch.
#pragma once

#include "visibility/touch_kernels.hpp"

namespace jet::JET_KERNELS {

/// Number of rays before the widest gap between two successive rays. Gaps in each direction count relative to
/// the box's width.
inline int rays_before_gap(const RayRanges& r, const Box& box, int count) {
  const float width_p = box.high_p.v[0] - box.low_p.v[0], width_q = box.high_q.v[0] - box.low_q.v[0];
  const auto distance = [](Floats x, int i) { return __builtin_fabsf(x.v[i] - x.v[i - 1]); };
  float widest = 0.0f;
  int before = 1;
  for (int i = 1; i < count; ++i) {
    const float gap = distance(r.p.low, i) * width_q + distance(r.q.low, i) * width_p;
    if (gap > widest) widest = gap, before = i;
  }
  return before;
}

/// Handles up to eight rays.
inline int find_pairs(const RayArrays& rays, const Parting& parting, bool to_targets,
                      const PyramidView& pyramid, const int* patches, const PairLists& to) {
  const auto places = *reinterpret_cast<const UnalignedInts*>(rays.list);
  const auto step = __builtin_shufflevector(places, places, 1, 2, 3, 4, 5, 6, 7, 7) - places;
  const unsigned far = bits(Floats::Mask(step > parting.places)) & ((1u << (rays.count - 1)) - 1u);
  if (far != 0) return -1 - __builtin_ctz(far);
  const Vec3<Floats> g = gather_rows(rays.targets, [&](int i) { return rays.list[i < rays.count ? i : 0]; });
  const unsigned there = 0xffu >> (8 - rays.count);
  const RayRanges own = ranges(g, rays.half_long);
  const Floats depth = to_targets ? g.z + kSlack : Floats(kFar);
  const Box box(own, depth);
  const Blocks blocks = blocks_near(pyramid, box, parting.blocks, to);
  if (!blocks.list) return -8 - rays_before_gap(own, box, rays.count);
  int *const boxes = blocks.next, near = 0;
  for (int i = 0; i < blocks.count; ++i) {
    const int block = blocks.list[i];
    near += append_bits(box.overlaps(pyramid.boxes + kBoxFloats * std::ptrdiff_t{block}), kBoxFloats * block,
                        boxes + near);
  }
  // Boxes beside all rays are dropped, without a branch.
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
