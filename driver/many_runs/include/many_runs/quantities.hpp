// SPDX-License-Identifier: Apache-2.0
// What a run of a scene says in numbers, by their names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/run.hpp"

namespace driver {

/// Names of what a run of the scene says in one number each, with units.
std::vector<std::string> quantity_names(const Scene& scene);

/// Columns of a run's rows: those of the history and, behind them, the filtered ones of a pendulum.
std::vector<std::string> row_names(const Scene& scene);

/// Columns of the history, whose last value counts, then max(COLUMN), min(COLUMN) and integral(COLUMN) over
/// its rows, the last by trapezoids over the time; then columns of the energies, at the end.
std::vector<std::string> history_quantities(const Scene& scene);

/// Whole name of one of quantity_names() or of a column of the history; the unit may be left off. Throws
/// CaseError with those allowed.
std::string quantity_name(const Scene& scene, const std::string& quantity);

/// Whether the scene has a quantity of that whole name.
bool has_quantity(const Scene& scene, const std::string& name);

/// A run in memory.
struct RecordedRun {
  RunOutcome outcome;
  std::vector<std::vector<double>> rows;          // of row_names()
  std::vector<double> energies;                   // of energy_columns(), at the end
  std::vector<std::optional<double>> quantities;  // of quantity_names(); none: of an event that did not occur
  long steps = 0;
  double cpu_seconds = 0.0;  // of the thread that ran it, from the scene's state to the last step
};

/// Failures of the computation stand in the outcome, a value that is no finite number too; a start out of the
/// models' domain is a CaseError.
RecordedRun record_run(const Scene& scene);

/// A quantity of quantity_names() or history_quantities(); none: of an event that did not occur.
std::optional<double> quantity_of(const Scene& scene, const RecordedRun& run, const std::string& name);

}  // namespace driver
