// SPDX-License-Identifier: Apache-2.0
// Finds rays and elements that may touch: first by boxes, then by the signs of a line against the edges.
#pragma once

#include "visibility/box_kernels.hpp"

namespace jet::JET_KERNELS {

/// The best lane of each of eight rows, in the order of the rows.
template <class Rows, class Better>
[[gnu::always_inline]] inline Floats best_lanes(Rows rows, Better better) {
  const auto halves = [&](int i) {
    const auto a = rows(i).v, b = rows(i + 1).v;
    return better(Floats(__builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)),
                  Floats(__builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)))
        .v;
  };
  const auto quarters = [&](int i) {
    const auto a = halves(i), b = halves(i + 2);
    return better(Floats(__builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)),
                  Floats(__builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)))
        .v;
  };
  const auto a = quarters(0), b = quarters(4);
  return better(Floats(__builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11)),
                Floats(__builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15)));
}

inline void merge(const float* blocks, int count, float* boxes) {
  for (int i = 0; i < count; i += 8, boxes += kBoxFloats) {
    const auto best = [&](int row, auto better) {
      const auto at = [&](int j) {
        return Floats::load(blocks + kBoxFloats * std::ptrdiff_t{i + j < count ? i + j : count - 1} + row);
      };
      best_lanes(at, better).store(boxes + row);
    };
    for (int low = 0; low <= 32; low += 16) best(low, [](Floats x, Floats y) { return min(x, y); });
    for (int high = 8; high <= 24; high += 16) best(high, [](Floats x, Floats y) { return max(x, y); });
  }
}

inline int choose_boxes(const BoxArrays& from, const std::uint8_t* chosen, float* boxes, int* patches) {
  int found = 0;
  for (int k = 0; k < from.count; ++k) {
    const int patch = from.patches[k];
    if (chosen[patch] == 0) continue;
    const Floats::Mask lanes = mask_from_bits(chosen[patch]);
    const float* block = from.boxes + kBoxFloats * static_cast<std::ptrdiff_t>(k);
    for (int row = 0; row < kBoxFloats; row += 8) {
      // Low p, low q and the depth; between them high p and high q.
      const Floats none(row % 16 == 0 ? __builtin_inff() : -__builtin_inff());
      select(lanes, Floats::load(block + row), none).store(boxes + kBoxFloats * std::ptrdiff_t{found} + row);
    }
    patches[found++] = patch;
  }
  return found;
}

/// A box around rays. It overlaps no box that begins deeper than `depth`.
struct Box {
  Floats low_p, high_p, low_q, high_q, depth;
  [[gnu::always_inline]] Box(const RayRanges& r, Floats deepest)
      : low_p(least(r.p.low)),
        high_p(greatest(r.p.high)),
        low_q(least(r.q.low)),
        high_q(greatest(r.q.high)),
        depth(greatest(deepest)) {}
  [[gnu::always_inline]] unsigned overlaps(const float* b) const {
    return bits((Floats::load(b) <= high_p) & (low_p <= Floats::load(b + 8)) &
                (Floats::load(b + 16) <= high_q) & (low_q <= Floats::load(b + 24)) &
                (Floats::load(b + 32) <= depth));
  }
};

/// A list of blocks, and workspace for the next list.
struct Blocks {
  int *list, *next;
  int count;
};

/// Lowest blocks whose boxes overlap `box`, in order, found level by level. If there are few, all are
/// returned.
inline Blocks blocks_near(const PyramidView& pyramid, const Box& box, const PairLists& to) {
  Blocks b{to.first, to.second, 0};
  int level = 0;
  while (pyramid.last[level] - pyramid.first[level] > 8) ++level;
  b.count = pyramid.last[level] - pyramid.first[level];
  *reinterpret_cast<UnalignedInts*>(b.list) = UnalignedInts{0, 1, 2, 3, 4, 5, 6, 7};
  for (; level > 0; --level) {
    const float* boxes = pyramid.boxes + kBoxFloats * static_cast<std::ptrdiff_t>(pyramid.first[level]);
    int found = 0;
    for (int i = 0; i < b.count; ++i) {
      const int block = b.list[i];
      found +=
          append_bits(box.overlaps(boxes + kBoxFloats * std::ptrdiff_t{block}), 8 * block, b.next + found);
    }
    b = {b.next, b.list, found};
  }
  return b;
}

/// A ray from (0, y, 0) to g, on the line u = slope_u w, v = y + slope_v w.
struct Line {
  Vec3<Floats> g;
  Floats y, slope_u, slope_v;
  Floats error, error_w;  // error of a place beside the line at w: error + error_w |w|
};

