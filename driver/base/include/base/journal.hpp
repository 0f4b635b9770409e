// SPDX-License-Identifier: Apache-2.0
// The finished parts of long work: what is there is not computed again.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result_folder.hpp"

namespace driver {

/// Lines of JSON with a key and a value, in a folder of results; a line that a kill tore is not there.
/// Without a folder nothing is kept.
class Journal {
 public:
  /// Reads what an unfinished run of the same id has left, and what its shares have.
  explicit Journal(ResultFolder* folder);
  std::size_t size() const { return before_.size(); }
  const nlohmann::json* find(const std::string& key) const;
  /// `value` as JSON on one line. Throws WriteError.
  void add(const std::string& key, const std::string& value);

 private:
  std::string read(const std::filesystem::path& file);

  std::map<std::string, nlohmann::json> before_;
  std::optional<GrowingFile> file_;
};

/// The shares below `folder` and what their status files say, in the order of their names.
std::vector<std::pair<std::filesystem::path, FolderStatus>> shares_in(const std::filesystem::path& folder);
/// Throws CaseError if a share below `folder` is of another run than `run`.
void require_shares_of(const std::filesystem::path& folder, const std::string& run);
/// Removes the shares of a run whose results are whole; one that is still computed stays.
void remove_shares(const ResultFolder& folder);

}  // namespace driver
