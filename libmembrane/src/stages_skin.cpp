// SPDX-License-Identifier: Apache-2.0
// S1/S9 surface and the fabric's part of S3: passes over the blocks of elements.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "checks.hpp"
#include "kernel_table.hpp"
#include "membrane/error.hpp"
#include "membrane/law_table.hpp"
#include "membrane/node_order.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace membrane {

namespace {

SkinPass pass_of(SkinParts parts) {
  if (parts == SkinParts::surface) return kSurfacePass;
  if (parts != SkinParts::forces && parts != SkinParts::both)
    throw std::invalid_argument("parts of the skin: is not an enumerator");
  return parts == SkinParts::forces ? kForcesPass : kSkinPass;
}

SkinArrays skin_arrays(const BagModel& model, BagState& state, std::size_t b) {
  const BlockTable& table = model.elements;
  const ElementBlock& block = table.block[b];
  // Prefetching pays above this size (measured).
  const bool fetch = model.element_count > kCachedElements && b + 1 < table.block.size();
  const ElementBlock next = fetch ? table.block[b + 1] : ElementBlock{};
  return {table.group.data() + block.first_group,
          table.fabric.data(),
          &model.yarns,
          state.shares.frequency.data() + block.first_group,
          block.last_group - block.first_group,
          table.node.data() + block.first_node,
          block.first_shared - block.first_node,
          block.last_node - block.first_node,
          next.last_group - next.first_group,
          next.last_node - next.first_node,
          state.position.data(),
          model.inverse_mass.data(),
          state.membrane_force.data(),
          state.volume_gradient.data(),
          state.shared_sums.data() + block.first_slot};
}

KernelTable::Skin skin_kernel(const BagModel& model, SkinParts parts) {
  const KernelTable& table = kernel_table(model.description.isa);
  pass_of(parts);  // throws for an invalid value
  if (parts == SkinParts::surface) return table.surface;
  const auto& kernels = parts == SkinParts::forces ? table.forces : table.skin;
  return kernels[model.law].compression[model.description.compression == Compression::none ? 1 : 0];
}

void geometry(const BagModel& model, BagState& state, const int* elements, int count) {
  check_state(model, state);
  if (state.area_vector.empty()) reject("update_geometry", "the state was made without LoadKinds::jet");
  kernel_table(model.description.isa)
      .geometry({state.position.data(), model.description.elements.data(), elements, count,
                 state.area_vector.data(), state.centroid.data()});
}

int shared_count(const BagModel& model) {
  return static_cast<int>(model.shared.node.size());
}

// The volume is taken about the first node, (1/3) sum of (x_a - x_0) . S_e, so that it does not depend on the
// origin. On a closed surface this is (1/6) sum of x_a . (x_b x x_c).
void sum_surface(const BagModel& model, BagState& state) {
  SurfaceSums sums;
  double moment = 0.0;
  for (int b = 0; b < element_blocks(model); ++b) {
    const SurfaceSums& block = state.block[static_cast<std::size_t>(b)].surface;
    moment += block.volume;
    sums.area += block.area;
    sums.porosity_area += block.porosity_area;
    sums.porosity_squared_area += block.porosity_squared_area;
    sums.gradient_mobility += block.gradient_mobility;
  }
  for (int b = 0; b < shared_blocks(model); ++b)
    sums.gradient_mobility += state.block[static_cast<std::size_t>(b)].shared_mobility;
  sums.volume = moment / 3.0;
  if (!std::isfinite(sums.volume) || !std::isfinite(sums.area))
    throw MembraneError("stage surface: the enclosed volume is not finite");
  state.surface = sums;
}

void sum_forces(const BagModel& model, BagState& state) {
  double energy = 0.0, frequency = 0.0;
  for (int b = 0; b < element_blocks(model); ++b) {
    const ForceSums& block = state.block[static_cast<std::size_t>(b)].forces;
    energy += block.strain_energy;
    frequency = std::max(frequency, block.element_frequency);
  }
  const LawTraits& law = fabric_laws()[static_cast<std::size_t>(model.law)];
  if (law.end != nullptr && std::isinf(frequency))
    throw MembraneError("stage forces: element " + std::to_string(governing_element(model, state)) + " " +
                        law.end);
  state.forces.strain_energy = energy;
  state.forces.element_frequency = frequency;
}

}  // namespace

int element_blocks(const BagModel& model) {
  return static_cast<int>(model.elements.block.size());
}
int shared_blocks(const BagModel& model) {
  return (shared_count(model) + kNodeBlock - 1) / kNodeBlock;
}
int node_blocks(const BagModel& model) {
  return (model.node_count + kNodeBlock - 1) / kNodeBlock;
}

void skin_block(const BagModel& model, BagState& state, SkinParts parts, int block) {
  const auto b = static_cast<std::size_t>(block);
  SkinTotals totals{};
  skin_kernel(model, parts)(skin_arrays(model, state, b), totals);
  BlockSums& sums = state.block[b];
  if (parts != SkinParts::forces)
    sums.surface = {totals.moment, totals.area, totals.porosity_area, totals.porosity_squared_area,
                    totals.mobility};
  if (parts == SkinParts::surface) return;
  sums.forces.strain_energy = totals.energy;
  sums.forces.element_frequency = totals.frequency;
}

void update_geometry(const BagModel& model, BagState& state, std::span<const int> elements) {
  require_elements("update_geometry", model, elements);
  geometry(model, state, elements.data(), static_cast<int>(elements.size()));
}

void update_geometry(const BagModel& model, BagState& state) {
  geometry(model, state, nullptr, model.element_count);
}

void shared_block(const BagModel& model, BagState& state, SkinParts parts, int block) {
  const int first = block * kNodeBlock, last = std::min(first + kNodeBlock, shared_count(model));
  const SharedArrays arrays{model.shared.node.data(),    model.shared.row_begin.data(),
                            model.shared.slot.data(),    state.shared_sums.data(),
                            model.inverse_mass.data(),   state.membrane_force.data(),
                            state.volume_gradient.data()};
  kernel_table(model.description.isa)
      .shared[pass_of(parts)](arrays, first, last,
                              state.block[static_cast<std::size_t>(block)].shared_mobility);
}

void sum_skin(const BagModel& model, BagState& state, SkinParts parts) {
  if (parts != SkinParts::forces) sum_surface(model, state);
  if (parts != SkinParts::surface) sum_forces(model, state);
}

}  // namespace membrane
