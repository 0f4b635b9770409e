// SPDX-License-Identifier: Apache-2.0
// Parts of a plan: its points and what is computed of their runs.
#pragma once

#include <map>

#include "base/case_reader.hpp"
#include "many_runs/study.hpp"

namespace driver {

/// Points of the design; `table` is [study].
std::vector<StudyPoint> points_of(TableReader& table, StudyPlan& plan);
/// Reads [analysis] and [stop]. Throws CaseError for what cannot be made of the plan's points.
void read_analysis(TableReader& root, StudyPlan& plan);

/// Names of the levels of a point.
std::vector<std::string> level_names(const StudyPlan& plan, const StudyPoint& point);

/// Points that differ in the size of the convergence alone, by the names of the other factors' levels.
std::map<std::vector<std::string>, std::vector<std::size_t>> size_groups(const StudyPlan& plan);

/// [point][factor] in [-1, 1] between the ends of the factor's range, or else its least and greatest number
/// (of their logarithms on a logarithmic scale). None if a level is no number or a factor does not vary.
std::optional<std::vector<std::vector<double>>> scaled_points(const StudyPlan& plan);

}  // namespace driver
