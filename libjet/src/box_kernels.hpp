// SPDX-License-Identifier: Apache-2.0
// Boxes of rays and elements, and the sides that elements show. What these kernels say is certain: each
// states the error that its margins cover. kUnit stands for twice the error of a local coordinate.
#pragma once

#include "project_kernels.hpp"

namespace jet::JET_KERNELS {

inline constexpr float kUnit = 6.1e-8f;
inline constexpr float kFar = 1e30f;       // beyond every coordinate
inline constexpr float kUpstream = 1e-4f;  // what is not farther downstream may be upstream
inline constexpr float kSlack = 1e-6f;     // 16 kUnit, for places
inline constexpr float kTurn = 4e-6f;      // the same for slopes, over the distance from the sources

struct Range {
  Floats low, high;
};

/// u / (w + |u|), which orders like the slope u / w but stays bounded; what is upstream counts as at its
/// side,
/// +-1. Both coordinates err by kUnit, the slope by less than kUnit (1 + |u/w|) / w: kTurn covers 30 times
/// that.
[[gnu::always_inline]] inline Range turned(Floats u, Floats w) {
  const Floats inverse = 1.0f / (max(w, Floats()) + abs(u) + 1e-30f);
  const Floats place = u * inverse, margin = kTurn * inverse;
  return {place - margin, place + margin};
}

[[gnu::always_inline]] inline void store(float* block, Range p, Range q, Floats depth) {
  p.low.store(block);
  p.high.store(block + 8);
  q.low.store(block + 16);
  q.high.store(block + 24);
  depth.store(block + 32);
}

[[gnu::always_inline]] inline void store(float* points, const Vec3<Floats>& x) {
  x.x.store(points);
  x.y.store(points + 8);
  x.z.store(points + 16);
}
[[gnu::always_inline]] inline Vec3<Floats> load_points(const float* points) {
  return {Floats::load(points), Floats::load(points + 8), Floats::load(points + 16)};
}

/// Slopes u / w, which err by less than 2 kUnit (1 + |slope|) / w.
[[gnu::always_inline]] inline Range slopes(Floats u, Floats w) {
  const Floats inverse = 1.0f / w;
  const Floats slope = u * inverse, margin = kSlack * ((abs(slope) + 1.0f) * inverse);
  return {slope - margin, slope + margin};
}

/// Where rays from a line run along it: at the place of the target, or from the line's end on.
[[gnu::always_inline]] inline Range places(Vec3<Floats> g, Floats half_long) {
  const Floats margin = kTurn / (max(g.z, Floats()) + abs(g.x) + 1e-30f) + kSlack;
  const Floats end = half_long - Floats(kSlack);
  return {select(g.y < -end, Floats(-kFar), min(g.y, half_long) - margin),
          select(g.y > end, Floats(kFar), max(g.y, -half_long) + margin)};
}

inline RayBounds make_rays(const RayArrays& a, int count, std::uint8_t* aside) {
  const Floats half_long(a.half_long), far(kFar);
  Range u{far, -far}, v{far, -far};
  for (int k = 0; k < count; k += 8) {
    const Vec3<Floats> g = gather_rows(a.targets, [&](int i) { return k + i < count ? k + i : count - 1; });
    unsigned known = (k + 8 <= count ? 0xffu : (1u << (count - k)) - 1u);
    Floats::Mask valid = g.z > Floats(kSlack);
    for (int i = count - k; i < 8; ++i) valid[i] = 0;
    aside[k / 8] = static_cast<std::uint8_t>(known & ~bits(valid));
    const Range p = turned(g.x, g.z), q = a.half_long > 0.0f ? places(g, half_long) : turned(g.y, g.z);
    const auto empty = [&](Range r) { return Range{select(valid, r.low, far), select(valid, r.high, -far)}; };
    store(a.boxes + kBoxFloats / 8 * std::ptrdiff_t{k}, empty(p), empty(q), Floats());
    const Range slope_u = empty(slopes(g.x, g.z)), slope_v = empty(a.half_long > 0.0f ? q : slopes(g.y, g.z));
    u = {min(u.low, slope_u.low), max(u.high, slope_u.high)};
    v = {min(v.low, slope_v.low), max(v.high, slope_v.high)};
  }
  return {least(u.low), greatest(u.high), least(v.low), greatest(v.high)};
}

/// Range of a triangle's part downstream. If it reaches upstream, it must stay on one side; if not, it is
/// anywhere.
[[gnu::always_inline]] inline Range spanned(Floats a, Floats b, Floats c, const Vec3<Floats>& w,
                                            Floats::Mask upstream) {
  const Range ra = turned(a, w.x), rb = turned(b, w.y), rc = turned(c, w.z);
  const Floats::Mask one_side =
      (min(min(a, b), c) > Floats(kUpstream)) | (max(max(a, b), c) < Floats(-kUpstream));
  const Floats::Mask anywhere = upstream & ~one_side;
  return {select(anywhere, Floats(-kFar), min(min(ra.low, rb.low), rc.low)),
          select(anywhere, Floats(kFar), max(max(ra.high, rb.high), rc.high))};
}

struct Normal {
  Floats x, y, z, size;  // (b - a) x (c - a), and the largest coordinate d of the two edges
};
[[gnu::always_inline]] inline Normal normal_of(const Vec3<Floats>& a, const Vec3<Floats>& b,
                                               const Vec3<Floats>& c) {
  const Vec3<Floats> e = {b.x - a.x, b.y - a.y, b.z - a.z}, f = {c.x - a.x, c.y - a.y, c.z - a.z};
  return {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x, max(largest(e), largest(f))};
}

struct Corners {
  Vec3<Floats> a, b, c;
};
template <class Triangle>
[[gnu::always_inline]] inline Corners gather_corners(const float* local, const int* triangles, Triangle at) {
  const auto corner = [&](int j) {
    return gather_rows(local, [&](int i) { return triangles[3 * std::ptrdiff_t{at(i)} + j]; });
  };
  return {corner(0), corner(1), corner(2)};
}
[[gnu::always_inline]] inline Corners load_corners(const float* points) {
  return {load_points(points), load_points(points + 24), load_points(points + 48)};
}

[[gnu::always_inline]] inline void store(float* points, const Corners& t) {
  store(points, t.a);
  store(points + 24, t.b);
  store(points + 48, t.c);
}

struct Sides {
  Floats::Mask inner, outer, between;
};

/// Sides of the planes that the sources are on. A ray from (0, y, 0) keeps its v, unless y is the line's end
/// and v is beyond: so the sources from which an element can be touched lie within its own range of v,
/// clamped to the line. The orientation's height over them errs by kUnit d (24 + 96 d) at most; s.error
/// covers second orders, and what makes the ray pierce its own target.
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
  const Floats whole = end * abs(n.y), slack(kSlack);
  const Floats low_u = min(min(a.x, b.x), c.x), high_u = max(max(a.x, b.x), c.x),
               low_w = min(min(a.z, b.z), c.z);
  const auto beside = (low_w > slack) | (low_u > slack) | (high_u < -slack);
  return {middle - change > error, middle + change < -error,
          ~(beside | (height - whole > error) | (height + whole < -error))};
}

