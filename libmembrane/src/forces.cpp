// SPDX-License-Identifier: Apache-2.0
// S6: pressure and jet.
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "kernel_table.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

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
  const int first = block * kNodeBlock, last = std::min(first + kNodeBlock, model.node_count);
  const JetArrays arrays{model.corners.row_begin.data(), model.corners.element.data(),
                         state.area_vector.data(), overpressure.data(), state.jet_force.data()};
  kernel_table(model.description.isa).jet_forces(arrays, first, last);
}

}  // namespace membrane
