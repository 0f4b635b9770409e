// SPDX-License-Identifier: Apache-2.0
// S3: stiffness-proportional damping (M.28). Scenes without it do not call this.
#include <algorithm>

#include "blocks.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace membrane {

namespace {

// The force at corner b of element e is column 2 e, at c column 2 e + 1; at a it is minus their sum.
Eigen::Vector3d force_at(const BagModel& model, const BagState& state, int element, int node) {
  const auto force = state.viscous.corner_force.map();
  const auto corner = model.description.elements.col(element);
  if (corner[1] == node) return force.col(2 * element);
  if (corner[2] == node) return force.col(2 * element + 1);
  return -(force.col(2 * element) + force.col(2 * element + 1));
}

}  // namespace

void viscous_block(const BagModel& model, BagState& state, double dt_before, int block) {
  const double rate = dt_before > 0.0 ? model.description.stiffness_damping / dt_before : 0.0;
  const auto x = state.position.map();
  auto force = state.viscous.corner_force.map();
  auto before = state.viscous.elastic_stress.map();
  for (int e = block * kNodeBlock; e < std::min((block + 1) * kNodeBlock, model.element_count); ++e) {
    const ElementStiffness& shape = model.stiffness[static_cast<std::size_t>(e)];
    if (shape.volume == 0.0) continue;  // null elements
    const auto r = element_response(model, state, e).response;
    const Eigen::Vector3d now(r.s11, r.s22, r.s12), stress = rate * (now - before.col(e));
    before.col(e) = now;
    const auto corner = model.description.elements.col(e);
    Eigen::Matrix3d corners;
    corners << x.col(corner[0]), x.col(corner[1]), x.col(corner[2]);
    const Eigen::Matrix<double, 3, 2> deformation = corners * shape.gradient.transpose();
    Eigen::Matrix2d s;
    s << stress[0], stress[2], stress[2], stress[1];
    const Eigen::Matrix<double, 3, 2> nominal = -shape.volume * (deformation * s);
    force.col(2 * e) = nominal * shape.gradient.col(1);
    force.col(2 * e + 1) = nominal * shape.gradient.col(2);
  }
}

void viscous_node_block(const BagModel& model, BagState& state, int block) {
  auto sum = state.viscous.force.map();
  for (int n = block * kNodeBlock; n < std::min((block + 1) * kNodeBlock, model.node_count); ++n) {
    sum.col(n).setZero();
    const auto row = static_cast<std::size_t>(n);
    for (std::int32_t k = model.corners.row_begin[row]; k < model.corners.row_begin[row + 1]; ++k)
      sum.col(n) += force_at(model, state, model.corners.element[static_cast<std::size_t>(k)], n);
  }
}

int viscous_blocks(const BagModel& model) {
  return (model.element_count + kNodeBlock - 1) / kNodeBlock;
}

}  // namespace membrane
