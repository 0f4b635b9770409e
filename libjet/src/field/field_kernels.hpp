// SPDX-License-Identifier: Apache-2.0
// Kernels of S6, four elements at a time.
#pragma once

#include "field/profile.hpp"
#include "floats.hpp"

namespace jet::JET_KERNELS {

/// Bound of the rounding of a point's motion and distances, relative to its coordinates: some 10 roundings.
inline constexpr double kPlaceError = 1e-14;

/// Points of a group of four that are not outside the jet. NaN counts as not outside; later steps find it.
/// `slack` is how far all four can move without a change: each bound of the jet is a distance, or a distance
/// divided by the cosine.
struct Inside {
  unsigned points;
  double slack;  // [m]
};
template <bool round>
[[gnu::always_inline]] inline Inside inside(const JetShape& jet, const Vec3<Lanes>& x) {
  const Vec3<Lanes> d = {x.x - jet.centre[0], x.y - jet.centre[1], x.z - jet.centre[2]};
  const Lanes z = profile::dot(jet.axis, d);
  Lanes radius, radius2, beyond = -z;
  Lanes::Mask outside;
  if constexpr (round) {
    const Vec3<Lanes> r = profile::ahead(-z, jet.axis, d);
    radius2 = profile::dot(r, r);
    radius = sqrt(radius2);
    outside = profile::outside(jet, z, radius2);
  } else {
    const Lanes across = profile::dot(jet.across, d), along = abs(profile::dot(jet.along, d));
    radius2 = across * across;
    radius = abs(across);
    outside = profile::outside(jet, z, radius2) | (along > Lanes(jet.half_long));
    beyond = max(beyond, along - jet.half_long);
  }
  beyond = max(beyond, jet.cut_cosine * (radius - profile::cut(jet, z)));
  const Lanes size = max(max(abs(d.x), abs(d.y)), abs(d.z)) + Lanes(jet.centre_size);
  return {~bits(outside) & 0xfu, least(max(Lanes(), 0.999 * abs(beyond) - kPlaceError * size))};
}

/// Rows e to e + 3. Rows behind the last one repeat it.
[[gnu::always_inline]] inline Vec3<Lanes> four_rows(const Rows& r, int e) {
  const double* x = r.first + e * r.stride;
  if (e + 4 <= r.last) return gather(x, x + r.stride, x + 2 * r.stride, x + 3 * r.stride);
  const auto at = [&](int i) { return row(r, e + i < r.last ? e + i : r.last); };
  return gather(at(0), at(1), at(2), at(3));
}

/// Rows of four elements in ascending order: only the last element can be the last row.
[[gnu::always_inline]] inline Vec3<Lanes> four_rows(const Rows& r, const int* e) {
  const auto at = [&](int i) { return r.first + e[i] * r.stride; };
  if (e[3] < r.last) return gather(at(0), at(1), at(2), at(3));
  return gather(row(r, e[0]), row(r, e[1]), row(r, e[2]), row(r, e[3]));
}

/// Lists the groups with points that may have crossed a bound of the jet since they were last examined.
inline int list_open(const FieldArrays& a, int begin, int count, int* list) {
  const Lanes displacement_bound(a.displacement_bound);
  const double* slack = a.slack + begin;
  int open = 0;
  for (int g = 0; g < count; g += 8) {
    const unsigned clear = bits(displacement_bound < Lanes::load(slack + g)) |
                           bits(displacement_bound < Lanes::load(slack + g + 4)) << 4;
    open += append_bits(~clear & 0xffu, begin + g, list + open);
  }
  while (open > 0 && list[open - 1] >= begin + count) --open;  // behind the last
  return open;
}

/// Examines those groups.
template <bool round>
inline void look_at_groups(const JetShape& given, const FieldArrays& a, int begin, int count, int* list) {
  const JetShape jet = given;  // a copy, so that stores cannot change it
  const Rows centroids = a.centroids;
  const int open = list_open(a, begin, count, list);
  for (int i = 0; i < open; ++i) {
    const int group = list[i];
    const Inside now = inside<round>(jet, four_rows(centroids, 4 * group));
    a.slack[group] = a.displacement_bound + now.slack;
    a.inside[group] = static_cast<std::uint8_t>(now.points & a.loaded[group]);
  }
}

/// Lists the groups with a point inside. Branchless.
inline int list_inside(const std::uint8_t* inside, int begin, int count, int* list) {
  int found = 0;
  for (int g = begin; g < begin + count; g += 32) {
    const unsigned has = not_zero(inside + g);
    for (int i = 0; i < 32; i += 8) found += append_bits(has >> i & 0xffu, g + i, list + found);
  }
  return found;
}

/// Lists the elements whose rows are read next: all of open groups, and those inside of other groups.
inline int list_needed(const FieldArrays& a, int* elements) {
  constexpr int most = 256;
  const int groups = (a.count + 3) / 4;
  int list[most + 8];
  int needed = 0;
  for (int begin = 0; begin < groups; begin += most) {
    const int batch = groups - begin < most ? groups - begin : most;
    const int open = list_open(a, begin, batch, list);
    for (int i = 0; i < open; ++i)
      for (int e = 4 * list[i]; e < 4 * list[i] + 4 && e < a.count; ++e) elements[needed++] = e;
    const int found = list_inside(a.inside, begin, batch, list);
    for (int i = 0; i < found; ++i)
      if (a.displacement_bound < a.slack[list[i]])
        needed += append_bits(a.inside[list[i]], 4 * list[i], elements + needed);
  }
  return needed;
}

/// Calls run<round, axial>() for this jet.
template <class Run>
inline int by_kind(const JetShape& jet, Run run) {
  if (jet.round)
    return jet.axial ? run.template operator()<true, true>() : run.template operator()<true, false>();
  return jet.axial ? run.template operator()<false, true>() : run.template operator()<false, false>();
}

template <bool round, bool axial>
inline int select_as(const JetShape& jet, const FieldArrays& arrays) {
  constexpr int most = 256;
  const FieldArrays a = arrays;  // copies, so that stores cannot change them
  const double axis[] = {jet.axis[0], jet.axis[1], jet.axis[2]};
  const int groups = (a.count + 3) / 4;
  int list[most + 8];
  int count = 0;
  for (int begin = 0; begin < groups; begin += most) {
    const int batch = groups - begin < most ? groups - begin : most;
    look_at_groups<round>(jet, a, begin, batch, list);
    const int found = list_inside(a.inside, begin, batch, list);
    for (int i = 0; i < found; ++i) {
      const int e = 4 * list[i];
      unsigned chosen = a.inside[list[i]];
      if (axial) chosen &= ~bits(profile::dot(axis, four_rows(a.area_vectors, e)) <= Lanes());
      count += append_bits(chosen, e, a.candidates + count);
    }
  }
  return count;
}

/// Lists the elements inside the jet that do not face away from it.
inline int select_elements(const JetShape& jet, const FieldArrays& a) {
  return by_kind(jet, [&]<bool round, bool axial>() { return select_as<round, axial>(jet, a); });
}

/// Candidates in groups of four. Each operation is done for all groups before the next one, so that the long
/// chains of divisions and roots overlap.
struct Batch {
  static constexpr int kMost = 16;
  using Values = Lanes::Values;  // not initialised to zero
  Values z[kMost], radius2[kMost], decay[kMost], exponent[kMost], along[kMost], distance2[kMost], skin[kMost],
      area2[kMost];
};

template <bool round, bool axial>
inline int evaluate_as(const JetShape& given, const FieldArrays& arrays, int selected) {
  JetShape jet = given;
  jet.round = round;  // now known to the compiler
  jet.axial = axial;
  const FieldArrays a = arrays;
  Batch b;
  int count = 0;
  for (int k = selected; k % 4 != 0; ++k) a.candidates[k] = a.candidates[selected - 1];
  for (int begin = 0; begin < selected; begin += 4 * Batch::kMost) {
    const int left = (selected - begin + 3) / 4, batch = left < Batch::kMost ? left : Batch::kMost;
    for (int i = 0; i < batch; ++i) {
      const auto rows = [&](const Rows& r) { return four_rows(r, a.candidates + begin + 4 * i); };
      const Vec3<Lanes> area = rows(a.area_vectors);
      const profile::Local<Lanes> x = profile::local(jet, rows(a.centroids));
      const profile::Part<Lanes> part = profile::part(jet, x, area);
      b.z[i] = x.z.v;
      b.radius2[i] = x.radius2.v;
      b.along[i] = part.along.v;
      b.distance2[i] = part.distance2.v;
      b.area2[i] = profile::dot(area, area).v;
      if (a.relative_to_skin) b.skin[i] = profile::dot(rows(a.velocities), area).v;
    }
    for (int i = 0; i < batch; ++i) {
      const profile::Speed<Lanes> at = profile::speed(jet, Lanes(b.z[i]), Lanes(b.radius2[i]));
      b.decay[i] = at.decay.v;
      b.exponent[i] = at.exponent.v;
    }
    for (int i = 0; i < batch; ++i) {
      const int k = begin + 4 * i;
      const int e[4] = {a.candidates[k], a.candidates[k + 1], a.candidates[k + 2], a.candidates[k + 3]};
      const profile::Speed<Lanes> at{Lanes(b.decay[i]), Lanes(b.exponent[i])};
      const profile::Part<Lanes> part{Lanes(b.along[i]), Lanes(b.distance2[i])};
      const Lanes size = sqrt(Lanes(b.area2[i]));
      Lanes speed = a.velocity * profile::velocity_along(jet, at, part) / size;
      if (a.relative_to_skin) speed = select(speed > Lanes(), speed - Lanes(b.skin[i]) / size, speed);
      const Lanes overpressure = a.factor * (speed * speed);
      const Lanes::Mask none = (size <= Lanes()) | (speed <= Lanes());
      const unsigned loaded = ~bits(none) & (k + 4 <= selected ? 0xfu : (1u << (selected - k)) - 1u);
      const unsigned finite = bits(overpressure - overpressure <= Lanes());
      if ((loaded & ~finite) != 0) return -1 - e[__builtin_ctz(loaded & ~finite)];
      const Lanes kept = select(none, Lanes(), overpressure);
      for (int j = 0; j < 4; ++j) a.overpressure[e[j]] = kept[j];  // lanes after the last one repeat it
      if (loaded == 0xf && count == k) {                           // already in place
        count += 4;
        continue;
      }
      for (int j = 0; j < 4; ++j) {  // no branch to predict
        a.candidates[count] = e[j];
        count += static_cast<int>(loaded >> j & 1u);
      }
    }
  }
  return count;
}

/// Sums the force in four partial sums, whose additions overlap.
inline void force(const Rows& area_vectors, const double* overpressure, const int* elements, int count,
                  double* sum) {
  Lanes sums[4];
  const auto add = [&](int k, Lanes& to) {
    const int e = elements[k];
    to = to + overpressure[e] * Lanes::load(row(area_vectors, e));
  };
  int k = 0;
  for (; k + 4 <= count; k += 4)
    for (int i = 0; i < 4; ++i) add(k + i, sums[i]);
  for (; k < count; ++k) add(k, sums[0]);
  const Lanes all = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  for (int i = 0; i < 4; ++i) sum[i] = all[i];
}

inline int evaluate(const JetShape& jet, const FieldArrays& a, int selected) {
  return by_kind(jet, [&]<bool round, bool axial>() { return evaluate_as<round, axial>(jet, a, selected); });
}

}  // namespace jet::JET_KERNELS
