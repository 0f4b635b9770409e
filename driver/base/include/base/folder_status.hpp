// SPDX-License-Identifier: Apache-2.0
// gasjet.status: what a folder of results says of itself.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace driver {

/// What `gasjet.status` says: the run that wrote the folder, how it ended, and the files that it wrote.
struct FolderStatus {
  std::string command;  // of gasjet
  std::string run;
  std::string status;  // "running" until the command ends, then how it ended
  std::set<std::string, std::less<>> files;
};
inline constexpr const char* status_file = "gasjet.status";
inline constexpr const char* status_head =
    "# Written by gasjet: the run that wrote this folder, how it ended, its files.";
/// The finished parts of work that is not finished: the same command goes on from there.
inline constexpr const char* journal_file = "journal.jsonl";

/// Nothing if there is no status file. Throws OutputError for a file of that name which is none.
std::optional<FolderStatus> read_status(const std::filesystem::path& folder);

/// Throws CaseError when the folder of `file` says that its run has not ended, that its runs were interrupted
/// before all were done, or that the file is of another run, and when the table's last row is cut. Files that
/// it does not list are the user's own.
void require_whole(const std::filesystem::path& file);
/// The same for a file that is no table, and which says itself of which run it is.
void require_whole(const std::filesystem::path& file, const std::string& run);

}  // namespace driver
