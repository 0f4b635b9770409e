// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "element.hpp"
#include "kernel_table.hpp"
#include "lanes.hpp"
#include "membrane/fabric_laws.hpp"

// Steps of the pass over a block, for each element. T is Lanes, or double for the oracle. Both visit groups
// of four elements, keep four partial sums, and add at the nodes in the order of the elements, so they agree
// bit for bit.
namespace membrane::MEMBRANE_KERNELS {

// Partial sums of a block: four numbers, in 4 / width variables.
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
struct Parts {
  T value[4 / kWidth<T>] = {};
};
template <class T>
struct SkinParts {
  Parts<T> moment, area, porosity_area, porosity_squared_area, energy, frequency;
};

// Positions and sums of the block's nodes.
struct BlockNodes {
  alignas(64) double position[kBlockNodes][4];
  NodeSums sums[kBlockNodes];
};

inline void add_row(double* sum, Lanes row) {
  (Lanes::load(sum) + row).store(sum);
}
inline void subtract_row(double* sum, Lanes row) {
  (Lanes::load(sum) - row).store(sum);
}

template <class T>
struct Corners {
  Vec3<T> a, b, c;
};

// Area vectors and centroids (M.5) of the requested elements.
template <class T>
void geometry(const GeometryArrays& s) {
  for (int first = 0; first < s.count; first += kWidth<T>) {
    std::int64_t element[kWidth<T>];
    int corner[3][kWidth<T>];
    for (int i = 0; i < kWidth<T>; ++i) {
      const int place = first + i < s.count ? first + i : s.count - 1;
      element[i] = s.elements ? s.elements[place] : place;
      for (int c = 0; c < 3; ++c) corner[c][i] = s.corners[3 * element[i] + c];
    }
    const auto* position = reinterpret_cast<const double(*)[4]>(s.position);
    const Corners<T> x{load_nodes<T>(position, corner[0]), load_nodes<T>(position, corner[1]),
                       load_nodes<T>(position, corner[2])};
    const Rows<T> area_vector(cross(x.b - x.a, x.c - x.a) * T(0.5)), centroid(((x.a + x.b) + x.c) / T(3.0));
    for (int i = 0; i < kWidth<T>; ++i) {
      area_vector.row[i].store(s.area_vector + 4 * element[i]);
      centroid.row[i].store(s.centroid + 4 * element[i]);
    }
  }
}

// S1/S9 (M.5): adds area vectors at the corners, and areas and volume to the sums.
template <class T>
[[gnu::always_inline]] inline void add_surface(const SkinArrays& s, const Vec3<T>& origin, int group,
                                               int lane, const Corners<T>& x, BlockNodes& nodes,
                                               SkinParts<T>& sums) {
  const FabricGroup& fabric = s.fabric[s.group[group].fabric];
  const ElementGroup& g = s.group[group];
  const Vec3<T> area_vector = cross(x.b - x.a, x.c - x.a) * T(0.5);
  const T area = sqrt(dot(area_vector, area_vector));
  const int k = lane / kWidth<T>;
  sums.moment.value[k] = sums.moment.value[k] + dot(x.a - origin, area_vector);
  sums.area.value[k] = sums.area.value[k] + area;
  sums.porosity_area.value[k] = sums.porosity_area.value[k] + load<T>(fabric.porosity + lane) * area;
  sums.porosity_squared_area.value[k] =
      sums.porosity_squared_area.value[k] + load<T>(fabric.porosity_squared + lane) * area;
  const Rows<T> rows(area_vector);
  for (int i = 0; i < kWidth<T>; ++i)
    for (int corner = 0; corner < 3; ++corner)
      add_row(nodes.sums[g.node[corner][lane + i]].gradient, rows.row[i]);
}

// Columns of the deformation gradient and strain (M.1) of the elements of a group; later their nominal
// stress.
struct alignas(64) GroupWork {
  double f1[3][kLanes], f2[3][kLanes];           // [-]
  double e11[kLanes], e22[kLanes], e12[kLanes];  // [-]
  double n11[kLanes], n22[kLanes], n12[kLanes];  // -(volume S) [J]
  double notes[kMostNotes][kLanes];              // notes of the law's steps
};

template <class T>
[[gnu::always_inline]] inline void strain_of(const ElementGroup& g, int lane, const Corners<T>& x,
                                             GroupWork& work) {
  const Vec3<T> ab = x.b - x.a, ac = x.c - x.a;
  const T b1 = load<T>(g.gradient_b1 + lane), b2 = load<T>(g.gradient_b2 + lane),
          c2 = load<T>(g.gradient_c2 + lane);
  const T f1[3] = {stretch_1(ab.x, b1), stretch_1(ab.y, b1), stretch_1(ab.z, b1)};
  const T f2[3] = {stretch_2(ab.x, ac.x, b2, c2), stretch_2(ab.y, ac.y, b2, c2),
                   stretch_2(ab.z, ac.z, b2, c2)};
  for (int i = 0; i < 3; ++i) {
    store(work.f1[i] + lane, f1[i]);
    store(work.f2[i] + lane, f2[i]);
  }
  const PlaneStrain<T> e = green_lagrange_strain(f1, f2);
  store(work.e11 + lane, e.e11);
  store(work.e22 + lane, e.e22);
  store(work.e12 + lane, e.e12);
}

// A number as a type, for calls f(0), ..., f(count - 1).
template <int kNumber>
struct Number {
  static constexpr int value = kNumber;
};
template <class F, int... kNumbers>
[[gnu::always_inline]] inline void each(std::integer_sequence<int, kNumbers...>, F&& f) {
  (f(Number<kNumbers>{}), ...);
}

// Loads and stores aggregates of numbers, such as a law's Constants and Notes, from rows of groups.
template <class Aggregate, class T, int... kRow>
[[gnu::always_inline]] inline Aggregate load_rows(std::integer_sequence<int, kRow...>,
                                                  [[maybe_unused]] const double (*rows)[kLanes],
                                                  [[maybe_unused]] int lane) {
  return {load<T>(rows[kRow] + lane)...};
}
template <class Law, class T>
[[gnu::always_inline]] inline auto load_constants(const FabricGroup& fabric, int lane) {
  return load_rows<typename Law::template Constants<T>, T>(
      std::make_integer_sequence<int, kNumbersIn<Law::template Constants>>{}, fabric.constants, lane);
}
template <class Law, class T>
[[gnu::always_inline]] inline auto load_notes(const GroupWork& work, int lane) {
  return load_rows<typename Law::template Notes<T>, T>(
      std::make_integer_sequence<int, kNumbersIn<Law::template Notes>>{}, work.notes, lane);
}
template <class T, int kCount>
[[gnu::always_inline]] inline void store_row(const Row<T, kCount>& row, double (*rows)[kLanes], int lane) {
  each(
      std::make_integer_sequence<int, kCount>{}, [&](auto i) __attribute__((always_inline)) {
        store(rows[i.value] + lane, row.value[i.value]);
      });
}

template <class T>
[[gnu::always_inline]] inline PlaneStrain<T> load_strain(const GroupWork& work, int lane) {
  return {load<T>(work.e11 + lane), load<T>(work.e22 + lane), load<T>(work.e12 + lane)};
}

// Does a step of the law before its response.
template <class Law, int kStep, class T>
[[gnu::always_inline]] inline void take_law_step(const FabricGroup& fabric, int lane, GroupWork& work) {
  store_row(Law::template step<kStep>(load_strain<T>(work, lane), load_constants<Law, T>(fabric, lane),
                                      load_notes<Law, T>(work, lane)),
            work.notes + Law::kNotesBefore[kStep], lane);
}

// Stress (M.2, M.3, M.13, M.14, M.25, M.26, M.30), energy and the bound of omega^2 (M.10).
template <class Law, Compression kCompression, class T>
[[gnu::always_inline]] inline void law_stress(const ElementGroup& g, const FabricGroup& fabric,
                                              const YarnCurves& curves, const FrequencyGroup& frequency,
                                              int lane, GroupWork& work, SkinParts<T>& sums) {
  const PlaneResponse<T> r =
      Law::template response<kCompression>(load_strain<T>(work, lane), load_constants<Law, T>(fabric, lane),
                                           load_notes<Law, T>(work, lane), curves);
  const T volume = load<T>(g.volume + lane);
  store(work.n11 + lane, -(volume * r.s11));
  store(work.n22 + lane, -(volume * r.s22));
  store(work.n12 + lane, -(volume * r.s12));
  const int k = lane / kWidth<T>;
  sums.energy.value[k] = sums.energy.value[k] + volume * r.energy_density;
  const T bound = frequency_bound(load<T>(frequency.material + lane), load<T>(frequency.geometric + lane),
                                  r.tangent_factor, r.stress_1);
  sums.frequency.value[k] = select(bound > sums.frequency.value[k], bound, sums.frequency.value[k]);
}

// Adds the forces -dW/dx at the corners (M.4).
template <class T>
[[gnu::always_inline]] inline void add_forces(const ElementGroup& g, int lane, const GroupWork& work,
                                              BlockNodes& nodes) {
  const T b1 = load<T>(g.gradient_b1 + lane), b2 = load<T>(g.gradient_b2 + lane),
          c2 = load<T>(g.gradient_c2 + lane);
  const T n11 = load<T>(work.n11 + lane), n22 = load<T>(work.n22 + lane), n12 = load<T>(work.n12 + lane);
  const Vec3<T> f1{load<T>(work.f1[0] + lane), load<T>(work.f1[1] + lane), load<T>(work.f1[2] + lane)};
  const Vec3<T> f2{load<T>(work.f2[0] + lane), load<T>(work.f2[1] + lane), load<T>(work.f2[2] + lane)};
  const Rows<T> on_b(f1 * (n11 * b1 + n12 * b2) + f2 * (n12 * b1 + n22 * b2));
  const Rows<T> on_c(f1 * (n12 * c2) + f2 * (n22 * c2));
  for (int i = 0; i < kWidth<T>; ++i) {
    subtract_row(nodes.sums[g.node[0][lane + i]].force, on_b.row[i] + on_c.row[i]);
    add_row(nodes.sums[g.node[1][lane + i]].force, on_b.row[i]);
    add_row(nodes.sums[g.node[2][lane + i]].force, on_c.row[i]);
  }
}

}  // namespace membrane::MEMBRANE_KERNELS
