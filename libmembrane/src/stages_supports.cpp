// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "membrane/stages.hpp"

namespace membrane {

namespace {

// The only coordinate in which a plate's normal is not 0; -1 if there are more.
int only_axis(const Eigen::Vector3d& normal) {
  for (int c = 0; c < 3; ++c)
    if (normal[(c + 1) % 3] == 0.0 && normal[(c + 2) % 3] == 0.0) return c;
  return -1;
}

// Adds one plate's force to the nodes [first, last), and its energy and resultant to the sums (M.8).
// `depth_of` takes a node's position.
template <class DepthOf>
void add_plate(const BagModel& model, BagState& state, const Plate& plate, int first, int last,
               ForceSums& sums, const DepthOf& depth_of) {
  const double* x = state.position.data();
  double* force = state.support_force.data();
  double total = 0.0;
  for (int n = first; n < last; ++n) {
    const double depth = depth_of(x + 4 * n);
    if (depth <= 0.0) continue;
    const double push = *plate.stiffness * model.node_area[static_cast<std::size_t>(n)] * depth;
    Eigen::Map<Eigen::Vector3d>(force + 4 * n) += push * plate.normal;
    sums.plate_energy += 0.5 * push * depth;
    total += push;
  }
  sums.plate_force += total * plate.normal;
}

// The same bits either way, but along an axis for a third of the cost.
void add_plate(const BagModel& model, BagState& state, const Plate& plate, int first, int last,
               ForceSums& sums) {
  if (const int c = only_axis(plate.normal); c >= 0)
    return add_plate(model, state, plate, first, last, sums,
                     [c, normal = plate.normal[c], level = plate.point[c]](const double* x) {
                       return normal * (level - x[c]);
                     });
  add_plate(model, state, plate, first, last, sums, [&](const double* x) {
    return plate.normal.dot(plate.point - Eigen::Map<const Eigen::Vector3d>(x));
  });
}

// Adds one strap's forces, sets its tension and returns its energy (M.7).
double add_strap(const Strap& strap, BagState& state, double& tension) {
  auto force = state.support_force.map();
  const Eigen::Vector3d span =
      state.position.map().col(strap.node_b) - state.position.map().col(strap.node_a);
  const double length = span.norm();
  const double extension = length - strap.free_length;
  tension = 0.0;
  if (extension <= 0.0) return 0.0;
  tension = strap.stiffness * extension;
  const Eigen::Vector3d pull = tension / length * span;
  force.col(strap.node_a) += pull;
  force.col(strap.node_b) -= pull;
  return 0.5 * tension * extension;
}

}  // namespace

void plate_force_block(const BagModel& model, BagState& state, int block) {
  const int first = block * kNodeBlock, last = std::min(first + kNodeBlock, model.node_count);
  std::fill(state.support_force.data() + 4 * first, state.support_force.data() + 4 * last, 0.0);
  ForceSums& sums = state.block[static_cast<std::size_t>(block)].forces;
  sums.plate_energy = 0.0;
  sums.plate_force.setZero();
  for (const Plate& plate : model.description.plates) add_plate(model, state, plate, first, last, sums);
}

void sum_support_forces(const BagModel& model, BagState& state) {
  double plate_energy = 0.0, strap_energy = 0.0;
  state.forces.plate_force.setZero();
  for (int b = 0; b < node_blocks(model); ++b) {
    plate_energy += state.block[static_cast<std::size_t>(b)].forces.plate_energy;
    state.forces.plate_force += state.block[static_cast<std::size_t>(b)].forces.plate_force;
  }
  for (std::size_t i = 0; i < state.strap_tension.size(); ++i)
    strap_energy += add_strap(model.description.straps[i], state, state.strap_tension[i]);
  state.forces.plate_energy = plate_energy;
  state.forces.strap_energy = strap_energy;
}

}  // namespace membrane
