// SPDX-License-Identifier: Apache-2.0
// One run of a case in memory, for commands that make many: ensembles and ladders.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/run.hpp"

namespace driver {

/// Names of what a run of the scene says in one number each, with units.
std::vector<std::string> quantity_names(const Scene& scene);

/// Columns of a run's rows: those of the history and, behind them, the filtered ones of a pendulum.
std::vector<std::string> row_names(const Scene& scene);

struct Member {
  std::vector<std::vector<double>> rows;  // of row_names
  RunOutcome outcome;
  std::vector<double> energies;                   // of energy_columns, at the end
  std::vector<std::optional<double>> quantities;  // of quantity_names; none: of an event that did not occur
  long steps = 0;
  double cpu_seconds = 0.0;  // of the thread that ran it, from the scene's state to the last step
};

/// Failures of the computation stand in the outcome, a value that is no finite number too; a start out of the
/// models' domain is a CaseError.
Member run_member(const Scene& scene);

/// Came to an end of its own, in its domain or not; one that never began has not.
bool has_ended(const Member& member);

/// Columns of the history, whose last value counts, then max(COLUMN), min(COLUMN) and integral(COLUMN) over
/// its rows, the last by trapezoids over the time; then columns of the energies, at the end.
std::vector<std::string> history_quantities(const Scene& scene);

/// A quantity of quantity_names or history_quantities; none: of an event that did not occur.
std::optional<double> quantity_of(const Scene& scene, const Member& member, const std::string& name);

/// For a journal, as JSON; finite numbers come back as the same doubles, others as NaN.
std::string line_of(const Member& member);
/// Nothing if there is no entry, or if it is none of a run of this scene that has ended: then it is damaged.
std::optional<Member> member_of(const Scene& scene, const nlohmann::json* entry);

/// The overrides of a run with the initial nodes displaced.
std::vector<std::string> perturbed(std::vector<std::string> overrides, double amplitude, int seed);

}  // namespace driver
