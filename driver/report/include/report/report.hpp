// SPDX-License-Identifier: Apache-2.0
// One self-contained page of results: the bag in motion, charts, balances, settings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace driver {

struct ReportOptions {
  std::filesystem::path reference;            // history to judge runs by, or empty
  std::size_t most_rows = 4000;               // rows of a table in the page, besides those of extremes
  std::size_t most_frame_bytes = 20'000'000;  // bytes of the frames of a run
};

/// The page as HTML. Each of `results` is the folder of a run, an ensemble or a ladder, or a CSV file with a
/// column time_s. A longer table is thinned, and the page says so. Throws CaseError for other paths, and for
/// files that are damaged or do not belong together.
std::string report_page(const std::vector<std::filesystem::path>& results, const ReportOptions& options);

}  // namespace driver
