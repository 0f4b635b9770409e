// SPDX-License-Identifier: Apache-2.0
#include "driver/results.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "build_info.hpp"
#include "driver/case_reader.hpp"
#include "driver/formats.hpp"

namespace driver {

Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides) {
  std::string options;
  for (const auto& text : overrides) {
    if (!options.empty()) options += ' ';
    options += as_option(text);
  }
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {{"format", std::to_string(formats::results)},
          {"case", case_file.string()},
          {"version", build_info::version},
          {"commit", build_info::commit},
          {"compiler", build_info::compiler},
          {"flags", build_info::flags},
          {"options", options.empty() ? "none" : options},
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))}};
}

namespace {

// Fields of an earlier run are not overwritten by a run with fewer frames; the tables are.
void remove_fields(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool frame =
        (name.starts_with("bag_") || name.starts_with("pendulum_")) && entry.path().extension() == ".vtp";
    if (frame || name == "fields.pvd") std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace

void prepare_output(const std::filesystem::path& folder, std::initializer_list<const char*> names) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("--out {}: {}", folder.string(), error.message()));
  const auto probe = folder / ".gasjet_write_probe";
  if (!std::ofstream(probe))
    throw OutputError(fmt::format("--out {}: the folder is not writable", folder.string()));
  std::filesystem::remove(probe, error);
  for (const char* name : names)
    if (const auto file = folder / name;
        std::filesystem::exists(file, error) && !std::ofstream(file, std::ios::app))
      throw OutputError(fmt::format("--out {}: {} is there and not writable", folder.string(), name));
  remove_fields(folder);
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const Provenance& lines, std::vector<Column> columns)
    : file_(file), stream_(file), columns_(std::move(columns)) {
  if (!stream_) throw OutputError(fmt::format("{}: not writable", file.string()));
  for (const auto& [key, value] : lines) stream_ << "# " << key << ": " << value << '\n';
  for (std::size_t i = 0; i < columns_.size(); ++i) stream_ << (i ? "," : "") << columns_[i].name;
  stream_ << '\n';
}

void CsvWriter::write(const Scene& scene, const State& state) {
  fmt::memory_buffer line;
  for (const Column& column : columns_) {
    const double value = column.value(scene, state);
    if (!std::isfinite(value)) throw WriteError(fmt::format("{} is no finite number", column.name));
    if (line.size() > 0) line.push_back(',');
    fmt::format_to(std::back_inserter(line), "{}", value);
  }
  line.push_back('\n');
  stream_.write(line.data(), static_cast<std::streamsize>(line.size()));
  if (!stream_) throw WriteError(fmt::format("{}: write failed (disk full?)", file_.string()));
}

void CsvWriter::flush() {
  stream_.flush();
  if (!stream_) throw WriteError(fmt::format("{}: write failed (disk full?)", file_.string()));
}

}  // namespace driver
