// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "kernel_table.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

NodeArrays node_arrays(const BagModel& model, const BagState& state, const double* overpressure,
                       Vectors& out) {
  return {model.corners.row_begin.data(),
          model.corners.element.data(),
          model.corners.offset.data(),
          model.inverse_mass.data(),
          state.corner_force.data(),
          state.area_vector.data(),
          overpressure,
          out.data()};
}

}  // namespace

void element_force_block(const BagModel& model, BagState& state, int block) {
  const ElementConstants& c = model.constants;
  const ForceArrays arrays{c.node_a.data(),
                           c.node_b.data(),
                           c.node_c.data(),
                           c.gradient_b1.data(),
                           c.gradient_b2.data(),
                           c.gradient_c2.data(),
                           c.volume.data(),
                           c.young.data(),
                           c.spherical.data(),
                           c.deviator.data(),
                           c.material_frequency.data(),
                           c.geometric_frequency.data(),
                           state.position.data(),
                           state.corner_force.data(),
                           {c.cosine.data(), c.sine.data(), c.warp_scale.data(), c.shear.data(),
                            c.series.data(), c.skew.data(), c.taut.data()}};
  const int first = block * kBlock, last = std::min(first + kBlock, padded(model.element_count));
  const KernelTable& table = kernel_table(model.description.isa);
  ForceTotals totals{};
  const bool relaxed = model.description.compression == Compression::none;
  const auto forces = model.woven ? (relaxed ? table.woven_forces_relaxed : table.woven_forces_linear)
                                  : (relaxed ? table.element_forces_relaxed : table.element_forces_linear);
  forces(arrays, first, last, totals);
  ForceSums& sums = state.block[static_cast<std::size_t>(block)].forces;
  sums.strain_energy = totals.energy;
  sums.element_frequency = totals.frequency;
}

void nodal_force_block(const BagModel& model, BagState& state, int block) {
  const int first = block * kBlock, last = std::min(first + kBlock, model.node_count);
  kernel_table(model.description.isa)
      .nodal_forces(node_arrays(model, state, nullptr, state.membrane_force), first, last);
}

void sum_membrane_forces(const BagModel& model, BagState& state) {
  double energy = 0.0, frequency = 0.0;
  for (int b = 0; b < element_blocks(model); ++b) {
    const ForceSums& block = state.block[static_cast<std::size_t>(b)].forces;
    energy += block.strain_energy;
    frequency = std::max(frequency, block.element_frequency);
  }
  state.forces.strain_energy = energy;
  state.forces.element_frequency = frequency;
}

void pressure_forces(BagState& state, double gauge_pressure) {
  if (!std::isfinite(gauge_pressure)) throw MembraneError("stage forces: the gas pressure is not finite");
  state.gauge_pressure = gauge_pressure;
}

void check_overpressure(const BagModel& model, const BagState& state, std::span<const double> overpressure) {
  if (state.jet_force.empty()) reject("jet_forces", "the state was made without LoadKinds::jet");
  if (overpressure.size() != static_cast<std::size_t>(model.element_count))
    reject("jet_forces", "overpressure values", static_cast<double>(overpressure.size()),
           "one per element, " + std::to_string(model.element_count));
}

void jet_force_block(const BagModel& model, BagState& state, std::span<const double> overpressure,
                     int block) {
  const int first = block * kBlock, last = std::min(first + kBlock, model.node_count);
  kernel_table(model.description.isa)
      .jet_forces(node_arrays(model, state, overpressure.data(), state.jet_force), first, last);
}

}  // namespace membrane
