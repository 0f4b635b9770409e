// SPDX-License-Identifier: Apache-2.0
// A part of many runs, for one of several machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result_folder.hpp"

namespace driver {

/// Folder, in a folder of results, that has a folder for each share.
inline constexpr const char* shares_folder = "shares";

/// The runs whose number modulo `count` is `number` - 1.
struct Share {
  int number = 1, count = 1;
  bool has(long run) const { return run % count == number - 1; }
  /// Name of its folder.
  std::string name() const;
};

/// Reads NUMBER/COUNT; empty: all runs. Throws a CaseError that names --share.
Share share_of(const std::string& text);

/// Folders of the shares below `folder` that hold runs, in the order of their names. Throws CaseError if one
/// is of another run than `run`, or, if that is empty, than the first.
std::vector<std::filesystem::path> shares_in(const std::filesystem::path& folder, const std::string& run);

/// Removes the shares of a run whose results are whole; one that is still computed stays.
void remove_shares(const ResultFolder& folder);

}  // namespace driver
