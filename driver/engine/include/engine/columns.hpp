// SPDX-License-Identifier: Apache-2.0
// Columns of history.csv and energy.csv. Each is one line of a table here and one row of docs/results.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/state.hpp"

namespace driver {

/// One quantity of a time level.
struct Column {
  std::string name;  // with its unit as a suffix
  /// Value at the level that step() has just computed with `record`.
  std::function<double(const Scene&, const State&)> value;
};

/// Columns of history.csv for this scene, the time first. A column exists only if the scene has its quantity.
std::vector<Column> history_columns(const Scene& scene);
/// Columns of energy.csv for this scene, the time first.
std::vector<Column> energy_columns(const Scene& scene);

/// Values of the columns, in their order.
std::vector<double> row(const std::vector<Column>& columns, const Scene& scene, const State& state);

}  // namespace driver
