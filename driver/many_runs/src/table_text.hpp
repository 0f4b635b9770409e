// SPDX-License-Identifier: Apache-2.0
// Cells and JSON of the tables that commands of many runs write.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/run_id.hpp"

namespace driver {

/// A cell of a CSV row. Quotes only where a comma, a quote or a line end needs them (RFC 4180), or `always`.
std::string csv_cell(const std::string& text, bool always = false);
/// An empty cell for nothing.
std::string csv_cell(const std::optional<double>& value);

/// Overrides as they stand on a command line.
std::string as_options(const std::vector<std::string>& overrides);

/// The whole text of a JSON file, after "build", which has the lines that open the other files. Bytes that
/// are no UTF-8, which paths and overrides may hold, are replaced.
std::string json_text(nlohmann::ordered_json json, const Provenance& lines,
                      const std::vector<std::string>& without = {"run"});

}  // namespace driver
