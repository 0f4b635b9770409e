// SPDX-License-Identifier: Apache-2.0
#include "many_runs/share.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/case_reader.hpp"

namespace driver {
namespace {

std::vector<std::pair<std::filesystem::path, FolderStatus>> all_shares(const std::filesystem::path& folder) {
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

}  // namespace

std::string Share::name() const {
  return fmt::format("{}_of_{}", number, count);
}

Share share_of(const std::string& text) {
  Share share;
  if (text.empty()) return share;
  const auto slash = text.find('/');
  const auto number = [](const std::string& part) {
    return !part.empty() && part.size() < 7 && part.find_first_not_of("0123456789") == std::string::npos
               ? std::stoi(part)
               : 0;
  };
  if (slash != std::string::npos) share = {number(text.substr(0, slash)), number(text.substr(slash + 1))};
  if (slash == std::string::npos || share.number < 1 || share.number > share.count)
    throw CaseError(fmt::format("--share {}: is not NUMBER/COUNT with 1 <= NUMBER <= COUNT", text));
  return share;
}

std::vector<std::filesystem::path> shares_in(const std::filesystem::path& folder, const std::string& run) {
  std::vector<std::filesystem::path> list;
  std::string first = run;
  for (const auto& [share, status] : all_shares(folder)) {
    if (!status.files.contains(journal_file)) continue;
    if (first.empty()) first = status.run;
    if (status.run != first)
      throw CaseError(fmt::format("{}: is of another plan, case or build{}: remove it or use another folder",
                                  share.string(), list.empty() ? "" : " than " + list.front().string()));
    list.push_back(share);
  }
  return list;
}

void remove_shares(const ResultFolder& folder) {
  std::error_code ignored;  // of folders that hold something else too
  for (const auto& [share, status] : all_shares(folder.path())) {
    if (status.run != folder.run() || status.status == "running") continue;
    for (const char* file : {journal_file, status_file}) std::filesystem::remove(share / file, ignored);
    std::filesystem::remove(share, ignored);
  }
  std::filesystem::remove(folder.path() / shares_folder, ignored);
}

}  // namespace driver
