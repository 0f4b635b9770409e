// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case_reader.hpp"

namespace driver {

struct CaseLog {
  std::filesystem::path folder;              // of the case file; files it names stand beside it
  std::vector<Setting> settings;             // in the order of reading
  std::vector<std::filesystem::path> files;  // that the case names, those read so far
};

/// `key` as a part of a path: bare if it is a word, else quoted.
std::string path_key(const std::string& key);

}  // namespace driver
