// SPDX-License-Identifier: Apache-2.0
// Histories that are means of many runs.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace driver {

/// If a column has a standard error beside it, the history is an ensemble: takes the number of runs from the
/// line `# runs: N` above the columns, and `_mean` off the names, as ensemble.csv has them. Throws CaseError
/// for a standard error without its column, and if the line is missing or no whole number of 2 or more.
void read_ensemble_lines(History& history, const std::filesystem::path& file);

}  // namespace driver
