// SPDX-License-Identifier: Apache-2.0
#include "results/journal.hpp"

#include <fstream>

namespace driver {

Journal::Journal(ResultFolder* folder) {
  if (!folder) return;
  const auto path = folder->add(journal_file);
  std::ifstream stream(path);
  std::string whole;  // lines
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const nlohmann::json entry = nlohmann::json::parse(line, nullptr, false);
    if (!entry.is_object() || !entry.contains("key") || !entry.contains("value")) continue;
    before_[entry["key"].get<std::string>()] = entry["value"];
    whole += line + '\n';
  }
  replace_file(path, whole);
  file_.emplace(path, true);
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