/// The line may touch the triangles: it is within their range of v, and on the way across.
[[gnu::always_inline]] inline Floats::Mask on_way(const float* way, const Corners& t) {
  const auto within = [](float slope, Floats a, Floats b, Floats c) {
    const float margin = kTurn * (1.0f + (slope < 0.0f ? -slope : slope));
    return (min(min(a, b), c) <= Floats(margin)) & (max(max(a, b), c) >= Floats(-margin));
  };
  const auto across = [&](const Vec3<Floats>& x) { return x.x - way[0] * x.z; };
  const auto along = [&](const Vec3<Floats>& x) { return x.y - (way[1] * x.z + way[2]); };
  return within(way[0], across(t.a), across(t.b), across(t.c)) &
         within(way[1], along(t.a), along(t.b), along(t.c));
}

inline void look_at_patches(const PatchArrays& given) {
  const PatchArrays s = given;  // a copy, which what is stored cannot change
  for (int k = 0; k < s.count; ++k) {
    const int patch = s.patches[k];
    const Corners t = gather_corners(s.local, s.triangles, [&](int i) { return 8 * patch + i; });
    store(s.points + kElementFloats * std::ptrdiff_t{k}, t);
    const int left = s.elements - 8 * patch;
    const unsigned there = left < 8 ? (1u << left) - 1u : 0xffu;
    const Sides side = sides(s, t);
    s.inner[patch] = static_cast<std::uint8_t>(bits(side.inner) | (~there & 0xffu));
    s.outer[patch] = static_cast<std::uint8_t>(bits(side.outer) & there);
    s.between[k] = static_cast<std::uint8_t>(bits(side.between) & there);
    s.on_way[k] = static_cast<std::uint8_t>(bits(on_way(s.way, t)) & there);
  }
}

/// Eight boxes of elements.
[[gnu::always_inline]] inline void store_boxes(float* boxes, const Corners& t, float half_long) {
  const auto& [a, b, c] = t;
  const Vec3<Floats> w = {a.z, b.z, c.z};
  const Floats depth = min(min(w.x, w.y), w.z);
  const Floats::Mask upstream = depth <= Floats(kUpstream);
  const Range p = spanned(a.x, b.x, c.x, w, upstream);
  if (half_long > 0.0f) {
    const Floats low = min(min(a.y, b.y), c.y), high = max(max(a.y, b.y), c.y);
    store(boxes, p, {low - Floats(kSlack), high + kSlack}, depth);
  } else {
    store(boxes, p, spanned(a.y, b.y, c.y, w, upstream), depth);
  }
}

inline void element_boxes(const float* points, float half_long, int patches, float* boxes) {
  for (std::ptrdiff_t k = 0; k < patches; ++k)
    store_boxes(boxes + kBoxFloats * k, load_corners(points + kElementFloats * k), half_long);
}

}  // namespace jet::JET_KERNELS
