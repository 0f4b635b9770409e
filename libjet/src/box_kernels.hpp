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

[[gnu::always_inline]] inline void store(float* block, Range p, Range q) {
  p.low.store(block);
  p.high.store(block + 8);
  q.low.store(block + 16);
  q.high.store(block + 24);
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

inline RayBounds ray_boxes(const BoxArrays& a, int count, std::uint8_t* aside) {
  const Floats half_long(a.half_long), far(kFar);
  Range u{far, -far}, v{far, -far};
  for (int k = 0; k < count; k += 8) {
    const Vec3<Floats> g = gather_rows(a.local, [&](int i) { return k + i < count ? k + i : count - 1; });
    unsigned known = (k + 8 <= count ? 0xffu : (1u << (count - k)) - 1u);
    Floats::Mask valid = g.z > Floats(kSlack);
    for (int i = count - k; i < 8; ++i) valid[i] = 0;
    aside[k / 8] = static_cast<std::uint8_t>(known & ~bits(valid));
    const Range p = turned(g.x, g.z), q = a.half_long > 0.0f ? places(g, half_long) : turned(g.y, g.z);
    const auto empty = [&](Range r) { return Range{select(valid, r.low, far), select(valid, r.high, -far)}; };
    store(a.boxes + 4 * std::ptrdiff_t{k}, empty(p), empty(q));
    float* points = a.points + kRayFloats / 8 * std::ptrdiff_t{k};
    store(points, g);
    max(min(g.y, half_long), -half_long).store(points + 24);
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

struct Sides {
  Floats::Mask inner, outer;
};

/// All sources lie on the inner side of the planes, or all on the outer side. The orientation's height errs
/// by kUnit d (24 + 96 d) at most; s.error covers second orders, and what makes the ray pierce its own
/// target.
[[gnu::always_inline]] inline Sides sides(const BoxArrays& s, const Vec3<Floats>& a, const Vec3<Floats>& b,
                                          const Vec3<Floats>& c) {
  const Normal n = normal_of(a, b, c);
  const Floats height = a.x * n.x + a.y * n.y + a.z * n.z;
  const Floats change = s.half_long * abs(n.y), error = kUnit * (n.size * (96.0f * n.size + 24.0f)) + s.error;
  return {height - change > error, height + change < -error};
}

inline void element_boxes(const BoxArrays& s, int count) {
  for (int k = 0; k < count; k += 8) {
    const auto corner = [&](int j) {
      return gather_rows(s.local,
                         [&](int i) { return s.triangles[3 * std::ptrdiff_t{s.elements[k + i]} + j]; });
    };
    const Vec3<Floats> a = corner(0), b = corner(1), c = corner(2), w = {a.z, b.z, c.z};
    float* points = s.points + kElementFloats / 8 * std::ptrdiff_t{k};
    store(points, a);
    store(points + 24, b);
    store(points + 48, c);
    const Sides side = sides(s, a, b, c);
    s.facing[k / 8] = static_cast<std::uint8_t>(bits(side.inner));
    s.away[k / 8] = static_cast<std::uint8_t>(bits(side.outer));
    const Floats::Mask upstream = min(min(w.x, w.y), w.z) <= Floats(kUpstream);
    const Range p = spanned(a.x, b.x, c.x, w, upstream);
    if (s.half_long > 0.0f) {
      const Floats low = min(min(a.y, b.y), c.y), high = max(max(a.y, b.y), c.y);
      store(s.boxes + 4 * std::ptrdiff_t{k}, p, {low - Floats(kSlack), high + kSlack});
    } else {
      store(s.boxes + 4 * std::ptrdiff_t{k}, p, spanned(a.y, b.y, c.y, w, upstream));
    }
  }
}

}  // namespace jet::JET_KERNELS
