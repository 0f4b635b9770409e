// SPDX-License-Identifier: Apache-2.0
// Blocks of eight rays against elements.
#pragma once

#include "touch_kernels.hpp"

namespace jet::JET_KERNELS {

/// What is certain of eight rays and one element, as bits.
struct Touches {
  unsigned possible, pierced, crossed, beyond;
};
[[gnu::always_inline]] inline Touches touch(const Line& r, const float* local, const std::uint32_t* rows,
                                            unsigned alive) {
  const auto corner = [&](int j) {
    const float* x = local + rows[8 * j];
    return Vec3<Floats>{repeat(x), repeat(x + 1), repeat(x + 2)};
  };
  const Corners t = {corner(0), corner(1), corner(2)};
  const Passing passing = pass(r, t);
  const unsigned possible = alive & ~bits(passing.missed());
  if (possible == 0) return {};
  const unsigned pierced = possible & bits(passing.pierced());
  const Ends end = ends(r, t);
  return {possible, pierced, pierced & bits(end.crossed), bits(end.beyond)};
}

/// Rays before the widest gap between two that follow each other, each way against the box's width.
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

/// Up to eight rays.
inline int meet(const RayArrays& rays, const Parting& parting, bool to_targets, const PyramidView& pyramid,
                const ElementArrays& elements, const HitLists& to) {
  const auto own_places = *reinterpret_cast<const UnalignedInts*>(rays.list);
  const auto step = __builtin_shufflevector(own_places, own_places, 1, 2, 3, 4, 5, 6, 7, 7) - own_places;
  const unsigned far = bits(Floats::Mask(step > parting.places)) & ((1u << (rays.count - 1)) - 1u);
  if (far != 0) return -1 - __builtin_ctz(far);
  const Vec3<Floats> g = gather_rows(rays.targets, [&](int i) { return rays.list[i < rays.count ? i : 0]; });
  unsigned alive = 0xffu >> (8 - rays.count);
  const RayRanges own = ranges(g, rays.half_long);
  const Floats depth = to_targets ? g.z + kSlack : Floats(kFar);
  const Box box(own, depth);
  const Blocks blocks = blocks_near(pyramid, box, parting.blocks, to);
  if (!blocks.list) return -8 - rays_before_gap(own, box, rays.count);
  int* const boxes = blocks.next;
  int near = 0, count = 0;
  for (int i = 0; i < blocks.count; ++i) {
    const int block = blocks.list[i];
    near += append_bits(box.overlaps(pyramid.boxes + kBoxFloats * std::ptrdiff_t{block}), kBoxFloats * block,
                        boxes + near);
  }
  // Those beside all rays are left out, without a branch to predict.
  const unsigned lines = to_targets ? 0u : 0xffu;  // rays that count beyond their targets
  int* touched = boxes;
  for (const int *at = boxes, *end = at + near; at < end; ++at) {
    const float* b = pyramid.boxes + static_cast<unsigned>(*at);
    const auto overlaps = (repeat(b) <= own.p.high) & (own.p.low <= repeat(b + 8)) &
                          (repeat(b + 16) <= own.q.high) & (own.q.low <= repeat(b + 24)) &
                          (repeat(b + 32) <= depth);
    *touched = *at;
    touched += (bits(overlaps) & alive) != 0;
  }
  if (touched == boxes) return 0;
  const Line r = line_to(g, Floats(rays.half_long));
  for (const int* at = boxes; at < touched && alive != 0; ++at) {
    const unsigned box_at = static_cast<unsigned>(*at), block = box_at / kBoxFloats,
                   lane = box_at % kBoxFloats;
    const int patch = elements.patches[block], e = 8 * patch + static_cast<int>(lane);
    const unsigned others = to_targets ? ~bits(own_places == e) : ~0u;
    const std::uint32_t* rows = rows_of(elements.corner_rows, patch, lane);
    const Touches t = touch(r, elements.local, rows, alive & others);
    if (t.possible == 0) continue;
    const unsigned met = t.pierced & t.beyond;
    for (unsigned rest = t.possible & (lines | ~t.beyond); rest != 0; rest &= rest - 1u) {
      const int ray = __builtin_ctz(rest);
      to.hits[count++] = kHitKinds * (8 * e + ray) + static_cast<int>(t.crossed >> ray & 1u) * kBlocked +
                         static_cast<int>(met >> ray & 1u) * kMet;
    }
    alive &= ~((t.crossed | met) & lines);
  }
  return count;
}

}  // namespace jet::JET_KERNELS
