// SPDX-License-Identifier: Apache-2.0
// Kernels of S4, four elements at a time.
#pragma once

#include "lanes.hpp"
#include "profile.hpp"

namespace jet::JET_KERNELS {

/// Of elements e to e + 3 those inside the jet and not seen from behind are appended; without a branch for
/// each.
[[gnu::always_inline]] inline int append(const JetShape& jet, const FieldArrays& a, int e, int lanes,
                                         int count) {
  const auto at = [&](const Rows& r, int i) __attribute__((always_inline)) {
    return row(r, i < lanes ? e + i : a.count - 1);
  };
  const auto rows = [&](const Rows& r) __attribute__((always_inline)) {
    return gather(at(r, 0), at(r, 1), at(r, 2), at(r, 3));
  };
  const Lanes::Mask inside = profile::inside(jet, profile::local(jet, rows(a.centroids)));
  if (bits(inside) == 0) return count;
  const Lanes ahead = profile::dot(jet.axis, rows(a.area_vectors));
  const unsigned chosen = jet.axial ? bits(inside & not_at_most(ahead, Lanes())) : bits(inside);
  for (int i = 0; i < lanes; ++i) {
    a.candidates[count] = e + i;
    count += static_cast<int>(chosen >> i & 1u) & (a.is_null[e + i] ^ 1);
  }
  return count;
}

inline int select_elements(const JetShape& jet, const FieldArrays& a) {
  int count = 0, e = 0;
  for (; e + 4 < a.count; e += 4) count = append(jet, a, e, 4, count);
  return append(jet, a, e, a.count - e, count);
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
