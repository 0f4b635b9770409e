// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/case_reader.hpp"

namespace driver {

struct CaseLog {
  std::filesystem::path folder;              // of the case file; files it names stand beside it
  std::vector<Setting> settings;             // in the order of reading
  std::vector<std::filesystem::path> files;  // that the case names, those read so far
  std::vector<KnownKey> keys;                // that the program has asked for, in that order
  std::set<std::string> may_be_absent;       // paths that TableReader::has has been asked for
};

/// `key` as a part of a path: bare if it is a word, else quoted.
std::string path_key(const std::string& key);

/// `allowed`, with the unit in brackets if there is one.
std::string with_unit(const std::string& allowed, const std::string& unit);

/// "a table", "a number" and so on.
const char* type_name(const toml::node& node);

/// An element of an array as it is written in TOML.
std::string written(const toml::node& node);

}  // namespace driver
