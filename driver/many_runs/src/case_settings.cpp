// SPDX-License-Identifier: Apache-2.0
#include "case_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/load_scene.hpp"

namespace driver {

std::vector<std::string> joined(std::vector<std::string> overrides, const std::vector<std::string>& more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

Scene load_variant(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                   const std::vector<std::string>& more) {
  CaseDocument document(file, joined(overrides, more));
  return load_scene(document);
}

std::string CaseSettings::value(const std::string& path) const {
  for (const Setting& setting : settings_)
    if (setting.path == path) return setting.value;
  return {};
}

bool CaseSettings::has(const std::string& path) const {
  return std::any_of(settings_.begin(), settings_.end(), [&](const Setting& s) {
    return !s.is_default && (s.path == path || s.path.starts_with(path + '.'));
  });
}

void CaseSettings::set(std::vector<std::string>& overrides, const std::string& path,
                       const std::string& value) const {
  if (this->value(path) != value) overrides.push_back(path + '=' + value);
}

void CaseSettings::unset(std::vector<std::string>& overrides, const std::string& path) const {
  if (has(path)) overrides.push_back(std::string(unset_prefix) + path);
}

std::vector<std::string> CaseSettings::without_jets(const Scene& scene) {
  std::vector<std::string> overrides;
  for (const JetPart& jet : scene.jets)
    overrides.push_back(fmt::format("{}inflator.{}.jet", unset_prefix, jet.inflator));
  overrides.erase(std::unique(overrides.begin(), overrides.end()), overrides.end());
  return overrides;
}

std::string CaseSettings::jet_key(const JetPart& jet, const char* key) {
  return jet.path + '.' + key;
}

}  // namespace driver
