// SPDX-License-Identifier: Apache-2.0
// The data of a result for the page.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/report.hpp"

namespace driver {

/// One result in the form that page/main.js reads. Throws as report_page.
std::vector<nlohmann::ordered_json> gather(const std::filesystem::path& result, const ReportOptions& options);

}  // namespace driver
