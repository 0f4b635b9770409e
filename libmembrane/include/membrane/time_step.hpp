// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"

namespace membrane {

// Bounds of omega^2 [1/s2] by cause. Stiffnesses act together, so these add (M.12); the smallest of separate
// limits is not safe.
struct StiffnessShares {
  double element = 0.0;  // fabric at its current stretch, geometric stiffness included (M.10)
  double gas = 0.0;      // (gamma p / V) g^T M^-1 g (M.11)
  double contact = 0.0;  // given by the contact model
  double strap = 0.0;    // of all straps, taut or not
  double plate = 0.0;    // of all plates, touched or not
  // Bound of the whole bag's omega^2 (M.12).
  double total() const { return element + gas + contact + strap + plate; }
};

// Shares after S1 and S6 of the same positions. gamma [-] and the absolute pressure p [Pa] are those of the
// gas inside (gamma = 0 for a bag whose pressure is prescribed); contact [1/s2] comes from the caller. Throws
// MembraneError if there is gas and the volume is not positive.
StiffnessShares stiffness_shares(const BagModel& model, const BagState& state, double gamma, double pressure,
                                 double contact = 0.0);

// Largest stable step of central difference, 2 / omega (M.12) [s]. Throws MembraneError if nothing is stiff.
double critical_time_step(const StiffnessShares& shares);

// What forces and straps can do to the energy of a step: its squared length over 8 times these (M.22),
// [J/s2]. Sum of |f|^2 / m over the free nodes after S6 and S7 of the same positions, weight and damping left
// out.
double force_mobility(const BagModel& model, const BagState& state);
// Sum of k v^2 + T^2 (1/m_a + 1/m_b) over the straps, taut or not: v the speed at which the ends part, T the
// tension. A strap that swings alone keeps it.
double strap_mobility(const BagModel& model, const BagState& state);

// What one element does at the current positions, for output and messages (not on the path of a step).
struct ElementResponse {
  PlaneStrain<double> strain;      // in the element's frame, first axis along its reference side a-b
  PlaneResponse<double> response;  // zero for a null element
  double frequency = 0.0;          // bound of omega^2 of this element (M.10) [1/s2]
};
// Response of an element, without pressure and supports. Throws std::invalid_argument for a number out of
// range.
ElementResponse element_response(const BagModel& model, const BagState& state, int element);

// Element with the largest bound: the one that governs the step.
int governing_element(const BagModel& model, const BagState& state);

}  // namespace membrane
