// SPDX-License-Identifier: Apache-2.0
// One run of a case in memory, for commands that make many: ensembles and ladders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/run.hpp"

namespace driver {

/// Names of what a run of the scene says in one number each, with units.
std::vector<std::string> quantity_names(const Scene& scene);

struct Member {
  std::vector<std::vector<double>> rows;  // of history_columns
  RunOutcome outcome;
  std::vector<std::optional<double>> quantities;  // of quantity_names; none: of an event that did not occur
  double cpu_seconds = 0.0;  // of the thread that ran it, from the scene's state to the last step
};

/// Failures of the computation stand in the outcome; a start out of the models' domain is a CaseError.
Member run_member(const Scene& scene);

/// The overrides of a run with the initial nodes displaced.
std::vector<std::string> perturbed(std::vector<std::string> overrides, double amplitude, int seed);

}  // namespace driver
