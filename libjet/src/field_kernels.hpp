// SPDX-License-Identifier: Apache-2.0
// Kernels of S4, four elements at a time.
#pragma once

#include "lanes.hpp"
#include "profile.hpp"

namespace jet::JET_KERNELS {

/// Which of four points are not outside the jet; NaN is not, and found in what follows.
template <bool round>
[[gnu::always_inline]] inline unsigned inside(const JetShape& jet, const Vec3<Lanes>& x) {
  const Vec3<Lanes> d = {x.x - jet.centre[0], x.y - jet.centre[1], x.z - jet.centre[2]};
  const Lanes z = profile::dot(jet.axis, d);
  if constexpr (round) {
    const Vec3<Lanes> r = profile::ahead(-z, jet.axis, d);
    return ~bits(profile::outside(jet, z, profile::dot(r, r))) & 0xfu;
  } else {
    const Lanes across = profile::dot(jet.across, d), along = profile::dot(jet.along, d);
    const Lanes::Mask beside = abs(along) > Lanes(jet.half_long);
    return ~bits(profile::outside(jet, z, across * across) | beside) & 0xfu;
  }
}

/// A group of four elements, and which of them are inside.
struct Group {
  int first;
  unsigned inside;
};

/// Rows e to e + 3; behind the last it is the last again.
[[gnu::always_inline]] inline Vec3<Lanes> four_rows(const Rows& r, int e) {
  const double* x = r.first + e * r.stride;
  if (e + 4 <= r.last) return gather(x, x + r.stride, x + 2 * r.stride, x + 3 * r.stride);
  const auto at = [&](int i) { return row(r, e + i < r.last ? e + i : r.last); };
  return gather(at(0), at(1), at(2), at(3));
}

/// Groups from element `begin` to `end` with elements that may be inside the jet; without a branch for each.
template <bool round>
inline int find_groups(const JetShape& given, const Rows& centroids, int begin, int end, Group* groups) {
  const JetShape jet = given;  // a copy, which what is stored cannot change
  const std::ptrdiff_t stride = centroids.stride;
  const double* x = centroids.first + begin * stride;
  int count = 0, e = begin;
  const auto add = [&](const Vec3<Lanes>& points) __attribute__((always_inline)) {
    groups[count] = {e, inside<round>(jet, points)};
    count += static_cast<int>(groups[count].inside != 0);
  };
  for (; e + 4 < end; e += 4, x += 4 * stride) add(gather(x, x + stride, x + 2 * stride, x + 3 * stride));
  add(four_rows(centroids, e));
  return count;
}

/// Elements inside the jet and not seen from behind.
inline int select_elements(const JetShape& jet, const FieldArrays& arrays) {
  const FieldArrays a = arrays;
  constexpr int kElements = 1024;
  Group groups[kElements / 4];
  int count = 0;
  for (int begin = 0; begin < a.count; begin += kElements) {
    const int end = begin + kElements < a.count ? begin + kElements : a.count;
    const int group_count = jet.round ? find_groups<true>(jet, a.centroids, begin, end, groups)
                                      : find_groups<false>(jet, a.centroids, begin, end, groups);
    for (int g = 0; g < group_count; ++g) {
      const int e = groups[g].first, lanes = a.count - e < 4 ? a.count - e : 4;
      unsigned chosen = groups[g].inside;
      if (jet.axial) chosen &= ~bits(profile::dot(jet.axis, four_rows(a.area_vectors, e)) <= Lanes());
      for (int i = 0; i < lanes; ++i) {
        a.candidates[count] = e + i;
        count += static_cast<int>(chosen >> i & 1u) & (a.is_null[e + i] ^ 1);
      }
    }
  }
  return count;
}

inline int evaluate(const JetShape& jet, const FieldArrays& a, int selected) {
  int count = 0;
  for (int k = 0; k < selected; k += 4) {
    int e[4];
    for (int i = 0; i < 4; ++i) e[i] = a.candidates[k + i < selected ? k + i : selected - 1];
    const auto rows = [&](const Rows& r) {
      return gather(row(r, e[0]), row(r, e[1]), row(r, e[2]), row(r, e[3]));
    };
    const Vec3<Lanes> area = rows(a.area_vectors);
    const Lanes size = sqrt(profile::dot(area, area));
    Lanes speed =
        a.velocity * profile::velocity_along(jet, profile::local(jet, rows(a.centroids)), area) / size;
    if (a.relative_to_skin)
      speed = select(speed > Lanes(), speed - profile::dot(rows(a.velocities), area) / size, speed);
    const Lanes overpressure = a.factor * (speed * speed);
    for (int i = 0; i < 4 && k + i < selected; ++i) {
      if (size[i] == 0.0 || speed[i] <= 0.0) continue;
      if (!(overpressure[i] - overpressure[i] == 0.0)) return -1 - e[i];
      a.overpressure[e[i]] = overpressure[i];
      a.candidates[count++] = e[i];
    }
  }
  return count;
}

}  // namespace jet::JET_KERNELS