/// With u = 2^-25 and s the larger slope, targets err by 5 u and slopes by 11 u (1 + s) / g.w. Corners err by
/// u, so the results of `beside` err by at most 14 u (1 + s) (1 + |w| / g.w). Nothing is certain if g is not
/// downstream.
[[gnu::always_inline]] inline Line line_to(const Vec3<Floats>& g, Floats half_long) {
  const Floats y = max(min(g.y, half_long), -half_long);
  const Floats inverse = select(g.z > Floats(kSlack), 1.0f / g.z, Floats(kFar));
  const Floats u = g.x * inverse, v = (g.y - y) * inverse;
  const Floats error = 5e-7f * (max(abs(u), abs(v)) + 1.0f);
  return {g, y, u, v, error, error * inverse};
}

/// Signs of a line against the edges of triangles, from the places of two corners at a time beside the line.
/// With E the error of a place and m the largest place, a product errs by at most 3.4 m E + 0.8 E^2.
struct Passing {
  Floats low, high, error;
  Floats::Mask missed() const { return (high > error) & (low < -error); }
  Floats::Mask pierced() const { return (low > error) | (high < -error); }
};
[[gnu::always_inline]] inline Passing pass(const Line& r, const Corners& t) {
  struct Place {
    Floats u, v;
  };
  const auto beside = [&](const Vec3<Floats>& x) {
    return Place{x.x - r.slope_u * x.z, (x.y - r.y) - r.slope_v * x.z};
  };
  const Place a = beside(t.a), b = beside(t.b), c = beside(t.c);
  const auto larger = [](const Place& p) { return max(abs(p.u), abs(p.v)); };
  const Floats m = max(max(larger(a), larger(b)), larger(c));
  const Floats error = r.error + r.error_w * max(max(abs(t.a.z), abs(t.b.z)), abs(t.c.z));
  const Floats ab = a.u * b.v - a.v * b.u, bc = b.u * c.v - b.v * c.u, ca = c.u * a.v - c.v * a.u;
  return {min(min(ab, bc), ca), max(max(ab, bc), ca), 6.0f * (error * (m + error))};
}

/// Position of the segment's ends on its line.
struct Ends {
  Floats::Mask crossed;  // if the line pierces the triangle, the segment certainly does
  Floats::Mask beyond;   // the segment certainly does not touch it
};

/// Compares depths (all corners are between the ends, or beyond one of them) and sides (the ends are on
/// opposite sides of the plane, or on one side). With M and n the largest coordinates of the points and of
/// the edges, heights over the plane err by at most 5e-6 n (M + n).
[[gnu::always_inline]] inline Ends ends(const Line& r, const Corners& t) {
  const auto& [a, b, c] = t;
  const Floats low = min(min(a.z, b.z), c.z), high = max(max(a.z, b.z), c.z), slack(kSlack);
  const Normal n = normal_of(a, b, c);
  const Floats size = max(max(largest(a), largest(b)), max(largest(c), largest(r.g)));
  const Floats error = 1e-5f * (n.size * (size + n.size)) + 1e-12f;
  const Floats near = a.x * n.x + (a.y - r.y) * n.y + a.z * n.z;
  const Floats far = (a.x - r.g.x) * n.x + (a.y - r.g.y) * n.y + (a.z - r.g.z) * n.z;
  const auto inner = near > error, outer = near<-error, above = far> error, below = far < -error;
  return {((low > slack) & (high < r.g.z - slack)) | (inner & below) | (outer & above),
          (low > r.g.z + kSlack) | (high < -slack) | (inner & above) | (outer & below)};
}

inline void meet_pairs(const PairArrays& p, int count) {
  for (int k = 0; k < count; k += 8) {
    const int *rays = p.rays + k, *elements = p.elements + k;
    int some[2][8];
    if (k + 8 > count) {  // repeats the last
      for (int i = 0; i < 8; ++i) {
        const int last = k + i < count ? i : count - 1 - k;
        some[0][i] = rays[last];
        some[1][i] = elements[last];
      }
      rays = some[0];
      elements = some[1];
    }
    const auto places = *reinterpret_cast<const UnalignedInts*>(elements);
    alignas(32) int rows[8];  // as rows_of
    *reinterpret_cast<UnalignedInts*>(rows) = 24 * (places >> 3) + (places & 7);
    const auto corner = [&](int j) {
      return gather_four(p.local,
                         [&](int i) { return static_cast<std::ptrdiff_t>(p.corner_rows[rows[i] + 8 * j]); })
          .point;
    };
    const Line r = line_to(gather_rows(p.targets, [&](int i) { return rays[i]; }), Floats(p.half_long));
    const Corners t = {corner(0), corner(1), corner(2)};
    const Passing passing = pass(r, t);
    const Ends end = ends(r, t);
    const unsigned missed = bits(passing.missed()), pierced = bits(passing.pierced());
    p.blocked[k / 8] = static_cast<std::uint8_t>(pierced & bits(end.crossed));
    p.pierced[k / 8] = static_cast<std::uint8_t>(pierced);
    p.apart[k / 8] = static_cast<std::uint8_t>(missed | bits(end.beyond));
    p.missed[k / 8] = static_cast<std::uint8_t>(missed);
  }
}

}  // namespace jet::JET_KERNELS
