// SPDX-License-Identifier: Apache-2.0
// What readers ask a folder of results.
#include "base/folder_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/case_reader.hpp"
#include "base/output_file.hpp"

namespace driver {
namespace {

// A status file names files of its own folder only.
bool is_plain(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name != status_file &&
         name.find('/') == std::string::npos;
}

// The value of `# run: ` above the columns; empty if there is none.
std::string run_of(const std::filesystem::path& file) {
  constexpr std::string_view key = "# run: ";
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with('#');)
    if (line.starts_with(key)) return line.substr(key.size());
  return {};
}

// A table of ours ends with its last row's end of line.
bool is_torn(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(-1, std::ios::end);
  return stream.get() != '\n';
}

}  // namespace

std::optional<FolderStatus> read_status(const std::filesystem::path& folder) {
  const auto file = folder / status_file;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file, ignored) || !stream)
    throw OutputError(fmt::format("{}: not readable", file.string()));
  FolderStatus status{"", "", "running", {}};
  std::string line;
  if (std::getline(stream, line) && line != status_head)
    throw OutputError(fmt::format("{}: is not a status file of gasjet: move it away", file.string()));
  while (std::getline(stream, line) && !stream.eof()) {  // a line without its end is torn
    const auto value = [&](std::string_view key) { return line.substr(std::min(key.size(), line.size())); };
    if (line.starts_with("command: ")) status.command = value("command: ");
    if (line.starts_with("run: ")) status.run = value("run: ");
    if (line.starts_with("status: ")) status.status = value("status: ");
    if (line.starts_with("file: ") && is_plain(value("file: "))) status.files.insert(value("file: "));
  }
  return status;
}

namespace {

// Of a folder that lists the file; none if the file is the user's own.
std::optional<FolderStatus> status_listing(const std::filesystem::path& file) {
  try {
    auto status = read_status(file.parent_path().empty() ? "." : file.parent_path());
    if (status && status->files.contains(file.filename().string())) return status;
  } catch (const OutputError&) {  // a status file that is not ours
  }
  return {};
}

void require_finished(const std::filesystem::path& file, const FolderStatus& status, const std::string& own) {
  if (status.status == "running")
    throw CaseError(
        fmt::format("{}: its run has not ended (see {}): wait for its end; if it was killed, run it again",
                    file.string(), status_file));
  if (status.status == "interrupted" && status.files.contains(journal_file))
    throw CaseError(
        fmt::format("{}: was interrupted before all runs were done (see {}): run the same command to "
                    "continue",
                    file.string(), status_file));
  if (own != status.run)
    throw CaseError(fmt::format("{}: is of the run '{}', but its folder of '{}' (see {}): run the case again",
                                file.string(), own, status.run, status_file));
}

}  // namespace

void require_whole(const std::filesystem::path& file) {
  // Only a file that a run has written is read here: others may be pipes, or never end.
  const auto status = status_listing(file);
  if (!status) return;
  require_finished(file, *status, run_of(file));
  if (is_torn(file))
    throw CaseError(
        fmt::format("{}: its last row has no end of line: the file is incomplete", file.string()));
}

void require_whole(const std::filesystem::path& file, const std::string& own) {
  if (const auto status = status_listing(file)) require_finished(file, *status, own);
}

}  // namespace driver
