// SPDX-License-Identifier: Apache-2.0
// S3: pressure and jet.
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

using Row = Eigen::Map<Eigen::Vector4d, Eigen::Aligned32>;

void check_overpressure(const BagModel& model, std::span<const double> overpressure) {
  if (overpressure.size() != static_cast<std::size_t>(model.element_count))
    reject("jet_forces", "overpressure values", static_cast<double>(overpressure.size()),
           "one per element, " + std::to_string(model.element_count));
}

Row jet_force(BagState& state, int node) {
  return Row(state.jet_force.data() + 4 * std::ptrdiff_t{node});
}

// Adds three times the force.
void spread(const BagModel& model, BagState& state, int element, double overpressure) {
  if (overpressure == 0.0) return;
  using ConstRow = Eigen::Map<const Eigen::Vector4d, Eigen::Aligned32>;
  const Eigen::Vector4d load =
      overpressure * ConstRow(state.area_vector.data() + 4 * std::ptrdiff_t{element});
  for (const int node : model.description.elements.col(element)) {
    jet_force(state, node) += load;
    if (char& has = state.has_jet_force[static_cast<std::size_t>(node)]; has == 0) {
      has = 1;
      state.jet_nodes.push_back(node);
    }
  }
}

// Clears only the loaded nodes, which are few.
void clear(BagState& state) {
  if (state.jet_force.empty()) reject("jet_forces", "the state was made without LoadKinds::jet");
  for (const int node : state.jet_nodes) {
    jet_force(state, node).setZero();
    state.has_jet_force[static_cast<std::size_t>(node)] = 0;
  }
  state.jet_nodes.clear();
}

void take_third(BagState& state) {
  for (const int node : state.jet_nodes) jet_force(state, node) *= 1.0 / 3.0;
}

}  // namespace

void pressure_forces(BagState& state, double gauge_pressure) {
  if (!std::isfinite(gauge_pressure)) throw MembraneError("stage forces: the gas pressure is not finite");
  state.gauge_pressure = gauge_pressure;
}

// A jet loads a small part of the skin, so the loaded elements scatter their force to the nodes.
void jet_forces(const BagModel& model, BagState& state, std::span<const JetLoad> loads) {
  check_state(model, state);
  clear(state);
  for (const JetLoad& load : loads) {
    check_overpressure(model, load.overpressure);
    require_elements("jet_forces", model, load.elements);
    for (const int e : load.elements) spread(model, state, e, load.overpressure[static_cast<std::size_t>(e)]);
  }
  take_third(state);
}

void jet_forces(const BagModel& model, BagState& state, std::span<const double> overpressure) {
  check_state(model, state);
  clear(state);
  check_overpressure(model, overpressure);
  for (int e = 0; e < model.element_count; ++e)
    spread(model, state, e, overpressure[static_cast<std::size_t>(e)]);
  take_third(state);
}

}  // namespace membrane
