// SPDX-License-Identifier: Apache-2.0
#include "ensemble_history.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <unordered_set>

#include "base/case_reader.hpp"
#include "base/csv_table.hpp"
#include "base/text_file.hpp"

namespace driver {
namespace {

constexpr std::string_view mean_suffix = "_mean", runs_key = "# runs: ";
constexpr int most_runs = 1000000000;

struct Line {
  std::size_t number = 1;  // 1-based; line of the header if there is no such line
  std::string text;        // text after the key
};

Line runs_line(const std::filesystem::path& file) {
  Line found;
  LineReader lines(file);
  for (std::string line; lines.next(line); ++found.number) {
    const auto comment = comment_of(line);
    if (!comment) break;
    if (!comment->starts_with(runs_key)) continue;
    found.text = comment->substr(runs_key.size());
    break;
  }
  return found;
}

int runs_of(const std::filesystem::path& file, const std::string& column) {
  const Line line = runs_line(file);
  int runs = 0;
  const char* end = line.text.data() + line.text.size();
  const auto [stop, error] = std::from_chars(line.text.data(), end, runs);
  if (error != std::errc() || stop != end || runs < 2 || runs > most_runs)
    throw CaseError(
        fmt::format("{}:{}:1: runs: '{}' is not a number of runs, which {} needs: write a line '{}N' above "
                    "the columns, N from 2 to {}",
                    file.string(), line.number, line.text, column, runs_key, most_runs));
  return runs;
}

}  // namespace

void read_ensemble_lines(History& history, const std::filesystem::path& file) {
  std::unordered_set<std::string> names;
  const std::string* error = nullptr;
  for (const auto& [name, values] : history.columns) {
    names.insert(name);
    if (name.ends_with(standard_error_suffix)) error = &name;
  }
  if (!error) return;
  for (const auto& [name, values] : history.columns) {
    if (!name.ends_with(standard_error_suffix)) continue;
    const std::string quantity = name.substr(0, name.size() - std::string_view(standard_error_suffix).size());
    if (names.contains(quantity) || names.contains(fmt::format("{}{}", quantity, mean_suffix))) continue;
    throw CaseError(fmt::format("{}:1:1: {}: has no column {} beside it, nor {}{}", file.string(), name,
                                quantity, quantity, mean_suffix));
  }
  history.runs = runs_of(file, *error);
  for (auto& [name, values] : history.columns) {
    if (!name.ends_with(mean_suffix)) continue;
    const std::string quantity = name.substr(0, name.size() - mean_suffix.size());
    if (names.contains(quantity + standard_error_suffix) && !names.contains(quantity)) name = quantity;
  }
}

}  // namespace driver
