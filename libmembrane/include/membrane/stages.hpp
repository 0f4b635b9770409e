// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"
#include "membrane/error.hpp"

/// The bag's stages of one step. None of them allocates. Each takes `for_each_block`: for_each_block(count,
/// f) must run f(0) ... f(count - 1), in any order or in parallel. The results have the same bits in every
/// case. The functions with `block` are parts of stages. Precondition: `block` is a number of that kind of
/// block, and the state belongs to the model. Whole stages check the state: see check_state.
namespace membrane {

/// Runs one block after the other in the calling thread.
struct Serial {
  /// Calls f(0) ... f(count - 1).
  template <class F>
  void operator()(int count, F&& f) const {
    for (int block = 0; block < count; ++block) f(block);
  }
};

/// Quantities that a pass over the elements computes.
enum class SkinParts { surface, forces, both };

/// Number of blocks of elements, at most kBlockElements each.
int element_blocks(const BagModel& model);
/// Number of blocks of nodes that several element blocks share, kNodeBlock each.
int shared_blocks(const BagModel& model);
/// Number of blocks of all nodes, kNodeBlock each.
int node_blocks(const BagModel& model);

/// Part of update_skin for one block of elements: its sums, and forces and gradients at its nodes.
void skin_block(const BagModel& model, BagState& state, SkinParts parts, int block);
/// Part of update_skin for one block of shared nodes, after all blocks of elements: adds up their partial
/// sums.
void shared_block(const BagModel& model, BagState& state, SkinParts parts, int block);
/// Part of update_skin: sums over the blocks, in order. Throws MembraneError if volume or area is not finite.
void sum_skin(const BagModel& model, BagState& state, SkinParts parts);
/// Part of support_forces for one block of nodes: the plates.
void plate_force_block(const BagModel& model, BagState& state, int block);
/// Part of support_forces: the straps, and the sums over the blocks.
void sum_support_forces(const BagModel& model, BagState& state);
/// Number of blocks of elements of viscous_forces.
int viscous_blocks(const BagModel& model);
/// Part of viscous_forces for one of these blocks: stresses, and forces at the corners.
void viscous_block(const BagModel& model, BagState& state, double dt_before, int block);
/// Part of viscous_forces for one block of nodes, after all of those.
void viscous_node_block(const BagModel& model, BagState& state, int block);
/// Part of advance for one block of nodes.
void advance_block(const BagModel& model, BagState& state, double dt_before, double dt_after, int block);
/// Part of advance: sums over the blocks. Throws MembraneError, naming the node whose velocity is not finite.
void sum_advance(const BagModel& model, BagState& state, double dt_before, double dt_after);
/// Part of update_mass_shares for one block of elements: the factor by which each demands more mass (M.17).
void demand_block(const BagModel& model, BagState& state, int block);
/// Part of update_mass_shares for one block of nodes: new shares by the elements' demands.
void share_block(const BagModel& model, BagState& state, int block);
/// Part of update_mass_shares for one block of elements: new bounds of omega^2.
void frequency_block(const BagModel& model, BagState& state, int block);
/// Part of advance: throws std::invalid_argument unless dt_before >= 0 and dt_after > 0, both finite [s].
void check_steps(double dt_before, double dt_after);

/// S1/S9 and the fabric's part of S3 at state.position, in one pass over the elements because both need the
/// same corners. It gives the same bits as the two functions below.
///   surface: volume, its gradient and the areas (M.5)
///   forces:  forces of the fabric, their strain energy and the element bound of omega^2 (M.4, M.10)
/// Throws MembraneError if volume or area is not finite.
template <class ForEachBlock = Serial>
void update_skin(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {},
                 SkinParts parts = SkinParts::both) {
  check_state(model, state);
  for_each_block(element_blocks(model), [&](int block) { skin_block(model, state, parts, block); });
  for_each_block(shared_blocks(model), [&](int block) { shared_block(model, state, parts, block); });
  sum_skin(model, state, parts);
}

/// Surface only.
template <class ForEachBlock = Serial>
void update_surface(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  update_skin(model, state, for_each_block, SkinParts::surface);
}

/// Forces of the fabric only, as for open sheets without gas.
template <class ForEachBlock = Serial>
void membrane_forces(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  update_skin(model, state, for_each_block, SkinParts::forces);
}

/// S6: area vectors and centroids (M.5) of `elements` at state.position. Throws std::invalid_argument without
/// LoadKinds::jet, and for an element number out of range.
void update_geometry(const BagModel& model, BagState& state, std::span<const int> elements);
/// The same for all elements.
void update_geometry(const BagModel& model, BagState& state);

/// S3: overpressure `gauge_pressure` = p - p_a [Pa] on the inside of every element, null ones included (M.6).
/// Advance takes gauge_pressure * dV/dx as the nodal force. Precondition: the gradient belongs to the current
/// positions.
/// Throws MembraneError if the pressure is not finite.
void pressure_forces(BagState& state, double gauge_pressure);

/// Load of one jet.
struct JetLoad {
  std::span<const double> overpressure;  // [Pa] M, on the inside of each element; used for `elements` only
  std::span<const int> elements;         // elements that the jet may load, each once
};

/// S3: forces of the jets, overpressure times S_e / 3 at each corner. Precondition: update_geometry has
/// computed the area vectors of the loaded elements at the current positions. Throws std::invalid_argument
/// without LoadKinds::jet, unless there is one value per element, and for an element number out of range.
void jet_forces(const BagModel& model, BagState& state, std::span<const JetLoad> loads);

/// The same for one jet that may load every element.
void jet_forces(const BagModel& model, BagState& state, std::span<const double> overpressure);

/// S3: forces and energies of straps and plates (M.7, M.8). Does nothing for a bag without them.
template <class ForEachBlock = Serial>
void support_forces(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  check_state(model, state);
  if (state.support_force.empty()) return;
  for_each_block(node_blocks(model), [&](int block) { plate_force_block(model, state, block); });
  sum_support_forces(model, state);
}

/// S3: forces of the stress beta dS/dt (M.28), from the change of S since the last call, dt_before [s] ago (0
/// at the start). Rigid motion does not change S. The rate is half a step old, so the damping is of first
/// order in the step and shortens the stable one, see critical_time_step. Does nothing without
/// stiffness_damping. It costs some ten times update_skin.
template <class ForEachBlock = Serial>
void viscous_forces(const BagModel& model, BagState& state, double dt_before,
                    ForEachBlock&& for_each_block = {}) {
  check_state(model, state);
  if (state.viscous.force.empty()) return;
  for_each_block(viscous_blocks(model), [&](int block) { viscous_block(model, state, dt_before, block); });
  for_each_block(node_blocks(model), [&](int block) { viscous_node_block(model, state, block); });
}

/// Moves mass to the elements whose bound of omega^2 is near the largest one at these positions (M.15). Call
/// it now and then, after update_skin. Later bounds use the new shares and are safe for any motion of the
/// nodes. It costs at most about thirty times update_skin, less if few elements are near the largest bound.
template <class ForEachBlock = Serial>
void update_mass_shares(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  check_state(model, state);
  for_each_block(element_blocks(model), [&](int block) { demand_block(model, state, block); });
  for_each_block(node_blocks(model), [&](int block) { share_block(model, state, block); });
  for_each_block(element_blocks(model), [&](int block) { frequency_block(model, state, block); });
}

/// S8: central difference with variable step (M.9):
///   v+ = v- + tau (f / m - alpha (v- + v+) / 2 + gravity),  tau = (dt_before + dt_after) / 2,
///   x += dt_after v+.
/// dt_before [s] >= 0 is the step that led to n; 0 at the start, where v is the velocity at n itself.
/// dt_after [s] > 0 is the step that leaves n. The order is 2 for smoothly varying steps. Stable for
/// dt <= critical_time_step (time_step.hpp), damping included. Throws std::invalid_argument for bad steps,
/// and MembraneError, naming the node, for a velocity that is not finite.
template <class ForEachBlock = Serial>
const AdvanceSums& advance(const BagModel& model, BagState& state, double dt_before, double dt_after,
                           ForEachBlock&& for_each_block = {}) {
  check_state(model, state);
  check_steps(dt_before, dt_after);
  for_each_block(node_blocks(model),
                 [&](int block) { advance_block(model, state, dt_before, dt_after, block); });
  sum_advance(model, state, dt_before, dt_after);
  return state.advance;
}

/// Kinetic energy at n [J] (K.40), from its values at n-1/2 and n+1/2 and the sum of m v- . v+ / 2: the
/// linear interpolation minus dt_before dt_after m |a|^2 / 8. For even steps it is that sum, which a linear
/// system conserves together with the strain energy; for uneven steps it is of second order. At the start,
/// with dt_before = 0, it is kinetic_before. Throws std::invalid_argument as advance does.
double level_kinetic(double kinetic_before, double kinetic_after, double kinetic_product, double dt_before,
                     double dt_after);
/// The same for the step of `sums`.
double level_kinetic(const AdvanceSums& sums, double dt_before, double dt_after);

}  // namespace membrane
