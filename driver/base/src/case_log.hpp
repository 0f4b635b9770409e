// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/case_reader.hpp"
#include "base/curve_reader.hpp"

namespace driver {

struct CaseLog {
  std::filesystem::path folder;              // folder of the case file; files named in the case are relative
                                             // to it
  std::vector<Setting> settings;             // in the order of reading
  std::vector<std::filesystem::path> files;  // files named in the case, read so far
  std::vector<KnownKey> keys;                // keys that the program has asked for, in that order
  std::set<std::string> may_be_absent;       // paths passed to TableReader::has
  std::vector<UsedCurve> curves;             // in the order of reading
  std::optional<double> ambient_pressure;    // [Pa]; none in a scene without gas, set before curves are read
};

/// `key` as a part of a path; quoted unless it is a word.
std::string path_key(const std::string& key);

/// `allowed`, with the unit in brackets if there is one.
std::string with_unit(const std::string& allowed, const std::string& unit);

/// "a table", "a number" and so on.
const char* type_name(const toml::node& node);

/// An element of an array as it is written in TOML.
std::string written(const toml::node& node);

}  // namespace driver
