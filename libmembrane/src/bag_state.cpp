// SPDX-License-Identifier: Apache-2.0
#include "membrane/bag_state.hpp"

#include <algorithm>
#include <string>

#include "checks.hpp"
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

}  // namespace

BagState make_state(const BagModel& model, ConstVectorsRef position, LoadKinds loads) {
  check_position(model, position);
  const int nodes = model.node_count, elements = model.element_count;
  const BagDescription& d = model.description;
  BagState s;
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
    s.viscous_force = Vectors(nodes);
    s.elastic_stress = Vectors(elements);
    s.viscous_corner_force = Vectors(2 * elements);
  }
  s.strap_tension.assign(d.straps.size(), 0.0);
  s.shares = model.shares;
  s.share_demand.assign(static_cast<std::size_t>(elements), 1.0);
  s.shared_sums.resize(model.shared.slot.size());
  s.block.resize(static_cast<std::size_t>(std::max(element_blocks(model), node_blocks(model))));
  return s;
}

}  // namespace membrane
