// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"
#include "membrane/error.hpp"

namespace membrane {

/// Bounds of omega^2 [1/s2] by cause, and the damping that shortens the step. The stiffnesses act together,
/// so their bounds add (M.12). The smallest of separate step limits would not be safe.
struct StiffnessShares {
  double element = 0.0;  // fabric at its current stretch, geometric stiffness included (M.10)
  double gas = 0.0;      // (gamma p / V) g^T M^-1 g (M.11)
  double contact = 0.0;  // bound of the contact model
  double strap = 0.0;    // of all straps, taut or not
  double plate = 0.0;    // of all plates, touched or not
  /// Rate c of the stiffness damping, beta omega^2 of the fabric (M.29) [1/s]; not a part of omega^2.
  double damping = 0.0;
  /// Bound of omega^2 of the whole bag [1/s2] (M.12).
  double total() const { return element + gas + contact + strap + plate; }
};

/// Bounds after S1 and S3 at the same positions. gamma [-] and the absolute pressure p [Pa] belong to the gas
/// inside; gamma = 0 if the pressure is prescribed. `contact` [1/s2] comes from the caller. Throws
/// std::invalid_argument for a negative argument or one that is not finite, and MembraneError if there is gas
/// and the volume is not positive.
StiffnessShares stiffness_shares(const BagModel& model, const BagState& state, double gamma, double pressure,
                                 double contact = 0.0);

/// Largest stable step of central difference [s]: omega^2 dt^2 + 2 c dt = 4 (M.29), which is 2 / omega (M.12)
/// without damping. c is the rate of damping by the velocity half a step before: shares.damping, plus
/// `jet_damping` [1/s] of jets relative to the skin (J.9). mass_damping does not shorten the step. Throws
/// std::invalid_argument for a negative rate or one that is not finite, and MembraneError if the sum of the
/// bounds is not finite and positive.
double critical_time_step(const StiffnessShares& shares, double jet_damping = 0.0);

/// Sum of |f|^2 / m over the free nodes [J/s2], after S3 and S4 at the same positions, without weight and
/// damping. dt^2 / 8 times this sum is the energy error of a start from rest with step dt (M.22).
double force_mobility(const BagModel& model, const BagState& state);
/// Sum of k v^2 + T^2 (1/m_a + 1/m_b) over the straps [J/s2], taut or not; v is the speed at which the ends
/// separate, T the tension. A strap that swings alone conserves this sum. dt^2 / 8 times it bounds, to
/// leading order, the energy that a strap gains in a bounce (M.22).
double strap_mobility(const BagModel& model, const BagState& state);

/// Step [s] at which a bounce off straps or plates gains at most 60 % of its energy (M.24); infinity without
/// them.
double bounce_time_step(const BagModel& model);

/// Step [s] that keeps the drift of the energy small (M.22), bounce_time_step included. `energy` [J] >= 0 is
/// the largest energy so far that the bag and its gas had or were supplied with. `mobility` [J/s2] is
/// force_mobility, possibly of the step before. `at_rest`: the bag starts from rest, and all of it moves
/// together. The caller should let the limit grow by at most 1 % a step, because a strap that has just opened
/// closes again. Throws std::invalid_argument for an energy or mobility that is negative or NaN.
double energy_time_step(const BagModel& model, const BagState& state, double energy, double mobility,
                        bool at_rest);

/// Largest change of the deformation gradient in one step [-] (M.32).
inline constexpr double kLargestDeformation = 0.4;
/// Rate at which the fabric deforms.
struct DeformationRate {
  double rate = 0.0;  // largest |dF/dt| of an element, Frobenius norm [1/s]
  int element = -1;   // that element; -1 if no element is above the floor
};
/// Largest rate of the fabric's elements after `advance` (M.32), or `floor` [1/s] if all are below it. It is
/// exact and cheap: elements are evaluated only if the speeds of their corners allow more than the floor.
DeformationRate deformation_rate(const BagModel& model, const BagState& state, double floor = 0.0);

/// Response of one element at the current positions, for output and messages; a step does not use it.
struct ElementResponse {
  PlaneStrain<double> strain;      // in the element's frame, first axis along its reference side a-b
  PlaneResponse<double> response;  // 0 for a null element
  double frequency = 0.0;          // bound of omega^2 (M.10) [1/s2]
};
/// Response of an element, without pressure and supports. Throws std::invalid_argument for an element number
/// out of range.
ElementResponse element_response(const BagModel& model, const BagState& state, int element);

/// Largest principal Green-Lagrange strain [-] of each element. `strains` has one entry per element. Throws
/// std::invalid_argument for another size.
void largest_strains(const BagModel& model, const BagState& state, std::span<double> strains);

/// Element with the largest bound of omega^2, which governs the step.
int governing_element(const BagModel& model, const BagState& state);

}  // namespace membrane
