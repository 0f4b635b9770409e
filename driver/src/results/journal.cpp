// SPDX-License-Identifier: Apache-2.0
#include "results/journal.hpp"

#include <fmt/format.h>

#include <fstream>

#include "driver/case_reader.hpp"
#include "driver/share.hpp"

namespace driver {

Journal::Journal(ResultFolder* folder) {
  if (!folder) return;
  const auto path = folder->add(journal_file);
  replace_file(path, read(path));
  file_.emplace(path, true);
  read_shares(*folder);
}

// Keeps the entries of a file; returns its whole lines.
std::string Journal::read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string whole;
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const nlohmann::json entry = nlohmann::json::parse(line, nullptr, false);
    if (!entry.is_object() || !entry.contains("key") || !entry.contains("value")) continue;
    before_[entry["key"].get<std::string>()] = entry["value"];
    whole += line + '\n';
  }
  return whole;
}

void Journal::read_shares(const ResultFolder& folder) {
  const auto shares = folder.path() / shares_folder;
  if (!std::filesystem::is_directory(shares)) return;
  for (const auto& share : std::filesystem::directory_iterator(shares)) {
    if (!share.is_directory()) continue;
    const auto status = read_status(share.path());
    if (!status || status->run.empty()) continue;
    if (status->run != folder.run())
      throw CaseError(
          fmt::format("{}: is of another command, case or build than this: remove it, or another folder is "
                      "allowed",
                      share.path().string()));
    read(share.path() / journal_file);
  }
}

const nlohmann::json* Journal::find(const std::string& key) const {
  const auto found = before_.find(key);
  return found == before_.end() ? nullptr : &found->second;
}

void Journal::add(const std::string& key, const nlohmann::json& value) {
  if (!file_) return;
  const std::string line = nlohmann::json{{"key", key}, {"value", value}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::lock_guard<std::mutex> guard(lock_);
  file_->append(line + '\n');
}

}  // namespace driver
