// SPDX-License-Identifier: Apache-2.0
// Parts of a plan: its points and what is computed of their runs.
#pragma once

#include <map>

#include "base/case_reader.hpp"
#include "many_runs/study.hpp"

namespace driver {

/// Allowed displacements of nodes.
inline constexpr Bounds small_length{1e-18, 1e-3, false, "1e-18 to 1e-3", "m"};

/// `set` and `unset` of a table.
std::vector<std::string> read_overrides(TableReader& table);
/// Throws CaseError if overrides set the perturbation: seeds set it themselves, and another would add to it.
void refuse_perturbation(TableReader& table, const char* key, const std::vector<std::string>& overrides);
/// Reads [[factor]].
void read_factors(TableReader& root, StudyPlan& plan);
/// Reads [[correlation]], after the factors.
void read_correlations(TableReader& root, StudyPlan& plan);
/// Points of the design; `table` is [study].
std::vector<StudyPoint> points_of(TableReader& table, StudyPlan& plan);
/// Reads [analysis] and [stop]. Throws CaseError for what cannot be made of the plan's points.
void read_analysis(TableReader& root, StudyPlan& plan);

/// Reads [[limit]], after the points and the quantities.
void read_limits(TableReader& root, StudyPlan& plan);

/// Names of the levels of a point.
std::vector<std::string> level_names(const StudyPlan& plan, const StudyPoint& point);

/// Points that differ in the size of the convergence alone, by the names of the other factors' levels.
std::map<std::vector<std::string>, std::vector<std::size_t>> size_groups(const StudyPlan& plan);

/// A factor's numbers on [-1, 1].
struct FactorScale {
  double low = 0.0, high = 0.0;  // logarithms if it is logarithmic
  bool logarithmic = false;

  double scaled(double value) const;
  double value(double scaled) const;
};
/// From end to end of the factor's range, or else from its least to its greatest number. None if a level is
/// no number or the factor does not vary.
std::optional<FactorScale> scale_of(const StudyPlan& plan, std::size_t factor);

/// [point][factor] on the scales of the factors; none if one has none.
std::optional<std::vector<std::vector<double>>> scaled_points(const StudyPlan& plan);

}  // namespace driver
