// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "element_kernels.hpp"
#include "node_kernels.hpp"

// The pass over the elements of a block. It reads the block's positions once, and writes the sums at its
// nodes once.
namespace membrane::MEMBRANE_KERNELS {

inline constexpr bool has_forces(SkinPass pass) {
  return pass != kSurfacePass;
}
inline constexpr bool has_surface(SkinPass pass) {
  return pass != kForcesPass;
}

template <SkinPass kPass>
void copy_in(const SkinArrays& s, BlockNodes& nodes) {
  const Lanes zero;
  for (int n = 0; n < s.node_count; ++n) {
    Lanes::load(s.position + 4 * std::int64_t{s.node[n]}).store(nodes.position[n]);
    if constexpr (has_forces(kPass)) zero.store(nodes.sums[n].force);
    if constexpr (has_surface(kPass)) zero.store(nodes.sums[n].gradient);
  }
}

// Force and gradient at one node, if the pass computes them.
template <SkinPass kPass>
struct NodeRows {
  Lanes force{}, gradient{};
  void add(const NodeSums& sums) {
    if constexpr (has_forces(kPass)) force += Lanes::load(sums.force);
    if constexpr (has_surface(kPass)) gradient += Lanes::load(sums.gradient);
  }
};

// Writes to the nodal arrays and adds to the mobility g^T M^-1 g of the volume gradient.
template <SkinPass kPass, class Arrays>
[[gnu::always_inline]] inline void write_node(const Arrays& s, std::int64_t node, const NodeRows<kPass>& rows,
                                              Lanes& mobility) {
  if constexpr (has_forces(kPass)) rows.force.store(s.force + 4 * node);
  if constexpr (has_surface(kPass)) {
    const Lanes gradient = rows.gradient * Lanes(1.0 / 3.0);
    gradient.store(s.gradient + 4 * node);
    mobility += gradient * gradient * Lanes::load(s.inverse_mass + 4 * node);
  }
}

template <SkinPass kPass>
double copy_out(const SkinArrays& s, const BlockNodes& nodes) {
  Lanes mobility{};
  for (int n = 0; n < s.own_count; ++n) {
    NodeRows<kPass> rows;
    rows.add(nodes.sums[n]);
    write_node(s, s.node[n], rows, mobility);
  }
  for (int n = s.own_count; n < s.node_count; ++n) {
    NodeSums& part = s.shared_sums[n - s.own_count];
    if constexpr (has_forces(kPass)) Lanes::load(nodes.sums[n].force).store(part.force);
    if constexpr (has_surface(kPass)) Lanes::load(nodes.sums[n].gradient).store(part.gradient);
  }
  return sum_lanes(mobility);
}

// Calls f(group, lane) for the elements of the groups [first, last), with one call for all lanes of T.
template <class T, class F>
[[gnu::always_inline]] inline void for_lanes(int first, int last, F&& f) {
  for (int group = first; group < last; ++group)
    for (int lane = 0; lane < kLanes; lane += kWidth<T>) f(group, lane);
}

// Prefetches a part of the next block while the groups [first, last) are computed. Without it, the processor
// waits for the nodes of each block. Always inline: gcc drops calls of a function that only prefetches.
[[gnu::always_inline]] inline void fetch_next(const SkinArrays& s, int first, int last) {
  constexpr int kLine = 64, kForWriting = 1, kSecondLevel = 2;
  const auto part = [&](int count, int group) {
    return static_cast<int>(std::int64_t{count} * group / s.group_count);
  };
  for (int g = part(s.next_groups, first); g < part(s.next_groups, last); ++g) {
    const auto* group = reinterpret_cast<const char*>(s.group + s.group_count + g);
    for (std::size_t i = 0; i < sizeof(ElementGroup); i += kLine)
      __builtin_prefetch(group + i, 0, kSecondLevel);
    __builtin_prefetch(s.frequency + s.group_count + g, 0, kSecondLevel);
  }
  for (int n = part(s.next_nodes, first); n < part(s.next_nodes, last); ++n) {
    const std::int64_t row = 4 * std::int64_t{s.node[s.node_count + n]};
    __builtin_prefetch(s.position + row, 0, kSecondLevel);
    __builtin_prefetch(s.force + row, kForWriting, kSecondLevel);
    __builtin_prefetch(s.gradient + row, kForWriting, kSecondLevel);
  }
}

// Handles several groups at a time, step by step, because the stress needs slow roots and quotients: a
// processor can overlap one step of several groups, but not whole elements.
template <SkinPass kPass, class Law, Compression kCompression, class T>
void skin(const SkinArrays& s, SkinTotals& totals) {
  constexpr int kChunk = 8;
  BlockNodes nodes;
  GroupWork work[kChunk];
  copy_in<kPass>(s, nodes);
  const Vec3<T> origin{T(s.position[0]), T(s.position[1]), T(s.position[2])};
  SkinParts<T> sums;
  for (int first = 0; first < s.group_count; first += kChunk) {
    const int last = first + kChunk < s.group_count ? first + kChunk : s.group_count;
    if (s.next_nodes != 0) fetch_next(s, first, last);
    for_lanes<T>(
        first, last, [&](int group, int lane) __attribute__((always_inline)) {
          const ElementGroup& g = s.group[group];
          const Corners<T> x{load_nodes<T>(nodes.position, g.node[0] + lane),
                             load_nodes<T>(nodes.position, g.node[1] + lane),
                             load_nodes<T>(nodes.position, g.node[2] + lane)};
          if constexpr (has_forces(kPass)) strain_of<T>(g, lane, x, work[group - first]);
          if constexpr (has_surface(kPass)) add_surface<T>(s, origin, group, lane, x, nodes, sums);
        });
    if constexpr (!has_forces(kPass)) continue;
    each(
        std::make_integer_sequence<int, Law::kSteps>{}, [&](auto step) __attribute__((always_inline)) {
          for_lanes<T>(
              first, last, [&](int group, int lane) __attribute__((always_inline)) {
                take_law_step<Law, step.value, T>(s.fabric[s.group[group].fabric], lane, work[group - first]);
              });
        });
    for_lanes<T>(
        first, last, [&](int group, int lane) __attribute__((always_inline)) {
          law_stress<Law, kCompression, T>(s.group[group], s.fabric[s.group[group].fabric], *s.curves,
                                           s.frequency[group], lane, work[group - first], sums);
        });
    for_lanes<T>(
        first, last, [&](int group, int lane) __attribute__((always_inline)) {
          add_forces<T>(s.group[group], lane, work[group - first], nodes);
        });
  }
  totals = {sum_parts(sums.moment.value),        sum_parts(sums.area.value),
            sum_parts(sums.porosity_area.value), sum_parts(sums.porosity_squared_area.value),
            copy_out<kPass>(s, nodes),           sum_parts(sums.energy.value),
            max_parts(sums.frequency.value)};
}

// Sums the shared nodes [first, last) over their blocks.
template <SkinPass kPass>
void shared(const SharedArrays& s, int first, int last, double& mobility) {
  Lanes sum{};
  for (int i = first; i < last; ++i) {
    NodeRows<kPass> rows;
    for (std::int32_t k = s.row_begin[i]; k < s.row_begin[i + 1]; ++k) rows.add(s.sums[s.slot[k]]);
    write_node(s, s.node[i], rows, sum);
  }
  mobility = sum_lanes(sum);
}

template <SkinPass kPass, class Law, class T>
constexpr KernelTable::OfLaw law_kernels() {
  if constexpr (Law::traits.compression)
    return {{skin<kPass, Law, Compression::linear, T>, skin<kPass, Law, Compression::none, T>}};
  else
    return {{nullptr, skin<kPass, Law, Compression::none, T>}};
}

template <class T, class... Law>
constexpr KernelTable make_table(LawList<Law...>) {
  return {skin<kSurfacePass, Isotropic, Compression::linear, T>,
          {law_kernels<kForcesPass, Law, T>()...},
          {law_kernels<kSkinPass, Law, T>()...},
          geometry<T>,
          {shared<kSurfacePass>, shared<kForcesPass>, shared<kSkinPass>},
          advance};
}

template <class T>
inline constexpr KernelTable kTableOf = make_table<T>(FabricLaws{});

}  // namespace membrane::MEMBRANE_KERNELS
