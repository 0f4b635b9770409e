// SPDX-License-Identifier: Apache-2.0
// Blocks of eight rays against elements.
#pragma once

#include "touch_kernels.hpp"

namespace jet::JET_KERNELS {

inline void gather_elements(const ElementArrays& s, int count) {
  for (int k = 0; k < count; k += 8) {
    const Corners t = gather_corners(s.local, s.triangles, [&](int i) { return s.elements[k + i]; });
    store_boxes(s.boxes + kBoxFloats / 8 * std::ptrdiff_t{k}, t, s.half_long);
    store(s.points + kElementFloats / 8 * std::ptrdiff_t{k}, t);
  }
}

/// What is certain of eight rays and one element, as bits.
struct Touches {
  unsigned possible, pierced, crossed, beyond;
};
[[gnu::always_inline]] inline Touches touch(const Line& r, const float* e, unsigned alive) {
  const auto point = [&](int i) {
    return Vec3<Floats>{repeat(e + i), repeat(e + i + 8), repeat(e + i + 16)};
  };
  const Corners t = {point(0), point(24), point(48)};
  const Passing passing = pass(r, t);
  const unsigned possible = alive & bits(passing.possible());
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
inline int meet(const RayArrays& rays, int most_blocks, bool to_targets, const PyramidView& pyramid,
                const float* points, const HitLists& to) {
  const Vec3<Floats> g = gather_rows(rays.targets, [&](int i) { return rays.list[i < rays.count ? i : 0]; });
  unsigned alive = 0xffu >> (8 - rays.count);
  const RayRanges own = ranges(g, rays.half_long);
  const Floats depth = to_targets ? g.z + kSlack : Floats(kFar);
  const Box box(own, depth);
  const int blocks = blocks_near(pyramid, box, most_blocks, to.first, to.second);
  if (blocks < 0) return -rays_before_gap(own, box, rays.count);
  int near = 0, count = 0;
  for (int i = 0; i < blocks; ++i) {
    const int block = to.first[i];
    near += append_bits(box.overlaps(pyramid.boxes + kBoxFloats * std::ptrdiff_t{block}), kBoxFloats * block,
                        to.second + near);
  }
  // Those beside all rays are left out, without a branch to predict.
  const unsigned lines = to_targets ? 0u : 0xffu;  // rays that count beyond their targets
  int touched = 0;
  for (int i = 0; i < near; ++i) {
    const int box_at = to.second[i];
    const float* b = pyramid.boxes + box_at;
    const auto overlaps = (repeat(b) <= own.p.high) & (own.p.low <= repeat(b + 8)) &
                          (repeat(b + 16) <= own.q.high) & (own.q.low <= repeat(b + 24)) &
                          (repeat(b + 32) <= depth);
    to.second[touched] = box_at;
    touched += static_cast<int>((bits(overlaps) & alive) != 0);
  }
  const Line r = line_to(g, Floats(rays.half_long));
  for (int i = 0; i < touched && alive != 0; ++i) {
    const unsigned box_at = static_cast<unsigned>(to.second[i]), block = box_at / kBoxFloats,
                   lane = box_at % kBoxFloats;
    const Touches t = touch(r, points + kElementFloats * std::size_t{block} + lane, alive);
    if (t.possible == 0) continue;
    const int e = static_cast<int>(8 * block + lane);
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
