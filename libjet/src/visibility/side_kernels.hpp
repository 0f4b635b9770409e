// SPDX-License-Identifier: Apache-2.0
// Elements near the rays: their boxes and the sides that they show. Answers are certain, as in
// box_kernels.hpp.
#pragma once

#include "visibility/box_kernels.hpp"

namespace jet::JET_KERNELS {

struct Sides {
  Floats::Mask inner, outer;
};

/// Sides of the elements' planes on which the sources are. A ray from (0, y, 0) keeps its v, unless y is the
/// line's end and v is beyond. So the sources whose rays can touch an element lie within its range of v,
/// clamped to the line. The height in the orientation errs by at most kUnit d (24 + 96 d). s.error covers
/// second-order errors, and ensures that the ray pierces its own target.
[[gnu::always_inline]] inline Sides sides(const PatchArrays& s, const Corners& t) {
  const auto& [a, b, c] = t;
  const Normal n = normal_of(a, b, c);
  const Floats height = a.x * n.x + a.y * n.y + a.z * n.z;
  const Floats error = kUnit * (n.size * (96.0f * n.size + 24.0f)) + s.error;
  const Floats end(s.half_long);
  const auto on_line = [&](Floats v) { return max(min(v, end), -end); };
  const Floats low = on_line(min(min(a.y, b.y), c.y) - Floats(kSlack)),
               high = on_line(max(max(a.y, b.y), c.y) + kSlack);
  const Floats middle = height - 0.5f * (low + high) * n.y, change = 0.5f * (high - low) * abs(n.y);
  return {middle - change > error, middle + change < -error};
}

/// True if the element is certainly not between two sources: it is beside their line, or all sources are on
/// one side of its plane.
[[gnu::always_inline]] inline Floats::Mask beside_sources(const PatchArrays& s, const Corners& t) {
  const auto& [a, b, c] = t;
  const Normal n = normal_of(a, b, c);
  const Floats height = a.x * n.x + a.y * n.y + a.z * n.z;
  const Floats error = kUnit * (n.size * (96.0f * n.size + 24.0f)) + s.error;
  const Floats whole = s.half_long * abs(n.y), slack(kSlack);
  const Floats low_u = min(min(a.x, b.x), c.x), high_u = max(max(a.x, b.x), c.x),
               low_w = min(min(a.z, b.z), c.z);
  return (low_w > slack) | (low_u > slack) | (high_u < -slack) | (height - whole > error) |
         (height + whole < -error);
}

/// Boxes of eight elements.
struct Boxes {
  Range p, q;
  Floats depth;

  [[gnu::always_inline]] void store(float* block) const {
    p.low.store(block);
    p.high.store(block + 8);
    q.low.store(block + 16);
    q.high.store(block + 24);
    depth.store(block + 32);
  }
};
[[gnu::always_inline]] inline Boxes boxes_of(const Corners& t, Floats depth, float half_long) {
  const auto& [a, b, c] = t;
  const Vec3<Floats> w = {a.z, b.z, c.z};
  const Range p = spanned(a.x, b.x, c.x, w, depth);
  if (half_long > 0.0f) {
    const Floats low = min(min(a.y, b.y), c.y), high = max(max(a.y, b.y), c.y);
    return {p, {low - Floats(kSlack), high + kSlack}, depth};
  }
  return {p, spanned(a.y, b.y, c.y, w, depth), depth};
}

/// Bounds of the two coordinates that are constant along the winding ray.
struct WindingRay {
  Range p, q;
  explicit WindingRay(const PatchArrays& s) : p(around(turned(s.winding_u))) {
    q = around(s.half_long > 0.0f ? s.winding_v : turned(s.winding_v));
  }
  [[gnu::always_inline]] unsigned overlaps(const Boxes& b) const {
    return bits((b.p.low <= p.high) & (p.low <= b.p.high) & (b.q.low <= q.high) & (q.low <= b.q.high));
  }

 private:
  static float turned(float slope) { return slope / (1.0f + (slope < 0.0f ? -slope : slope)); }
  static Range around(float place) { return {Floats(place - kTurn), Floats(place + kTurn)}; }
};

inline PatchesFound classify_patches(const PatchArrays& given) {
  const PatchArrays s = given;  // a copy, so that stores cannot change it
  const WindingRay winding_ray(s);
  PatchesFound found{};
  Bounds bounds;
  const int short_patch = s.elements / 8;  // the mesh's last patch, if it has less than eight elements
  const unsigned there_last = (1u << s.elements % 8) - 1u;
  for (int k = 0; k < s.count; ++k) {
    const int patch = s.patches[k];
    const std::uint32_t* rows = rows_of(s.corner_rows, patch);
    const auto corner = [&](int j) {
      return gather_four(s.local, [&](int i) { return static_cast<std::ptrdiff_t>(rows[8 * j + i]); });
    };
    const FourFloats a = corner(0), b = corner(1), c = corner(2);
    const auto code = [](const FourFloats& x) { return reinterpret_cast<Floats::Mask>(x.fourth.v); };
    const unsigned there = patch == short_patch ? there_last : 0xffu;
    const Floats::Mask common = code(a) & code(b) & code(c);
    const unsigned near = there & bits((common & s.outside) == 0);
    if (near == 0) continue;
    const Corners t = {a.point, b.point, c.point};
    const Floats depth = min(min(t.a.z, t.b.z), t.c.z);
    const Boxes boxes = boxes_of(t, depth, s.half_long);
    boxes.store(s.boxes + kBoxFloats * std::ptrdiff_t{found.near});
    const unsigned on_winding_ray = near & winding_ray.overlaps(boxes);
    const bool all_ahead = bits(depth <= Floats(kSlack)) == 0;  // nearly all patches
    const unsigned between = all_ahead ? 0u : near & ~bits(beside_sources(s, t));
    s.near[found.near++] = patch;
    const Sides side = sides(s, t);
    const unsigned inner = bits(side.inner) | (~there & 0xffu);
    s.inner[patch] = static_cast<std::uint8_t>(inner);
    s.not_inner[patch] = static_cast<std::uint8_t>(near & ~inner);
    const unsigned uncertain = near & ~(inner | bits(side.outer));
    if (uncertain != 0) found.uncertain += append_bits(uncertain, 8 * patch, s.uncertain + found.uncertain);
    if (between != 0) found.between += append_bits(between, 8 * patch, s.between + found.between);
    if (on_winding_ray != 0)
      found.on_winding_ray += append_bits(on_winding_ray, 8 * patch, s.on_winding_ray + found.on_winding_ray);
    const unsigned asked = s.asked[patch];
    if (asked == 0) continue;
    // The mean of three coordinates that err by kUnit / 2 errs by 2.5 kUnit.
    const auto mean = [](Floats x, Floats y, Floats z) { return (1.0f / 3.0f) * (x + y + z); };
    const Vec3<Floats> g = {mean(t.a.x, t.b.x, t.c.x), mean(t.a.y, t.b.y, t.c.y), mean(t.a.z, t.b.z, t.c.z)};
    store_rows([&](int i) { return s.targets + 4 * (8 * std::ptrdiff_t{patch} + i); }, g, Floats());
    const unsigned behind = asked & ~bits(bounds.take(g, mask_from_bits(asked), s.half_long, kSlack));
    if (behind != 0) found.upstream += append_bits(behind, 8 * patch, s.upstream + found.upstream);
    ++found.asked;
  }
  found.bounds = bounds.all();
  return found;
}

}  // namespace jet::JET_KERNELS
