// SPDX-License-Identifier: Apache-2.0
// One run of a case in memory, for commands that make many: ensembles and ladders.
#pragma once

#include "driver/run.hpp"

namespace driver {

/// What a run says in one number each; columns like those of the history.
struct RunQuantities {
  double peak_pressure_Pa = 0.0;
  double peak_volume_m3 = 0.0;
  double final_angle_rad = 0.0;
  double peak_cg_acceleration_m_s2 = 0.0;
  double peak_cg_acceleration_cfc180_m_s2 = 0.0;
  double contact_impulse_Ns = 0.0;
  double path_impulse_Ns = 0.0;
  double first_contact_s = -1.0;  // negative: none
};

/// Those that the scene has.
std::vector<Column<RunQuantities>> quantity_columns(const Scene& scene);

struct Member {
  std::vector<Record> rows;
  RunOutcome outcome;
  RunQuantities quantities;
  double cpu_seconds = 0.0;  // of the thread that ran it, from the scene's state to the last step
};

/// Failures of the computation stand in the outcome; a start out of the models' domain is a CaseError.
Member run_member(const Scene& scene);

/// The overrides of a run with the initial nodes displaced.
std::vector<std::string> perturbed(std::vector<std::string> overrides, double amplitude, int seed);

}  // namespace driver
