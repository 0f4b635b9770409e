// SPDX-License-Identifier: Apache-2.0
// S6: pressure and jet.
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

void check_overpressure(const BagModel& model, const BagState& state, std::span<const double> overpressure) {
  if (state.jet_force.empty()) reject("jet_forces", "the state was made without LoadKinds::jet");
  if (overpressure.size() != static_cast<std::size_t>(model.element_count))
    reject("jet_forces", "overpressure values", static_cast<double>(overpressure.size()),
           "one per element, " + std::to_string(model.element_count));
}

}  // namespace

void pressure_forces(BagState& state, double gauge_pressure) {
  if (!std::isfinite(gauge_pressure)) throw MembraneError("stage forces: the gas pressure is not finite");
  state.gauge_pressure = gauge_pressure;
}

// A jet loads a small part of the skin: the loaded elements spread their force, instead of every node asking
// all its elements.
void jet_forces(const BagModel& model, BagState& state, std::span<const double> overpressure) {
  check_overpressure(model, state, overpressure);
  using Row = Eigen::Map<Eigen::Vector4d, Eigen::Aligned32>;
  using ConstRow = Eigen::Map<const Eigen::Vector4d, Eigen::Aligned32>;
  double* const force = state.jet_force.data();
  std::fill_n(force, 4 * model.node_count, 0.0);
  bool loaded = false;
  for (int e = 0; e < model.element_count; ++e) {
    const double dp = overpressure[static_cast<std::size_t>(e)];
    if (dp == 0.0) continue;
    loaded = true;
    const Eigen::Vector4d load = dp * ConstRow(state.area_vector.data() + 4 * std::ptrdiff_t{e});
    for (const int node : model.description.elements.col(e)) Row(force + 4 * std::ptrdiff_t{node}) += load;
  }
  if (loaded)
    Eigen::Map<Eigen::VectorXd, Eigen::Aligned32>(force, 4 * std::ptrdiff_t{model.node_count}) *= 1.0 / 3.0;
}

}  // namespace membrane
