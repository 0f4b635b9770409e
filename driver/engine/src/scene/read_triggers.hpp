// SPDX-License-Identifier: Apache-2.0
// [[sensor]], [[trigger]] -> gas::TriggerModel.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/scene.hpp"

namespace driver {

/// Sensors and triggers by their names: nodes of gas::TriggerModel.
class TriggerNames {
 public:
  void add(TableReader& table);
  /// Node called `name`; the error names `key` of `table`.
  std::size_t node(const TableReader& table, const std::string& key, const std::string& name) const;
  /// Node that the optional key "trigger" names.
  std::optional<std::size_t> optional_node(TableReader& table);
  void use(const std::vector<std::size_t>& nodes) { used_.insert(nodes.begin(), nodes.end()); }
  void warn_of_idle(Scene& scene) const;

 private:
  std::vector<std::string> names_;
  std::set<std::size_t> used_;
};

/// [[sensor]], [[trigger]]
TriggerNames read_triggers(TableReader& root, GasPart& part);

}  // namespace driver
