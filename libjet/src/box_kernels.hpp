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
/// side, +-1. Coordinates err by 2.5 kUnit at most, those of targets, so this by 5 kUnit / (w + |u|) and its
/// roundings: kTurn covers 10 times that.
struct Turned {
  Floats place, inverse;
};
[[gnu::always_inline]] inline Turned turned(Floats u, Floats w) {
  const Floats inverse = 1.0f / (max(w, Floats(1e-30f)) + abs(u));
  return {u * inverse, inverse};
}

[[gnu::always_inline]] inline void store(float* block, Range p, Range q, Floats depth) {
  p.low.store(block);
  p.high.store(block + 8);
  q.low.store(block + 16);
  q.high.store(block + 24);
  depth.store(block + 32);
}

/// Slopes u / w, which err by less than 6 kUnit (1 + |slope|) / w.
[[gnu::always_inline]] inline Range slopes(Floats u, Floats w) {
  const Floats inverse = 1.0f / w;
  const Floats slope = u * inverse, margin = kSlack * ((abs(slope) + 1.0f) * inverse);
  return {slope - margin, slope + margin};
}

/// Where rays from a line run along it: at the place of the target or, from the line's end, farther by
/// 2 (v - end) / max(w, |u|) at most, as no coordinate is above 2: nodes looked at are within 1, and none
/// moves by more than 1 until it is again. The larger of two is at least half their sum; above kUpstream this
/// errs by 5 kUnit, 0.3 %, which 4.02 covers; v, by 2.5 kUnit, which kSlack covers.
[[gnu::always_inline]] inline Range places(Vec3<Floats> g, Floats half_long) {
  const Floats distance = max(g.z, Floats(1e-30f)) + abs(g.x), inverse = 1.0f / distance;
  const Floats margin = kTurn * inverse + kSlack, end = half_long - Floats(kSlack);
  const auto way = [&](Floats beyond) {
    return select(distance > Floats(kUpstream), 4.02f * (beyond * inverse), Floats(kFar));
  };
  const Floats from = max(min(g.y, half_long), -half_long);
  return {from - select(g.y < -end, way(-end - g.y), Floats()) - margin,
          from + select(g.y > end, way(g.y - end), Floats()) + margin};
}

/// Ranges of rays: of the two coordinates that do not change along them.
struct RayRanges {
  Range p, q;
};
[[gnu::always_inline]] inline RayRanges ranges(const Vec3<Floats>& target, float half_long) {
  const auto turn = [&](Floats u) {
    const Turned t = turned(u, target.z);
    return Range{t.place - kTurn * t.inverse, t.place + kTurn * t.inverse};
  };
  return {turn(target.x), half_long > 0.0f ? places(target, Floats(half_long)) : turn(target.y)};
}

/// Bounds of the rays seen so far.
struct Bounds {
  Range u{Floats(kFar), Floats(-kFar)}, v = u;

  /// Takes in those rays whose targets lie deeper: they are returned.
  [[gnu::always_inline]] Floats::Mask take(const Vec3<Floats>& g, Floats::Mask rays, float half_long,
                                           float least_depth) {
    const Floats far(kFar);
    const Floats::Mask valid = rays & (g.z > Floats(least_depth));
    const Range slope_u = slopes(g.x, g.z),
                slope_v = half_long > 0.0f ? places(g, Floats(half_long)) : slopes(g.y, g.z);
    const auto grown = [&](Range r, Range by) {
      return Range{min(r.low, select(valid, by.low, far)), max(r.high, select(valid, by.high, -far))};
    };
    u = grown(u, slope_u);
    v = grown(v, slope_v);
    return valid;
  }
  RayBounds all() const {
    return {least(u.low).v[0], greatest(u.high).v[0], least(v.low).v[0], greatest(v.high).v[0]};
  }
};

