// SPDX-License-Identifier: Apache-2.0
// Elements prepared so that blocks of rays are tested against each with few operations. Seen from the source
// s = (0, y, 0), the sign with which a line along d passes the edge from a to b is that of
//   d . ((a - s) x (b - s)) = d . (a x b) + (y d_w) (b - a)_u - (y d_u) (b - a)_w.
#pragma once

#include "touch_kernels.hpp"

namespace jet::JET_KERNELS {

// Rows of eight among an element's floats.
inline constexpr int kEdge = 5;  // a x b, and u and w of b - a, for each edge
inline constexpr int kEdgeError = 15, kNormal = 17, kHeight = 20, kPlaneError = 21;

[[gnu::always_inline]] inline void store_edge(float* to, const Vec3<Floats>& a, const Vec3<Floats>& b) {
  (a.y * b.z - a.z * b.y).store(to);
  (a.z * b.x - a.x * b.z).store(to + 8);
  (a.x * b.y - a.y * b.x).store(to + 16);
  (b.x - a.x).store(to + 24);
  (b.z - a.z).store(to + 32);
}

/// With m = max|corner| + max|y|, which err by 2^-25, and D = max|d|, which errs by 2^-24, each sign errs by
/// 2^-24 (6 m^2 + D (8 m + 54 m^2)) at most. Heights over the plane: as in `meet`.
inline void make_edges(const EdgeArrays& s, int count) {
  for (int k = 0; k < count; k += 8) {
    const Corners t = gather_corners(s.local, s.triangles, [&](int i) { return s.elements[k + i]; });
    float* to = s.edges + kEdgeFloats / 8 * std::ptrdiff_t{k};
    store_boxes(s.boxes + 4 * std::ptrdiff_t{k}, t, s.half_long);
    store_edge(to, t.a, t.b);
    store_edge(to + 8 * kEdge, t.b, t.c);
    store_edge(to + 16 * kEdge, t.c, t.a);
    const Floats m = max(max(largest(t.a), largest(t.b)), largest(t.c)) + s.half_long;
    (4e-6f * (m + m * m)).store(to + 8 * kEdgeError);
    (4e-6f * (m * m) + 1e-12f).store(to + 8 * kEdgeError + 8);
    const Normal n = normal_of(t.a, t.b, t.c);
    store(to + 8 * kNormal, {n.x, n.y, n.z});
    (t.a.x * n.x + t.a.y * n.y + t.a.z * n.z).store(to + 8 * kHeight);
    (1e-5f * n.size).store(to + 8 * kPlaneError);
    (1e-5f * n.size * (m + n.size) + 1e-12f).store(to + 8 * kPlaneError + 8);
  }
}

/// Eight rays.
struct Block {
  Vec3<Floats> d;
  Floats y, y_w, y_u, size;
  explicit Block(const float* r)
      : d(load_points(r)),
        y(Floats::load(r + 24)),
        y_w(Floats::load(r + 32)),
        y_u(Floats::load(r + 40)),
        size(Floats::load(r + 48)) {}
};

/// What is certain of eight rays and one element, as bits.
struct Touches {
  unsigned possible, blocked, met;
};
[[gnu::always_inline]] inline Touches touch(const Block& r, const float* e, unsigned alive) {
  const auto at = [&](int i) { return Floats(e[8 * i]); };
  const auto edge = [&](int i) {
    return (r.d.x * at(i) + r.d.y * at(i + 1) + r.d.z * at(i + 2)) + (r.y_w * at(i + 3) - r.y_u * at(i + 4));
  };
  const Floats ab = edge(0), bc = edge(kEdge), ca = edge(2 * kEdge);
  const Floats high = max(max(ab, bc), ca), low = min(min(ab, bc), ca);
  const Floats error = r.size * at(kEdgeError) + at(kEdgeError + 1);
  const unsigned possible = alive & ~bits((high > error) & (low < -error));
  if (possible == 0) return {};
  const Floats near = at(kHeight) - r.y * at(kNormal + 1);
  const Floats far = near - (r.d.x * at(kNormal) + r.d.y * at(kNormal + 1) + r.d.z * at(kNormal + 2));
  const Floats plane_error = r.size * at(kPlaneError) + at(kPlaneError + 1);
  const auto pierced = (low > error) | (high < -error);
  const auto inner = near > plane_error, outer = near<-plane_error, above = far> plane_error,
             below = far < -plane_error;
  return {possible, possible & bits(pierced & ((inner & below) | (outer & above))),
          possible & bits(pierced & ((inner & above) | (outer & below)))};
}

inline int meet_edges(const RayArrays& rays, int block, unsigned alive, const PyramidView& pyramid,
                      const float* edges, const HitLists& to) {
  const Block r(rays.rays + kRayFloats * std::ptrdiff_t{block});
  const float* ray_boxes = rays.boxes + 32 * std::ptrdiff_t{block};
  float around[32];
  merge(ray_boxes, around);
  const Box box(around, 8);
  const int blocks = blocks_near(pyramid, box, to.first, to.second);
  int near = 0, count = 0;
  for (int i = 0; i < blocks; ++i) {
    const int entries = to.first[i];
    near += append_bits(box.overlaps(pyramid.boxes + 32 * std::ptrdiff_t{entries}), 8 * entries,
                        to.second + near);
  }
  // Those beside all rays are left out, without a branch to predict.
  int touched = 0;
  for (int i = 0; i < near; ++i) {
    const int e = to.second[i];
    const Box own(pyramid.boxes + 32 * std::ptrdiff_t{e / 8} + e % 8, 8);
    to.second[touched] = e;
    touched += static_cast<int>((own.overlaps(ray_boxes) & alive) != 0);
  }
  for (int i = 0; i < touched && alive != 0; ++i) {
    const int e = to.second[i];
    const Touches t = touch(r, edges + kEdgeFloats * std::ptrdiff_t{e / 8} + e % 8, alive);
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
