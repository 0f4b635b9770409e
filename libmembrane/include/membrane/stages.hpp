// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"

// The stages of one step that belong to the bag. None of them allocates. Each takes `for_each_block`, called
// as for_each_block(count, f) to run f(0) ... f(count - 1) in any order or in parallel; the results have the
// same bits whatever it does.
namespace membrane {

// One block after the other in the calling thread.
struct Serial {
  // Calls f(0) ... f(count - 1).
  template <class F>
  void operator()(int count, F&& f) const {
    for (int block = 0; block < count; ++block) f(block);
  }
};

// What a pass over the elements computes.
enum class SkinParts { surface, forces, both };

// How many blocks there are, of elements (at most kBlockElements each) ...
int element_blocks(const BagModel& model);
// ... of nodes that several of them share (kNodeBlock each) ...
int shared_blocks(const BagModel& model);
// ... and of all nodes (kNodeBlock each).
int node_blocks(const BagModel& model);

// Parts of the stages below that handle one block, and the closing sums. Precondition: `block` is one of the
// kind's. update_skin, a block of elements: their sums, and forces and gradients at their nodes.
void skin_block(const BagModel& model, BagState& state, SkinParts parts, int block);
// update_skin, a block of shared nodes, after all blocks of elements: adds up what those left there.
void shared_block(const BagModel& model, BagState& state, SkinParts parts, int block);
// update_skin: sums over the blocks, in order. Throws MembraneError if volume or area is not finite.
void sum_skin(const BagModel& model, BagState& state, SkinParts parts);
// support_forces, a block of nodes: the plates' part.
void plate_force_block(const BagModel& model, BagState& state, int block);
// support_forces: the straps, and sums over the blocks.
void sum_support_forces(const BagModel& model, BagState& state);
// advance, a block of nodes.
void advance_block(const BagModel& model, BagState& state, double dt_before, double dt_after, int block);
// advance: sums over the blocks. Throws MembraneError naming the node whose velocity is not finite.
void sum_advance(const BagModel& model, BagState& state, double dt_before, double dt_after);
// update_mass_shares, a block of elements: how much more mass each asks for (M.17).
void demand_block(const BagModel& model, BagState& state, int block);
// update_mass_shares, a block of nodes: the shares by what their elements ask for.
void share_block(const BagModel& model, BagState& state, int block);
// update_mass_shares, a block of elements: the bounds of omega^2 that follow.
void frequency_block(const BagModel& model, BagState& state, int block);
// advance: std::invalid_argument unless dt_before >= 0, dt_after > 0, both finite.
void check_steps(double dt_before, double dt_after);

// S1/S9 and the fabric's part of S6 at state.position in one pass over the elements, which is what a step
// wants: both need the same corners. Bits as from the two functions below.
//   surface: volume, its gradient and the areas; with a jet also area vectors and centroids (M.5)
//   forces:  forces of the fabric, their strain energy and the element bound of omega^2 (M.4, M.10)
// Throws MembraneError if the volume is not finite.
template <class ForEachBlock = Serial>
void update_skin(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {},
                 SkinParts parts = SkinParts::both) {
  for_each_block(element_blocks(model), [&](int block) { skin_block(model, state, parts, block); });
  for_each_block(shared_blocks(model), [&](int block) { shared_block(model, state, parts, block); });
  sum_skin(model, state, parts);
}

// The surface alone.
template <class ForEachBlock = Serial>
void update_surface(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  update_skin(model, state, for_each_block, SkinParts::surface);
}

// The fabric's forces alone: open sheets without gas.
template <class ForEachBlock = Serial>
void membrane_forces(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  update_skin(model, state, for_each_block, SkinParts::forces);
}

// S6: gas pressure less ambient pressure [Pa] on the inside of every element, null ones too (M.6). The nodal
// force is gauge_pressure * dV/dx; it must belong to the surface of the same positions.
void pressure_forces(BagState& state, double gauge_pressure);

/// Load of a jet: overpressure [Pa] of every element on its inside, and the elements that it may load, each
/// once; what the others have is not read.
struct JetLoad {
  std::span<const double> overpressure;
  std::span<const int> elements;
};

// S6: jet overpressure, S_e / 3 to each corner. Needs LoadKinds::jet; throws std::invalid_argument without
// it, if there is not one value per element, or for an element that there is not.
void jet_forces(const BagModel& model, BagState& state, std::span<const JetLoad> loads);

// The same for one jet that may load every element.
void jet_forces(const BagModel& model, BagState& state, std::span<const double> overpressure);

// S6: straps and plates with their energies (M.7, M.8). Nothing happens in a bag without them.
template <class ForEachBlock = Serial>
void support_forces(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  if (state.support_force.empty()) return;
  for_each_block(node_blocks(model), [&](int block) { plate_force_block(model, state, block); });
  sum_support_forces(model, state);
}

// Now and then, after update_skin: moves mass to the elements whose bound of omega^2 is near the largest at
// these positions (M.15), one round. Later bounds use the new shares; each is a bound wherever the nodes go.
// At most some thirty times the cost of update_skin, less when few elements are near.
template <class ForEachBlock = Serial>
void update_mass_shares(const BagModel& model, BagState& state, ForEachBlock&& for_each_block = {}) {
  for_each_block(element_blocks(model), [&](int block) { demand_block(model, state, block); });
  for_each_block(node_blocks(model), [&](int block) { share_block(model, state, block); });
  for_each_block(element_blocks(model), [&](int block) { frequency_block(model, state, block); });
}

// S8: central difference with variable step (M.9):
//   v+ = v- + tau (f / m - alpha (v- + v+) / 2 + gravity),  tau = (dt_before + dt_after) / 2,  x += dt_after
//   v+.
// dt_before [s] is the step that led to n (0 at the start: v is then the velocity at n itself), dt_after > 0
// [s] the one that leaves it. Order 2 for smoothly varying steps. Stable for dt <= critical_time_step
// (time_step.hpp). Throws MembraneError naming the node at the first non-finite velocity,
// std::invalid_argument on bad steps.
template <class ForEachBlock = Serial>
const AdvanceSums& advance(const BagModel& model, BagState& state, double dt_before, double dt_after,
                           ForEachBlock&& for_each_block = {}) {
  check_steps(dt_before, dt_after);
  for_each_block(node_blocks(model),
                 [&](int block) { advance_block(model, state, dt_before, dt_after, block); });
  sum_advance(model, state, dt_before, dt_after);
  return state.advance;
}

}  // namespace membrane
