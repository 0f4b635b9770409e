// SPDX-License-Identifier: Apache-2.0
// Histories that are means of many runs.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace driver {

/// A history with standard errors is an ensemble. Reads its number of runs from the line `# runs: N` above
/// the columns, and removes `_mean` from the names, which ensemble.csv has. Throws CaseError for a standard
/// error without its column, and if the line is missing or is not an integer of at least 2.
void read_ensemble_lines(History& history, const std::filesystem::path& file);

}  // namespace driver