[[gnu::always_inline]] inline Floats::Mask lanes_of(unsigned bits) {
  return ((Floats::Mask{} + static_cast<int>(bits)) & Floats::Mask{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
}

inline RayBounds bound_rays(const ProjectArrays& arrays, float half_long, int count) {
  const ProjectArrays a = arrays;
  Bounds bounds;
  constexpr float least_depth = 0.5f * kSlack;  // no ray is left out that look_at_patches takes in
  for (int k = 0; k < count; k += 8)
    bounds.take(local_centroids(a, k, count), lanes_of(0xffu), half_long, least_depth);
  return bounds.all();
}

/// Range of a triangle's part downstream. If it reaches upstream, it must stay on one side; if not, it is
/// anywhere.
[[gnu::always_inline]] inline Range spanned(Floats a, Floats b, Floats c, const Vec3<Floats>& w,
                                            Floats::Mask upstream) {
  const Turned ta = turned(a, w.x), tb = turned(b, w.y), tc = turned(c, w.z);
  const Floats margin = kTurn * max(max(ta.inverse, tb.inverse), tc.inverse);
  const Floats::Mask one_side =
      (min(min(a, b), c) > Floats(kUpstream)) | (max(max(a, b), c) < Floats(-kUpstream));
  const Floats::Mask anywhere = upstream & ~one_side;
  return {select(anywhere, Floats(-kFar), min(min(ta.place, tb.place), tc.place) - margin),
          select(anywhere, Floats(kFar), max(max(ta.place, tb.place), tc.place) + margin)};
}

struct Normal {
  Floats x, y, z, size;  // (b - a) x (c - a), and the largest coordinate d of the two edges
};
[[gnu::always_inline]] inline Normal normal_of(const Vec3<Floats>& a, const Vec3<Floats>& b,
                                               const Vec3<Floats>& c) {
  const Vec3<Floats> e = {b.x - a.x, b.y - a.y, b.z - a.z}, f = {c.x - a.x, c.y - a.y, c.z - a.z};
  return {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x, max(largest(e), largest(f))};
}

/// Where the row of an element's first corner begins; those of the others stand 8 and 16 on.
[[gnu::always_inline]] inline const std::uint32_t* rows_of(const std::uint32_t* corner_rows, int patch,
                                                           unsigned lane = 0) {
  return corner_rows + 24 * std::ptrdiff_t{patch} + lane;
}

struct Corners {
  Vec3<Floats> a, b, c;
};

struct Sides {
  Floats::Mask inner, outer, apart;
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
          beside | (height - whole > error) | (height + whole < -error)};
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

inline PatchesFound look_at_patches(const PatchArrays& given) {
  const PatchArrays s = given;  // a copy, which what is stored cannot change
  PatchesFound found{};
  Bounds bounds;
  for (int k = 0; k < s.count; ++k) {
    const int patch = s.patches[k];
    // The two cache lines of a later patch: with cold caches the query takes 1.5 % less.
    const std::uint32_t* ahead = rows_of(s.corner_rows, s.patches[k + 6 < s.count ? k + 6 : k]);
    __builtin_prefetch(ahead);
    __builtin_prefetch(ahead + 16);
    const std::uint32_t* rows = rows_of(s.corner_rows, patch);
    const auto corner = [&](int j) {
      return gather_four(s.local, [&](int i) { return std::ptrdiff_t{rows[8 * j + i]}; });
    };
    const FourFloats a = corner(0), b = corner(1), c = corner(2);
    const auto code = [](const FourFloats& x) { return reinterpret_cast<Floats::Mask>(x.fourth.v); };
    const int left = s.elements - 8 * patch;
    const unsigned there = left < 8 ? (1u << left) - 1u : 0xffu;
    const Floats::Mask common = code(a) & code(b) & code(c);
    const unsigned near = there & bits((common & s.outside) == 0);
    if (near == 0) continue;
    const Corners t = {a.point, b.point, c.point};
    store_boxes(s.boxes + kBoxFloats * std::ptrdiff_t{found.near}, t, s.half_long);
    s.near[found.near++] = patch;
    const Sides side = sides(s, t);
    const unsigned inner = bits(side.inner) | (~there & 0xffu), outer = bits(side.outer) & there;
    s.inner[patch] = static_cast<std::uint8_t>(inner);
    s.outer[patch] = static_cast<std::uint8_t>(outer);
    s.not_inner[patch] = static_cast<std::uint8_t>(near & ~inner);
    const unsigned uncertain = near & ~(inner | outer);
    if (uncertain != 0) found.uncertain += append_bits(uncertain, 8 * patch, s.uncertain + found.uncertain);
    const unsigned between = near & ~bits(side.apart), on_way = near & bits((common & kBesideWay) == 0);
    if (between != 0) found.between += append_bits(between, 8 * patch, s.between + found.between);
    if (on_way != 0) found.on_way += append_bits(on_way, 8 * patch, s.on_way + found.on_way);
    const unsigned asked = s.asked[patch];
    if (asked == 0) continue;
    // The mean of three coordinates that err by kUnit / 2 errs by 2.5 kUnit.
    const auto mean = [](Floats x, Floats y, Floats z) { return (1.0f / 3.0f) * (x + y + z); };
    const Vec3<Floats> g = {mean(t.a.x, t.b.x, t.c.x), mean(t.a.y, t.b.y, t.c.y), mean(t.a.z, t.b.z, t.c.z)};
    store_rows([&](int i) { return s.targets + 4 * (8 * std::ptrdiff_t{patch} + i); }, g, Floats());
    const unsigned aside = asked & ~bits(bounds.take(g, lanes_of(asked), s.half_long, kSlack));
    if (aside != 0) found.aside += append_bits(aside, 8 * patch, s.aside + found.aside);
    ++found.asked;
  }
  found.bounds = bounds.all();
  return found;
}

}  // namespace jet::JET_KERNELS
