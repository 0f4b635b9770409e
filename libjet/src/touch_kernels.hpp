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
  explicit Box(const float* b) : low_p(b[0]), high_p(b[1]), low_q(b[2]), high_q(b[3]) {}
  [[gnu::always_inline]] unsigned overlaps(const float* b) const {
    return bits((Floats::load(b) <= high_p) & (low_p <= Floats::load(b + 8)) &
                (Floats::load(b + 16) <= high_q) & (low_q <= Floats::load(b + 24)));
  }
};

/// visit(block, bits of the entries that overlap) for the blocks of level `lowest` below `block` of `level`.
template <class Visit>
void descend(const PyramidView& pyramid, const Box& box, int lowest, int level, int block, Visit& visit) {
  unsigned hits = box.overlaps(pyramid.boxes + 32 * std::ptrdiff_t{pyramid.first[level] + block});
  if (level == lowest) {
    if (hits != 0) visit(block, hits);
    return;
  }
  for (; hits != 0; hits &= hits - 1u)
    descend(pyramid, box, lowest, level - 1, 8 * block + __builtin_ctz(hits), visit);
}

/// The same for all entries. A few blocks are looked through without the levels above them.
template <class Visit>
[[gnu::always_inline]] inline void for_each_overlap(const PyramidView& pyramid, int lowest,
                                                    const float* bounds, Visit visit) {
  const Box box(bounds);
  int level = lowest;
  while (pyramid.last[level] - pyramid.first[level] > 8) ++level;
  for (int b = 0; b < pyramid.last[level] - pyramid.first[level]; ++b)
    descend(pyramid, box, lowest, level, b, visit);
}

[[gnu::always_inline]] inline int append_bits(int block, unsigned hits, unsigned blocked, unsigned met,
                                              int* out) {
  int count = 0;
  for (; hits != 0; hits &= hits - 1u) {
    const int i = __builtin_ctz(hits);
    out[count++] = kHitKinds * (8 * block + i) + static_cast<int>(blocked >> i & 1u) * kBlocked +
                   static_cast<int>(met >> i & 1u) * kMet;
  }
  return count;
}

inline int overlap(const PyramidView& pyramid, const float* box, int* out) {
  int count = 0;
  for_each_overlap(pyramid, 0, box,
                   [&](int block, unsigned hits) { count += append_bits(block, hits, 0, 0, out + count); });
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

inline int shortlist(const PyramidView& rays, const float* boxes, float* list, int* blocks) {
  float around[32];
  merge(boxes, around);
  const float bounds[4] = {around[0], around[8], around[16], around[24]};
  int count = 0;
  const auto add = [&](int block, const float* box) {
    float* to = list + 32 * std::ptrdiff_t{count / 8} + count % 8;
    for (int i = 0; i < 32; i += 8) to[i] = box[i];
    blocks[count++] = block;
  };
  if (rays.levels == 1) {
    const float everywhere[32] = {-kFar, 0, 0, 0,     0, 0, 0, 0, kFar, 0, 0, 0,   0,
                                  0,     0, 0, -kFar, 0, 0, 0, 0, 0,    0, 0, kFar};
    add(0, everywhere);
  } else {
    for_each_overlap(rays, 1, bounds, [&](int block, unsigned hits) {
      const float* parent = rays.boxes + 32 * std::ptrdiff_t{rays.first[1] + block};
      for (; hits != 0; hits &= hits - 1u) {
        const int i = __builtin_ctz(hits);
        add(8 * block + i, parent + i);
      }
    });
  }
  for (int i = count; i % 8 != 0; ++i) {
    float* empty = list + 32 * std::ptrdiff_t{i / 8} + i % 8;
    empty[0] = kFar;
    empty[8] = -kFar;
  }
  return count;
}

inline int rays_touching(const RayList& list, const float* bounds, const Touch& element, int* out) {
  const Box box(bounds);
  const float* c = element.corner;
  const Vec3<Floats> corners[3] = {{Floats(c[0]), Floats(c[1]), Floats(c[2])},
                                   {Floats(c[3]), Floats(c[4]), Floats(c[5])},
                                   {Floats(c[6]), Floats(c[7]), Floats(c[8])}};
  int count = 0;
  for (int i = 0; i < list.count; i += 8) {
    for (unsigned near = box.overlaps(list.boxes + 4 * std::ptrdiff_t{i}); near != 0; near &= near - 1u) {
      const int block = list.blocks[i + __builtin_ctz(near)];
      const unsigned hits = box.overlaps(list.ray_boxes + 32 * std::ptrdiff_t{block});
      if (hits == 0) continue;
      const float* p = list.ray_points + kRayFloats * std::ptrdiff_t{block};
      const Vec3<Floats> g = load_points(p);
      const Floats source = Floats::load(p + 24);
      const auto seen = [&](const Vec3<Floats>& x) { return Vec3<Floats>{x.x, x.y - source, x.z}; };
      const Meeting meeting =
          meet({g.x, g.y - source, g.z}, seen(corners[0]), seen(corners[1]), seen(corners[2]));
      count += append_bits(block, hits & bits(meeting.possible), bits(meeting.pierced & meeting.crossed),
                           bits(meeting.pierced & meeting.beyond), out + count);
    }
  }
  return count;
}

inline int elements_touching(const PyramidView& pyramid, const float* box, const float* points,
                             const Touch& ray, int* out) {
  const Floats source(ray.source), end(ray.target[2] + kSlack);
  const Vec3<Floats> d = {Floats(ray.target[0]), Floats(ray.target[1]) - source, Floats(ray.target[2])};
  int count = 0;
  for_each_overlap(pyramid, 0, box, [&](int block, unsigned hits) {
    const float* p = points + kElementFloats * std::ptrdiff_t{block};
    const auto corner = [&](int i) {
      const Vec3<Floats> x = load_points(p + i);
      return Vec3<Floats>{x.x, x.y - source, x.z};
    };
    const Vec3<Floats> a = corner(0), b = corner(24), c = corner(48);
    const Meeting meeting = meet(d, a, b, c);
    hits &= bits((min(min(a.z, b.z), c.z) <= end) & meeting.possible & ~meeting.beyond);
    count += append_bits(block, hits, bits(meeting.pierced & meeting.crossed), 0, out + count);
  });
  return count;
}

}  // namespace jet::JET_KERNELS
