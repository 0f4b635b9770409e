// SPDX-License-Identifier: Apache-2.0
// Which rays and elements may touch: boxes first, then the signs with which a line passes the edges.
#pragma once

#include "box_kernels.hpp"

namespace jet::JET_KERNELS {

inline void merge(const float* block, float* box) {
  box[0] = least(Floats::load(block));
  box[8] = greatest(Floats::load(block + 8));
  box[16] = least(Floats::load(block + 16));
  box[24] = greatest(Floats::load(block + 24));
}

struct Box {
  Floats low_p, high_p, low_q, high_q;
  Box(const float* b, int stride)
      : low_p(b[0]), high_p(b[stride]), low_q(b[2 * stride]), high_q(b[3 * stride]) {}
  [[gnu::always_inline]] unsigned overlaps(const float* b) const {
    return bits((Floats::load(b) <= high_p) & (low_p <= Floats::load(b + 8)) &
                (Floats::load(b + 16) <= high_q) & (low_q <= Floats::load(b + 24)));
  }
};

/// Lowest blocks whose boxes overlap, in order, to `out`; level by level, with `scratch` between. A few
/// blocks are all taken.
inline int blocks_near(const PyramidView& pyramid, const Box& box, int* out, int* scratch) {
  int level = 0;
  while (pyramid.last[level] - pyramid.first[level] > 8) ++level;
  int count = pyramid.last[level] - pyramid.first[level];
  for (int i = 0; i < count; ++i) out[i] = i;
  for (; level > 0; --level) {
    for (int i = 0; i < count; ++i) scratch[i] = out[i];
    int found = 0;
    for (int i = 0; i < count; ++i) {
      const float* boxes = pyramid.boxes + 32 * std::ptrdiff_t{pyramid.first[level] + scratch[i]};
      found += append_bits(box.overlaps(boxes), 8 * scratch[i], out + found);
    }
    count = found;
  }
  return count;
}

[[gnu::always_inline]] inline Floats determinant(const Vec3<Floats>& d, const Vec3<Floats>& a,
                                                 const Vec3<Floats>& b) {
  return d.x * (a.y * b.z - a.z * b.y) + d.y * (a.z * b.x - a.x * b.z) + d.z * (a.x * b.y - a.y * b.x);
}

struct Meeting {
  Floats::Mask possible;  // the line may touch the triangle
  Floats::Mask pierced;   // it passes through the triangle's interior for certain
  Floats::Mask crossed;   // the segment's ends are on either side of the plane for certain
  Floats::Mask beyond;    // they are on one side for certain
};

/// The line along d, and its segment, and a triangle; all are seen from the source. With D and m the largest
/// coordinates of d and the corners, which err by 2^-23, the determinants err by 3e-6 m (D + D m + m) at
/// most, the heights over the plane by 1e-5 n (M + n), M and n the largest coordinates of the points and of
/// the edges, as in `sides`.
[[gnu::always_inline]] inline Meeting meet(const Vec3<Floats>& d, const Vec3<Floats>& a,
                                           const Vec3<Floats>& b, const Vec3<Floats>& c) {
  const Floats m = max(max(largest(a), largest(b)), largest(c)), D = largest(d);
  const Floats error = 3e-6f * (m * (D + D * m + m)) + 1e-12f;
  const Floats ab = determinant(d, a, b), bc = determinant(d, b, c), ca = determinant(d, c, a);
  const Floats high = max(max(ab, bc), ca), low = min(min(ab, bc), ca);
  const Normal n = normal_of(a, b, c);
  const Floats plane_error = 1e-5f * (n.size * (m + D + n.size)) + 1e-12f;
  const Floats near = a.x * n.x + a.y * n.y + a.z * n.z;
  const Floats far = (a.x - d.x) * n.x + (a.y - d.y) * n.y + (a.z - d.z) * n.z;
  const auto inner = near > plane_error, outer = near<-plane_error, above = far> plane_error,
             below = far < -plane_error;
  return {~((high > error) & (low < -error)), (low > error) | (high < -error),
          (inner & below) | (outer & above), (inner & above) | (outer & below)};
}

/// The same of triangles where they are, from the source (0, y, 0).
[[gnu::always_inline]] inline Meeting meet_from(Floats y, const Vec3<Floats>& d, const Corners& t) {
  const auto seen = [&](const Vec3<Floats>& x) { return Vec3<Floats>{x.x, x.y - y, x.z}; };
  return meet(d, seen(t.a), seen(t.b), seen(t.c));
}

inline void meet_pairs(const PairArrays& p, int count) {
  const Floats end(p.half_long);
  for (int k = 0; k < count; k += 8) {
    const auto last = [&](int i) { return k + i < count ? k + i : count - 1; };
    const Vec3<Floats> g = gather_rows(p.targets, [&](int i) { return p.rays[last(i)]; });
    const Corners t = gather_corners(p.local, p.triangles, [&](int i) { return p.elements[last(i)]; });
    const Floats y = max(min(g.y, end), -end);
    const Meeting m = meet_from(y, {g.x, g.y - y, g.z}, t);
    p.blocked[k / 8] = static_cast<std::uint8_t>(bits(m.pierced & m.crossed));
    p.apart[k / 8] = static_cast<std::uint8_t>(bits(~m.possible | m.beyond));
  }
}

inline int meet_elements(const RayArrays& rays, int ray, const PyramidView& pyramid, const float* points,
                         const HitLists& to) {
  const float* bounds = rays.boxes + 32 * std::ptrdiff_t{ray / 8} + ray % 8;
  const Box box(bounds, 8);
  const float* r = rays.rays + kRayFloats * std::ptrdiff_t{ray / 8} + ray % 8;
  const Vec3<Floats> d = {Floats(r[0]), Floats(r[8]), Floats(r[16])};
  const Floats y(r[24]), end(r[16] + kSlack);
  const int blocks = blocks_near(pyramid, box, to.first, to.second);
  int near = 0, count = 0;
  for (int i = 0; i < blocks; ++i) {
    const int block = to.first[i];
    const float* p = points + kElementFloats * std::ptrdiff_t{block};
    const Floats low = min(min(Floats::load(p + 16), Floats::load(p + 40)), Floats::load(p + 64));
    const unsigned hits = box.overlaps(pyramid.boxes + 32 * std::ptrdiff_t{block}) & bits(low <= end);
    to.second[near] = block;  // kept if the next does not overwrite it
    near += static_cast<int>(hits != 0);
  }
  for (int i = 0; i < near; ++i) {
    const int block = to.second[i];
    const Meeting m = meet_from(y, d, load_corners(points + kElementFloats * std::ptrdiff_t{block}));
    unsigned hits = bits(m.possible & ~m.beyond);
    const unsigned blocked = hits & bits(m.pierced & m.crossed);
    for (; hits != 0; hits &= hits - 1u) {
      const int e = __builtin_ctz(hits);
      to.hits[count++] = kHitKinds * (8 * block + e) + static_cast<int>(blocked >> e & 1u) * kBlocked;
    }
  }
  return count;
}

}  // namespace jet::JET_KERNELS
