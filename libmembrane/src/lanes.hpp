// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "membrane/element_group.hpp"

// Four double lanes on the compiler's vector extension. There are always four, so that the order of every sum
// is the same on every instruction set. (The masks of std::experimental's fixed_size_simd<double, 4> are bit
// sets, so that each blend passes through integer registers.) The type is in the namespace of its instruction
// set: so templates over it differ between translation units, and the linker cannot mix them up.
#if defined(__AVX__)
#include "lanes_whole.hpp"
#else
#include "lanes_halves.hpp"
#endif

namespace membrane::MEMBRANE_KERNELS {

inline Lanes& operator+=(Lanes& a, Lanes b) {
  return a = a + b;
}
inline double sum_lanes(Lanes a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

template <class T>
inline constexpr int kWidth = 4;  // elements handled at a time
template <>
inline constexpr int kWidth<double> = 1;

// Vectors of the elements e ... e + 3 (T = Lanes) or of one element (T = double).
template <class T>
struct Vec3 {
  T x, y, z;
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const Vec3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator/(const Vec3& a, T s) { return {a.x / s, a.y / s, a.z / s}; }
  friend T dot(const Vec3& a, const Vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  friend Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

template <class T>
T load(const double* p);
template <>
inline double load<double>(const double* p) {
  return *p;
}
template <>
inline Lanes load<Lanes>(const double* p) {
  return Lanes::load(p);
}
inline void store(double* p, double v) {
  *p = v;
}
inline void store(double* p, Lanes v) {
  v.store(p);
}

// Positions of the nodes of one corner; x has 4 doubles a node.
template <class T, class Index>
[[gnu::always_inline]] inline Vec3<T> load_nodes(const double (*x)[4], const Index* node) {
  if constexpr (kWidth<T> == 1) {
    const double* p = x[*node];
    return {p[0], p[1], p[2]};
  } else {
    const Lanes row[4] = {Lanes::load(x[node[0]]), Lanes::load(x[node[1]]), Lanes::load(x[node[2]]),
                          Lanes::load(x[node[3]])};
    Vec3<Lanes> v;
    to_lanes(row, v.x, v.y, v.z);
    return v;
  }
}

// Vectors of four elements (or of one) as rows (x, y, z, 0), one for each element.
template <class T>
struct Rows {
  Lanes row[kLanes];
  explicit Rows(const Vec3<Lanes>& v) { to_rows(v.x, v.y, v.z, row); }
};
template <>
struct Rows<double> {
  Lanes row[1];
  explicit Rows(const Vec3<double>& v) {
    alignas(32) const double values[4] = {v.x, v.y, v.z, 0.0};
    row[0] = Lanes::load(values);
  }
};

}  // namespace membrane::MEMBRANE_KERNELS
