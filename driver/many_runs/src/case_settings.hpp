// SPDX-License-Identifier: Apache-2.0
// The settings of a case by their paths, and overrides that change them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "engine/scene.hpp"

namespace driver {

/// `overrides` and then `more`.
std::vector<std::string> joined(std::vector<std::string> overrides, const std::vector<std::string>& more);
/// The scene of a case with them.
Scene load_variant(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                   const std::vector<std::string>& more);

/// Settings of a case that has been read.
class CaseSettings {
 public:
  explicit CaseSettings(const CaseDocument& document) : settings_(document.settings()) {}
  /// As TOML, given or by default; empty if the case has no use for the key.
  std::string value(const std::string& path) const;
  /// The key, or one inside the table `path`, is given.
  bool has(const std::string& path) const;
  /// Adds what makes `path` be `value`, nothing if it is.
  void set(std::vector<std::string>& overrides, const std::string& path, const std::string& value) const;
  /// Adds what takes `path` out of the case, nothing if it is not given.
  void unset(std::vector<std::string>& overrides, const std::string& path) const;
  /// Overrides that take out all jets.
  static std::vector<std::string> without_jets(const Scene& scene);
  /// Path of a key of a jet.
  static std::string jet_key(const JetPart& jet, const char* key);

 private:
  const std::vector<Setting>& settings_;
};

}  // namespace driver
