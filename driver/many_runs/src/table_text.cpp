// SPDX-License-Identifier: Apache-2.0
#include "table_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/case_reader.hpp"

namespace driver {

std::string csv_cell(const std::string& text, bool always) {
  if (!always && text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + '"';
}

std::string csv_cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string as_options(const std::vector<std::string>& overrides) {
  std::string text;
  for (const auto& one : overrides) text += (text.empty() ? "" : " ") + as_option(one);
  return text;
}

std::string json_text(nlohmann::ordered_json json, const Provenance& lines,
                      const std::vector<std::string>& without) {
  for (const auto& [key, value] : lines)
    if (std::ranges::find(without, key) == without.end()) json["build"][key] = value;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace driver
