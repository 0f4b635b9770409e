// SPDX-License-Identifier: Apache-2.0
#include "membrane/bag_state.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "checks.hpp"
#include "kernel_table.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

void check_position(const BagModel& model, const ConstVectorsRef& position) {
  if (position.cols() != model.node_count)
    reject("position", "columns", static_cast<double>(position.cols()),
           "one per node, " + std::to_string(model.node_count));
  for (Eigen::Index n = 0; n < position.cols(); ++n)
    for (int c = 0; c < 3; ++c)
      require_finite("node " + std::to_string(n), "initial coordinate", position(c, n));
}

int sum_blocks(const BagModel& model) {
  return std::max(element_blocks(model), node_blocks(model));
}

int rate_chunks(const BagModel& model) {
  return (model.node_count + kRateNodes - 1) / kRateNodes;
}

}  // namespace

void check_state(const BagModel& model, const BagState& s) {
  const BagDescription& d = model.description;
  const auto all = [](bool kept, int count, std::initializer_list<const Vectors*> arrays) {
    return std::ranges::all_of(arrays, [&](const Vectors* v) { return v->count() == (kept ? count : 0); });
  };
  const int nodes = model.node_count, elements = model.element_count;
  const bool jet = !s.jet_force.empty(), damped = d.stiffness_damping > 0.0;
  const bool own =
      all(true, nodes, {&s.position, &s.velocity, &s.volume_gradient, &s.membrane_force}) &&
      all(jet, nodes, {&s.jet_force}) && all(jet, elements, {&s.area_vector, &s.centroid}) &&
      all(!s.contact_force.empty(), nodes, {&s.contact_force}) &&
      all(!s.own_force.empty(), nodes, {&s.own_force}) &&
      all(!d.straps.empty() || !d.plates.empty(), nodes, {&s.support_force}) &&
      all(damped, nodes, {&s.viscous.force}) && all(damped, elements, {&s.viscous.elastic_stress}) &&
      std::ssize(s.rate_bound_squared) == rate_chunks(model) &&
      std::ssize(s.strap_tension) == std::ssize(d.straps) && std::ssize(s.share_demand) == elements &&
      s.shares.frequency.size() == model.elements.group.size() &&
      s.shared_sums.size() == model.shared.slot.size() && std::ssize(s.block) == sum_blocks(model);
  if (!own)
    reject("state", "its arrays do not have the sizes of this model; allowed: a state from make_state");
}

BagState make_state(const BagModel& model, ConstVectorsRef position, LoadKinds loads) {
  check_position(model, position);
  const int nodes = model.node_count, elements = model.element_count;
  const BagDescription& d = model.description;
  BagState s;
  s.gravity = d.gravity;
  s.position = Vectors(nodes);
  s.position.map() = position;
  for (Vectors* v : {&s.velocity, &s.volume_gradient, &s.membrane_force}) *v = Vectors(nodes);
  if (loads.jet) {
    s.jet_force = Vectors(nodes);
    s.jet_nodes.reserve(static_cast<std::size_t>(nodes));
    s.has_jet_force.assign(static_cast<std::size_t>(nodes), 0);
    for (Vectors* v : {&s.area_vector, &s.centroid}) *v = Vectors(elements);
  }
  if (loads.contact) s.contact_force = Vectors(nodes);
  if (!d.straps.empty() || !d.plates.empty()) s.support_force = Vectors(nodes);
  if (d.stiffness_damping > 0.0) {
    s.viscous.force = Vectors(nodes);
    s.viscous.elastic_stress = Vectors(elements);
    s.viscous.corner_force = Vectors(2 * elements);
  }
  s.rate_bound_squared.assign(static_cast<std::size_t>(rate_chunks(model)), 0.0);
  s.strap_tension.assign(d.straps.size(), 0.0);
  s.shares = model.shares;
  s.share_demand.assign(static_cast<std::size_t>(elements), 1.0);
  s.shared_sums.resize(model.shared.slot.size());
  s.block.resize(static_cast<std::size_t>(sum_blocks(model)));
  return s;
}

}  // namespace membrane
