// SPDX-License-Identifier: Apache-2.0
// Columns of history.csv and energy.csv: one line of a table each, and one row of docs/results.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "driver/state.hpp"

namespace driver {

/// One quantity of a level.
struct Column {
  std::string name;  // with its unit as suffix
  /// Of the level that step() has just computed with `record`.
  std::function<double(const Scene&, const State&)> value;
};

/// Columns of the scene, the time first: only what it has.
std::vector<Column> history_columns(const Scene& scene);
std::vector<Column> energy_columns(const Scene& scene);

/// One value a column.
std::vector<double> row(const std::vector<Column>& columns, const Scene& scene, const State& state);

}  // namespace driver
