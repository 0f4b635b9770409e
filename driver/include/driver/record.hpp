// SPDX-License-Identifier: Apache-2.0
// What one row of the history and energy files says: the state at one time level t^n.
#pragma once

#include <string>
#include <vector>

namespace driver {

/// State at t^n. Names are the history file's columns with their units.
struct Record {
  double time_s = 0.0;
  double pressure_Pa = 0.0;
  double temperature_K = 0.0;
  double volume_m3 = 0.0;
  double gas_mass_kg = 0.0;
  double inflow_kg_s = 0.0;
  double vent_outflow_kg_s = 0.0;
  double fabric_outflow_kg_s = 0.0;
  double backflow_kg_s = 0.0;  // of ambient gas, in through vents
  double heat_loss_W = 0.0;
  double jet_force_N = 0.0;  // magnitude of the resultant of all jets on the skin
  double jet_lit_elements = 0.0;
  double jet_hidden_elements = 0.0;
  double contact_force_N = 0.0;  // magnitude of the skin's force on the impactor
  double contact_penetration_m = 0.0;
  double pendulum_angle_rad = 0.0;
  double pendulum_angular_velocity_rad_s = 0.0;
  double pendulum_cg_tangential_m_s2 = 0.0;    // along growing angle
  double pendulum_cg_radial_m_s2 = 0.0;        // towards the pivot
  double pendulum_cg_acceleration_m_s2 = 0.0;  // resultant
  double pendulum_joint_force_N = 0.0;         // magnitude
  double strap_force_N = 0.0;                  // largest
  double plate_force_N = 0.0;                  // magnitude of the plates' resultant on the skin
  double skin_area_m2 = 0.0;
};

/// Terms of the energy balance (K.21) at t^n [J]; flows are sums from the start.
struct EnergyRecord {
  double time_s = 0.0;
  double gas_internal_J = 0.0;
  double skin_kinetic_J = 0.0;
  double skin_strain_J = 0.0;
  double skin_gravity_J = 0.0;
  double strap_J = 0.0;
  double plate_J = 0.0;
  double contact_J = 0.0;
  double pendulum_kinetic_J = 0.0;
  double pendulum_gravity_J = 0.0;
  double ambient_work_J = 0.0;  // p_a (V - V0)
  double outflow_enthalpy_J = 0.0;
  double damping_J = 0.0;
  double friction_J = 0.0;
  double backflow_enthalpy_J = 0.0;
  double heat_loss_J = 0.0;
  double tank_work_J = 0.0;  // done by the gas of a tank that moves
  double inflow_enthalpy_J = 0.0;
  double jet_work_J = 0.0;  // done by an external jet, 0 when it is taken from the gas
  double residual_J = 0.0;  // physical drift: everything that holds energy minus everything that supplied it
  double kick_residual_J =
      0.0;  // discrete ledger (K.20): change of kinetic energy minus the work of every force
};

template <typename Row>
struct Column {
  std::string name;
  double Row::*value;
};

}  // namespace driver
