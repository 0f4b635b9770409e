// SPDX-License-Identifier: Apache-2.0
// What a result says to the page.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/report.hpp"

namespace driver {

/// One result, as page/main.js reads it. Throws as report_page.
std::vector<nlohmann::ordered_json> gather(const std::filesystem::path& result, const ReportOptions& options);

}  // namespace driver
