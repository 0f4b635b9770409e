// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "element.hpp"
#include "kernel_table.hpp"
#include "lanes.hpp"
#include "membrane/orthotropic.hpp"

// Kernels over elements. T is Lanes, or double for the oracle; both visit groups of four elements and keep
// four partial sums, so that they agree bit for bit.
namespace membrane::MEMBRANE_KERNELS {

// Partial sums of a group: four numbers, in 4 / width variables.
template <class T>
inline constexpr int kParts = 1;
template <>
inline constexpr int kParts<double> = 4;

inline double sum_parts(const Lanes (&part)[1]) {
  return sum_lanes(part[0]);
}
inline double sum_parts(const double (&part)[4]) {
  return (part[0] + part[1]) + (part[2] + part[3]);
}

inline double max_parts(const double (&part)[4]) {
  double largest = part[0];
  for (const double value : part) largest = value > largest ? value : largest;
  return largest;
}
inline double max_parts(const Lanes (&part)[1]) {
  const double lanes[4] = {part[0][0], part[0][1], part[0][2], part[0][3]};
  return max_parts(lanes);
}

template <class T>
struct SurfaceParts {
  T moment{}, area{}, porosity_area{}, porosity_squared_area{};
};

template <class T>
[[gnu::always_inline]] inline void surface_of(const SurfaceArrays& s, const Vec3<T>& origin, int e,
                                              SurfaceParts<T>& sums) {
  const Vec3<T> a = load_nodes<T>(s.position, s.node_a + e);
  const Vec3<T> b = load_nodes<T>(s.position, s.node_b + e);
  const Vec3<T> c = load_nodes<T>(s.position, s.node_c + e);
  const Vec3<T> area_vector = cross(b - a, c - a) * T(0.5);
  const T area = sqrt(dot(area_vector, area_vector));
  store_rows(s.area_vector + 4 * std::int64_t{e}, area_vector);
  store_rows(s.centroid + 4 * std::int64_t{e}, ((a + b) + c) / T(3.0));
  store(s.area + e, area);
  sums.moment = sums.moment + dot(a - origin, area_vector);
  sums.area = sums.area + area;
  sums.porosity_area = sums.porosity_area + load<T>(s.porosity + e) * area;
  sums.porosity_squared_area = sums.porosity_squared_area + load<T>(s.porosity_squared + e) * area;
}

template <class T>
void surface(const SurfaceArrays& s, int first, int last, SurfaceTotals& totals) {
  constexpr int parts = kParts<T>;
  const Vec3<T> origin{T(s.position[0]), T(s.position[1]), T(s.position[2])};
  SurfaceParts<T> sums[parts];
  for (int e = first; e < last; e += 4)
    for (int k = 0; k < parts; ++k) surface_of<T>(s, origin, e + k, sums[k]);
  T moment[parts], area[parts], porous[parts], squared[parts];
  for (int k = 0; k < parts; ++k) {
    moment[k] = sums[k].moment;
    area[k] = sums[k].area;
    porous[k] = sums[k].porosity_area;
    squared[k] = sums[k].porosity_squared_area;
  }
  totals = {sum_parts(moment), sum_parts(area), sum_parts(porous), sum_parts(squared)};
}

// Corner forces -dW/dx_a of one element (M.4), corner by corner and component by component.
template <class T>
void store_corner_forces(double* out, const Vec3<T>& on_b, const Vec3<T>& on_c) {
  store(out, -(on_b.x + on_c.x));
  store(out + 4, -(on_b.y + on_c.y));
  store(out + 8, -(on_b.z + on_c.z));
  store(out + 12, on_b.x);
  store(out + 16, on_b.y);
  store(out + 20, on_b.z);
  store(out + 24, on_c.x);
  store(out + 28, on_c.y);
  store(out + 32, on_c.z);
}

template <class T>
void load_fabric(const ForceArrays& s, int e, IsotropicConstants<T>& out) {
  out = {load<T>(s.young + e), load<T>(s.spherical + e), load<T>(s.deviator + e)};
}
template <class T>
void load_fabric(const ForceArrays& s, int e, OrthotropicConstants<T>& out) {
  const WeaveArrays& w = s.weave;
  out = {load<T>(w.cosine + e),    load<T>(w.sine + e),     load<T>(w.warp_scale + e),
         load<T>(s.spherical + e), load<T>(s.deviator + e), load<T>(w.shear + e),
         load<T>(w.series + e),    load<T>(w.skew + e),     load<T>(w.taut + e)};
}

template <Compression kCompression, class T>
[[gnu::always_inline]] inline PlaneResponse<T> response(const PlaneStrain<T>& e,
                                                        const IsotropicConstants<T>& c) {
  return isotropic_response<kCompression>(e, c);
}
template <Compression kCompression, class T>
[[gnu::always_inline]] inline PlaneResponse<T> response(const PlaneStrain<T>& e,
                                                        const OrthotropicConstants<T>& c) {
  return orthotropic_response<kCompression>(e, c);
}

template <template <class> class Fabric, Compression kCompression, class T>
[[gnu::always_inline]] inline void forces_of(const ForceArrays& s, int e, double* out, T& energy,
                                             T& frequency) {
  const Vec3<T> a = load_nodes<T>(s.position, s.node_a + e);
  const Vec3<T> ab = load_nodes<T>(s.position, s.node_b + e) - a;
  const Vec3<T> ac = load_nodes<T>(s.position, s.node_c + e) - a;
  const T b1 = load<T>(s.gradient_b1 + e), b2 = load<T>(s.gradient_b2 + e), c2 = load<T>(s.gradient_c2 + e);
  const T f1[3] = {stretch_1(ab.x, b1), stretch_1(ab.y, b1), stretch_1(ab.z, b1)};
  const T f2[3] = {stretch_2(ab.x, ac.x, b2, c2), stretch_2(ab.y, ac.y, b2, c2),
                   stretch_2(ab.z, ac.z, b2, c2)};
  Fabric<T> fabric;
  load_fabric(s, e, fabric);
  const auto r = response<kCompression>(green_lagrange_strain(f1, f2), fabric);

  const T volume = load<T>(s.volume + e);
  const T n11 = -(volume * r.s11), n22 = -(volume * r.s22), n12 = -(volume * r.s12);
  const T on_b_1 = n11 * b1 + n12 * b2, on_b_2 = n12 * b1 + n22 * b2;
  const T on_c_1 = n12 * c2, on_c_2 = n22 * c2;
  const Vec3<T> column_1{f1[0], f1[1], f1[2]}, column_2{f2[0], f2[1], f2[2]};
  store_corner_forces(out, column_1 * on_b_1 + column_2 * on_b_2, column_1 * on_c_1 + column_2 * on_c_2);

  energy = energy + volume * r.energy_density;
  const T bound = frequency_bound(load<T>(s.material_frequency + e), load<T>(s.geometric_frequency + e),
                                  r.strain_1, r.stress_1);
  frequency = select(bound > frequency, bound, frequency);
}

template <template <class> class Fabric, Compression kCompression, class T>
void element_forces(const ForceArrays& s, int first, int last, ForceTotals& totals) {
  T energy[kParts<T>] = {};
  T frequency[kParts<T>] = {};
  for (int e = first; e < last; e += 4) {
    double* group = s.corner_force + 9 * std::int64_t{e};
    for (int k = 0; k < kParts<T>; ++k)
      forces_of<Fabric, kCompression, T>(s, e + k, group + k, energy[k], frequency[k]);
  }
  totals = {sum_parts(energy), max_parts(frequency)};
}

}  // namespace membrane::MEMBRANE_KERNELS
