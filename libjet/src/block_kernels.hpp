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
  unsigned possible, blocked, met;
};
[[gnu::always_inline]] inline Touches touch(const Line& r, const float* e, unsigned alive) {
  const auto point = [&](int i) { return Vec3<Floats>{Floats(e[i]), Floats(e[i + 8]), Floats(e[i + 16])}; };
  const Corners t = {point(0), point(24), point(48)};
  const Passing passing = pass(r, t);
  const unsigned possible = alive & bits(passing.possible());
  if (possible == 0) return {};
  const unsigned pierced = possible & bits(passing.pierced());
  const Ends end = ends(r, t);
  return {possible, pierced & bits(end.crossed), pierced & bits(end.beyond)};
}

inline int meet_blocks(const RayArrays& rays, int block, unsigned alive, const PyramidView& pyramid,
                       const float* points, const HitLists& to) {
  const float* targets = rays.targets + 32 * std::ptrdiff_t{block};
  const Line r = line_to(gather_rows(targets, [](int i) { return i; }), Floats(rays.half_long));
  const float* ray_boxes = rays.boxes + kBoxFloats * std::ptrdiff_t{block};
  float around[kBoxFloats];
  merge(ray_boxes, around);
  const Floats everything(kFar);  // before the target and behind it
  const Box box(around, everything);
  const int blocks = blocks_near(pyramid, box, to.first, to.second);
  int near = 0, count = 0;
  for (int i = 0; i < blocks; ++i) {
    const int entries = to.first[i];
    near += append_bits(box.overlaps(pyramid.boxes + kBoxFloats * std::ptrdiff_t{entries}), 8 * entries,
                        to.second + near);
  }
  // Those beside all rays are left out, without a branch to predict.
  int touched = 0;
  for (int i = 0; i < near; ++i) {
    const int e = to.second[i];
    const Box own(pyramid.boxes + kBoxFloats * std::ptrdiff_t{e / 8} + e % 8, everything);
    to.second[touched] = e;
    touched += static_cast<int>((own.overlaps(ray_boxes) & alive) != 0);
  }
  for (int i = 0; i < touched && alive != 0; ++i) {
    const int e = to.second[i];
    const Touches t = touch(r, points + kElementFloats * std::ptrdiff_t{e / 8} + e % 8, alive);
    for (unsigned rest = t.possible; rest != 0; rest &= rest - 1u) {
      const int ray = __builtin_ctz(rest);
      to.hits[count++] = kHitKinds * (8 * e + ray) + static_cast<int>(t.blocked >> ray & 1u) * kBlocked +
                         static_cast<int>(t.met >> ray & 1u) * kMet;
    }
    alive &= ~(t.blocked | t.met);
  }
  return count;
}

}  // namespace jet::JET_KERNELS
