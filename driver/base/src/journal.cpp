// SPDX-License-Identifier: Apache-2.0
#include "base/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/case_reader.hpp"
#include "base/share.hpp"

namespace driver {
std::vector<std::pair<std::filesystem::path, FolderStatus>> shares_in(const std::filesystem::path& folder) {
  std::vector<std::pair<std::filesystem::path, FolderStatus>> list;
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder / shares_folder, ignored)) return list;
  for (const auto& share : std::filesystem::directory_iterator(folder / shares_folder))
    if (share.is_directory())
      if (const auto status = read_status(share.path()); status && !status->run.empty())
        list.emplace_back(share.path(), *status);
  std::ranges::sort(list, {}, [](const auto& share) { return share.first; });
  return list;
}

void require_shares_of(const std::filesystem::path& folder, const std::string& run) {
  for (const auto& [share, status] : shares_in(folder))
    if (status.run != run)
      throw CaseError(
          fmt::format("{}: is of another command, case or build than this: remove it, or another folder is "
                      "allowed",
                      share.string()));
}

void remove_shares(const ResultFolder& folder) {
  std::error_code ignored;  // of folders that hold something else too
  for (const auto& [share, status] : shares_in(folder.path())) {
    if (status.run != folder.run() || status.status == "running") continue;
    for (const char* file : {journal_file, status_file}) std::filesystem::remove(share / file, ignored);
    std::filesystem::remove(share, ignored);
  }
  std::filesystem::remove(folder.path() / shares_folder, ignored);
}

Journal::Journal(ResultFolder* folder) {
  if (!folder) return;
  const auto path = folder->add(journal_file);
  replace_file(path, read(path));
  file_.emplace(path, true);
  for (const auto& [share, status] : shares_in(folder->path())) read(share / journal_file);
}

// Keeps the entries of a file; returns its whole lines.
std::string Journal::read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string whole;
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const nlohmann::json entry = nlohmann::json::parse(line, nullptr, false);
    if (!entry.is_object() || !entry.contains("value")) continue;
    if (const auto key = entry.find("key"); key == entry.end() || !key->is_string()) continue;
    before_[entry["key"].get<std::string>()] = entry["value"];
    whole += line + '\n';
  }
  return whole;
}

const nlohmann::json* Journal::find(const std::string& key) const {
  const auto found = before_.find(key);
  return found == before_.end() ? nullptr : &found->second;
}

void Journal::add(const std::string& key, const std::string& value) {
  if (!file_) return;
  const std::string name = nlohmann::json(key).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  file_->append(fmt::format("{{\"key\":{},\"value\":{}}}\n", name, value));
}

}  // namespace driver
