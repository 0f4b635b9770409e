// SPDX-License-Identifier: Apache-2.0
// Projects nodes and rays to local coordinates along the jet. These are at most 1, so as floats they err by
// 2^-25.
#pragma once

#include "floats.hpp"

namespace jet::JET_KERNELS {

[[gnu::always_inline]] inline Floats largest(const Vec3<Floats>& a) {
  return max(max(abs(a.x), abs(a.y)), abs(a.z));
}

struct NodeFlags {
  Lanes::Values smallest = Lanes(1.0).v;  // smallest coordinate that is not 0, less one unit of rounding
  Floats::Mask largest{};                 // bits of the largest magnitude; those of NaN are larger
};

/// Four points to local coordinates in double.
[[gnu::always_inline]] inline Vec3<Lanes> to_local(const ProjectArrays& a, const Vec3<Lanes>& x) {
  const Vec3<Lanes> d = {x.x - a.centre[0], x.y - a.centre[1], x.z - a.centre[2]};
  const auto along = [&](int j) {
    return a.column[0][j] * d.x + a.column[1][j] * d.y + a.column[2][j] * d.z;
  };
  return {along(0), along(1), along(2)};
}

/// The same for nodes.
[[gnu::always_inline]] inline Vec3<Lanes> to_local(const ProjectArrays& a, const Vec3<Lanes>& x,
                                                   NodeFlags& flags) {
  const Lanes all[] = {x.x, x.y, x.z};
  for (const Lanes y : all) {
    const auto below = reinterpret_cast<Lanes::Values>(reinterpret_cast<Lanes::Mask>(abs(y).v) - 1);
    flags.smallest = below < flags.smallest ? below : flags.smallest;  // 0 became NaN and is skipped
  }
  return to_local(a, x);
}

[[gnu::always_inline]] inline Floats joined(Lanes low, Lanes high) {
#if defined(__AVX__)  // gcc adds a copy to the conversion
  const auto four = [](Lanes x) { return _mm256_cvtpd_ps(reinterpret_cast<__m256d>(x.v)); };
  return Floats(reinterpret_cast<Floats::Values>(_mm256_set_m128(four(high), four(low))));
#else
  return Floats(__builtin_shufflevector(__builtin_convertvector(low.v, Row),
                                        __builtin_convertvector(high.v, Row), 0, 1, 2, 3, 4, 5, 6, 7));
#endif
}

/// Sides on which the nodes are outside, see ProjectArrays.
[[gnu::always_inline]] inline Floats::Mask sides_code(const ProjectArrays& a, const Vec3<Floats>& x) {
  const auto low = [&](int i, Floats y) { return (y - a.slope[i] * x.z < Floats(-a.bound[i])) & (1 << i); };
  const auto high = [&](int i, Floats y) { return (y - a.slope[i] * x.z > Floats(a.bound[i])) & (1 << i); };
  return low(0, x.x) | high(1, x.x) | low(2, x.y) | high(3, x.y) | ((x.z < Floats(-a.bound[4])) & (1 << 4));
}

/// Stores eight rows of four, row i to to(i).
template <class To>
[[gnu::always_inline]] inline void store_rows(To to, const Vec3<Floats>& x, Floats fourth) {
  const auto xy_0145 = __builtin_shufflevector(x.x.v, x.y.v, 0, 8, 1, 9, 4, 12, 5, 13);
  const auto xy_2367 = __builtin_shufflevector(x.x.v, x.y.v, 2, 10, 3, 11, 6, 14, 7, 15);
  const auto z_0145 = __builtin_shufflevector(x.z.v, fourth.v, 0, 8, 1, 9, 4, 12, 5, 13);
  const auto z_2367 = __builtin_shufflevector(x.z.v, fourth.v, 2, 10, 3, 11, 6, 14, 7, 15);
  const auto even = [](auto p, auto q) { return __builtin_shufflevector(p, q, 0, 1, 8, 9, 4, 5, 12, 13); };
  const auto odd = [](auto p, auto q) { return __builtin_shufflevector(p, q, 2, 3, 10, 11, 6, 7, 14, 15); };
  const Floats::Values pairs[4] = {even(xy_0145, z_0145), odd(xy_0145, z_0145), even(xy_2367, z_2367),
                                   odd(xy_2367, z_2367)};
  for (int i = 0; i < 4; ++i) {
    *reinterpret_cast<UnalignedRow*>(to(i)) = __builtin_shufflevector(pairs[i], pairs[i], 0, 1, 2, 3);
#if defined(__AVX__)  // gcc uses two instructions
    _mm_storeu_ps(to(i + 4), _mm256_extractf128_ps(reinterpret_cast<__m256>(pairs[i]), 1));
#else
    *reinterpret_cast<UnalignedRow*>(to(i + 4)) = __builtin_shufflevector(pairs[i], pairs[i], 4, 5, 6, 7);
#endif
  }
}

/// Projects eight nodes, in the rows that `at` gives, and calls store(x, below) with bit 7 set where w <= 0.
template <bool smallest, class At, class Store>
[[gnu::always_inline]] inline void project_eight(const ProjectArrays& a, At at, NodeFlags& flags,
                                                 Store store) {
  const auto local = [&](const Vec3<Lanes>& x) { return smallest ? to_local(a, x, flags) : to_local(a, x); };
  const Vec3<Lanes> low = local(gather(at(0), at(1), at(2), at(3))),
                    high = local(gather(at(4), at(5), at(6), at(7)));
  const Vec3<Floats> x = {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
  const Floats all[] = {x.x, x.y, x.z};
  for (const Floats y : all) {
    const auto magnitude = reinterpret_cast<Floats::Mask>(y.v) & INT32_MAX;
    flags.largest = magnitude > flags.largest ? magnitude : flags.largest;
  }
  const auto half = [](Lanes::Mask m) { return reinterpret_cast<Floats::Mask>(m); };
  store(x,
        __builtin_shufflevector(half(low.z <= Lanes()), half(high.z <= Lanes()), 0, 2, 4, 6, 8, 10, 12, 14) &
            0x80);
}

/// Stores rows with codes to to(0) ... to(7).
template <class To>
[[gnu::always_inline]] inline Floats::Mask store_local(const ProjectArrays& a, const Vec3<Floats>& x,
                                                       Floats::Mask below, To to) {
  const Floats::Mask code = sides_code(a, x) | below;
  store_rows(to, x, Floats(reinterpret_cast<Floats::Values>(code)));
  return code;
}

inline ProjectFlags project_flags(const NodeFlags& flags) {
  constexpr std::int32_t one = 0x3f800000, little = 0x3c800000;  // bits of 1 and 1/64
  const auto small = Lanes(flags.smallest) < Lanes(1e-100);
  return {bits(flags.largest > one) != 0, bits(flags.largest > little) == 0, bits(small) != 0};
}

/// Projects all nodes, and up to seven more that repeat the last. Calls store(i, x, below) for those from i
/// on.
template <class Store>
[[gnu::always_inline]] inline ProjectFlags project_each(const ProjectArrays& a, Store store) {
  NodeFlags flags;
  const std::ptrdiff_t stride = a.nodes.stride;
  const double* x = a.nodes.first;
  int i = 0;
  const auto eight = [&](const Vec3<Floats>& local, Floats::Mask below) __attribute__((always_inline)) {
    store(i, local, below);
  };
  for (; i + 8 < a.count; i += 8, x += 8 * stride)
    project_eight<true>(
        a, [=](int j) __attribute__((always_inline)) { return x + j * stride; }, flags, eight);
  project_eight<true>(
      a, [&](int j) { return row(a.nodes, i + j < a.count ? i + j : a.count - 1); }, flags, eight);
  return project_flags(flags);
}

/// Computes local coordinates and codes.
inline ProjectFlags project_nodes(const ProjectArrays& arrays) {
  const ProjectArrays a = arrays;  // a copy, so that stores cannot change it
  return project_each(
      a, [&](int i, const Vec3<Floats>& x, Floats::Mask below) __attribute__((always_inline)) {
        float* local = a.local + 4 * std::ptrdiff_t{i};
        const auto code = store_local(
            a, x, below, [=](int j) __attribute__((always_inline)) { return local + 4 * j; });
        *reinterpret_cast<UnalignedInts*>(a.codes + i) = code;
      });
}

/// Computes only the sides in the codes.
inline ProjectFlags code_nodes(const ProjectArrays& arrays) {
  const ProjectArrays a = arrays;
  return project_each(
      a, [&](int i, const Vec3<Floats>& x, Floats::Mask) __attribute__((always_inline)) {
        *reinterpret_cast<UnalignedInts*>(a.codes + i) = sides_code(a, x);
      });
}

inline ProjectFlags project_listed(const ProjectArrays& arrays, int count) {
  const ProjectArrays a = arrays;
  NodeFlags flags;
  const std::ptrdiff_t stride = a.nodes.stride;
  const double* first = a.nodes.first;
  const std::uint32_t *row_of = a.listed, *end = row_of + count;
  const bool with_last = count > 0 && static_cast<int>(end[-1] / 4) == a.nodes.last;
  const auto store = [&](const Vec3<Floats>& x, Floats::Mask below) __attribute__((always_inline)) {
    store_local(
        a, x, below, [&](int j) __attribute__((always_inline)) { return a.local + row_of[j]; });
  };
  for (const std::uint32_t* stop = with_last ? end - 8 : end; row_of < stop; row_of += 8)
    project_eight<false>(
        a, [=](int j) __attribute__((always_inline)) { return first + row_of[j] / 4 * stride; }, flags,
        store);
  if (with_last)
    project_eight<false>(
        a, [&](int j) { return row(a.nodes, static_cast<int>(row_of[j] / 4)); }, flags, store);
  return project_flags(flags);
}

/// Local centroids of the listed elements k to k + 7. Places behind the last one repeat it.
[[gnu::always_inline]] inline Vec3<Floats> local_centroids(const ProjectArrays& a, int k, int count) {
  const auto corner = [&](int first, int i) __attribute__((always_inline)) {
    const auto node = [ =, &a ](int j) __attribute__((always_inline)) {
      const int e = a.elements[first + j < count ? first + j : count - 1];
      return row(a.nodes, a.triangles[3 * std::ptrdiff_t{e} + i]);
    };
    return gather(node(0), node(1), node(2), node(3));
  };
  const auto four = [&](int first) __attribute__((always_inline)) {
    const Vec3<Lanes> p = corner(first, 0), q = corner(first, 1), r = corner(first, 2);
    constexpr double third = 1.0 / 3.0;
    return to_local(a, {third * (p.x + q.x + r.x), third * (p.y + q.y + r.y), third * (p.z + q.z + r.z)});
  };
  const Vec3<Lanes> low = four(k), high = four(k + 4);
  return {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
}

}  // namespace jet::JET_KERNELS
