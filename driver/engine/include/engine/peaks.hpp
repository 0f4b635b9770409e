// SPDX-License-Identifier: Apache-2.0
// Extremes and events of a run.
#pragma once

#include <limits>

namespace driver {

/// A term of the energy balance: a column of energy.csv.
struct LargestTerm {
  const char* name = "";
  double magnitude = 0.0;  // [J]
};

/// What was seen of the contact of the skin with itself; S11.
struct SelfContactRecord {
  int limited_at_start = 0;     // nodes that start closer to a layer than the thickness
  double smallest_limit = 0.0;  // [m] smallest distance of such a node; the thickness without one
  int contacts = 0;             // largest number of pairs in contact
  double contacts_time = 0.0;   // [s]
  double gap = std::numeric_limits<double>::infinity();  // [m] smallest of a pair in contact
  double gap_time = 0.0;                                 // [s]
  /// [s] First level from which on the pairs in contact are fewer than 1 % of the nodes; infinite: not yet.
  double one_room_from = 0.0;
};

/// Extremes and events of the run so far; S11.
struct Peaks {
  double pressure = 0.0;         // [Pa]
  double volume = 0.0;           // [m3]
  double pendulum_angle = 0.0;   // [rad] largest magnitude
  double cg_acceleration = 0.0;  // [m/s2]
  double displacement = 0.0;     // [m] of an impactor on a rail or free, largest magnitude
  double acceleration = 0.0;     // [m/s2] of it
  double contact_force = 0.0;    // [N]
  double penetration = 0.0;      // [m] of the contact
  double jet_force = 0.0;        // [N]
  double first_contact = -1.0;   // [s] first level with contact, -1: none
  double mass_residual = 0.0;    // [-] of the mass balance
  double ledger_residual = 0.0;  // [J] kick form, largest magnitude
  /// [J] Physical drift, largest magnitude at the recorded levels.
  double energy_residual = 0.0;
  /// [J] Largest of sensible supply, sensible internal energy, p V, kinetic and elastic energy (K.43).
  double energy_scale = 0.0;
  double mechanical = 0.0;  // [J] largest sum of kinetic and elastic energy and that of the pendulum's weight
  /// Largest of the terms that the step integrates, at the recorded levels.
  LargestTerm largest_term;
  SelfContactRecord self_contact;
  /// [-] Of the momentum balance: inner forces and pressure on the closed skin sum to zero.
  double momentum_residual = 0.0;
};

}  // namespace driver
