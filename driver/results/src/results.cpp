// SPDX-License-Identifier: Apache-2.0
#include "results/results.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/case_reader.hpp"
#include "base/formats.hpp"

namespace driver {

Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides) {
  std::string options;
  for (const auto& text : overrides) {
    if (!options.empty()) options += ' ';
    options += as_option(text);
  }
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  Provenance lines{{"format", std::to_string(formats::results)}, {"case", case_file.string()}};
  for (auto& line : build_lines()) lines.push_back(std::move(line));
  lines.emplace_back("options", options.empty() ? "none" : options);
  lines.emplace_back("date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now)));
  return lines;
}

Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                      const std::string& run) {
  Provenance lines = provenance(case_file, overrides);
  lines.insert(lines.begin() + 1, {"run", run});
  return lines;
}

CsvWriter::CsvWriter(ResultFolder& folder, const std::string& name, std::vector<Column> columns)
    : file_(folder.add(name)),
      columns_(std::move(columns)),
      pending_(comment_lines(folder.lines())),
      flushed_(std::chrono::steady_clock::now()) {
  for (std::size_t i = 0; i < columns_.size(); ++i) pending_ += (i ? "," : "") + columns_[i].name;
  pending_ += '\n';
  flush();
}

void CsvWriter::write(const Scene& scene, const State& state) {
  constexpr std::size_t much = 1u << 16;
  std::string line;
  for (const Column& column : columns_) {
    const double value = column.value(scene, state);
    if (!std::isfinite(value)) throw WriteError(fmt::format("{} is not a finite number", column.name));
    if (!line.empty()) line += ',';
    fmt::format_to(std::back_inserter(line), "{}", value);
  }
  pending_ += line + '\n';
  if (pending_.size() > much) flush();
}

void CsvWriter::keep_up() {
  if (pending_.empty()) return;
  if (std::chrono::steady_clock::now() - flushed_ > std::chrono::seconds(1)) flush();
}

void CsvWriter::flush() {
  flushed_ = std::chrono::steady_clock::now();
  const std::string rows = std::exchange(pending_, {});
  file_.append(rows);
}

}  // namespace driver
