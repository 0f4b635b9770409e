// SPDX-License-Identifier: Apache-2.0
// Ranges of rays, and of elements between them. These kernels give certain answers: each states the error
// that its margins cover. kUnit is twice the error of a local coordinate.
#pragma once

#include "visibility/project_kernels.hpp"

namespace jet::JET_KERNELS {

inline constexpr float kUnit = 6.1e-8f;
inline constexpr float kFar = 1e30f;       // larger than every coordinate
inline constexpr float kUpstream = 1e-4f;  // points with a smaller w may be upstream
inline constexpr float kSlack = 1e-6f;     // 16 kUnit, for places
inline constexpr float kTurn = 4e-6f;      // the same for slopes, divided by the distance from the sources

struct Range {
  Floats low, high;
};

/// u / (w + |u|), which has the order of the slope u / w but is bounded. For a point upstream it is +-1.
/// Coordinates of targets err by at most 2.5 kUnit. So this errs by 5 kUnit / (w + |u|) and its roundings;
/// kTurn covers 10 times that.
struct Turned {
  Floats place, inverse;
};
[[gnu::always_inline]] inline Turned turned(Floats u, Floats w) {
  const Floats inverse = 1.0f / (max(w, Floats(1e-30f)) + abs(u));
  return {u * inverse, inverse};
}

/// Range of slopes u / w, which err by less than 6 kUnit (1 + |slope|) / w.
[[gnu::always_inline]] inline Range slopes(Floats u, Floats w) {
  const Floats inverse = 1.0f / w;
  const Floats slope = u * inverse, margin = kSlack * ((abs(slope) + 1.0f) * inverse);
  return {slope - margin, slope + margin};
}

/// Range of the places of rays from a line, along that line. A ray stays at the v of its target or, if it
/// comes from the line's end, goes farther by at most 2 (v - end) / max(w, |u|). The 2 bounds the
/// coordinates: examined nodes are within 1, and none moves by more than 1 until it is examined again. max(w,
/// |u|) is at least half of w + |u|. Above kUpstream this errs by 5 kUnit, 0.3 %, which 4.02 covers; v errs
/// by 2.5 kUnit, which kSlack covers.
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

/// Ranges of rays, in the two coordinates that are constant along a ray.
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

/// Bounds of the rays added so far.
struct Bounds {
  Range u{Floats(kFar), Floats(-kFar)}, v = u;

  /// Adds the rays whose targets have w above `least_depth`; returns them.
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
  Frustum all() const {
    return {least(u.low).v[0], greatest(u.high).v[0], least(v.low).v[0], greatest(v.high).v[0]};
  }
};

[[gnu::always_inline]] inline Floats::Mask mask_from_bits(unsigned bits) {
  return ((Floats::Mask{} + static_cast<int>(bits)) & Floats::Mask{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
}

inline Frustum frustum_of(const ProjectArrays& arrays, float half_long, int count) {
  const ProjectArrays a = arrays;
  Bounds bounds;
  constexpr float least_depth = 0.5f * kSlack;  // includes all rays that classify_patches adds
  for (int k = 0; k < count; k += 8)
    bounds.take(local_centroids(a, k, count), mask_from_bits(0xffu), half_long, least_depth);
  return bounds.all();
}

/// Range of the downstream part of a triangle. If it reaches upstream, it must stay on one side, or else its
/// range is everything.
[[gnu::always_inline]] inline Range spanned(Floats a, Floats b, Floats c, const Vec3<Floats>& w,
                                            Floats depth) {
  const Turned ta = turned(a, w.x), tb = turned(b, w.y), tc = turned(c, w.z);
  const Floats margin = kTurn * max(max(ta.inverse, tb.inverse), tc.inverse);
  const Range range = {min(min(ta.place, tb.place), tc.place) - margin,
                       max(max(ta.place, tb.place), tc.place) + margin};
  const Floats::Mask one_side =
      (min(min(a, b), c) > Floats(kUpstream)) | (max(max(a, b), c) < Floats(-kUpstream));
  const Floats::Mask anywhere = (depth <= Floats(kUpstream)) & ~one_side;
  return {select(anywhere, Floats(-kFar), range.low), select(anywhere, Floats(kFar), range.high)};
}

struct Normal {
  Floats x, y, z, size;  // (b - a) x (c - a), and the largest coordinate d of the two edges
};
[[gnu::always_inline]] inline Normal normal_of(const Vec3<Floats>& a, const Vec3<Floats>& b,
                                               const Vec3<Floats>& c) {
  const Vec3<Floats> e = {b.x - a.x, b.y - a.y, b.z - a.z}, f = {c.x - a.x, c.y - a.y, c.z - a.z};
  return {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x, max(largest(e), largest(f))};
}

/// Pointer to the row number of an element's first corner; the other corners follow 8 and 16 later.
[[gnu::always_inline]] inline const std::uint32_t* rows_of(const std::uint32_t* corner_rows, int patch,
                                                           unsigned lane = 0) {
  return corner_rows + 24 * std::ptrdiff_t{patch} + lane;
}

struct Corners {
  Vec3<Floats> a, b, c;
};

}  // namespace jet::JET_KERNELS
