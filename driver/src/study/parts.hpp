// SPDX-License-Identifier: Apache-2.0
// The parts of a study: from the plan to points, from shares to tables.
#pragma once

#include <map>

#include "driver/case_reader.hpp"
#include "driver/ensemble.hpp"
#include "driver/study.hpp"

namespace driver {

inline constexpr const char* plan_copy = "plan.toml";  // in the study's folder
inline constexpr const char* shares_folder = "shares";
/// Files of the tables, beside the plan's copy and the shares.
bool is_study_file(const std::string& name);

/// Points of the design; `table` is [study].
std::vector<StudyPoint> points_of(TableReader& table, StudyPlan& plan);

/// Seed of a run; 0 without a perturbation.
int seed_of(const StudyPlan& plan, long run);
std::size_t point_of(const StudyPlan& plan, long run);

/// Runs that have ended, by their numbers; of one that two shares have computed the first share's.
using StudyRuns = std::map<long, StudyRun>;
/// What opens a share's file, as its build wrote it.
struct StudyRecords {
  StudyRuns runs;
  Provenance lines;  // of the build that computed them
};
/// Reads all shares of a folder. A line that a kill tore is not there. Throws CaseError for shares of
/// different ids, or of another id than `id` unless that is empty.
StudyRecords read_shares(const std::filesystem::path& folder, const std::string& id);
std::string line_of(const StudyRun& run);
std::optional<StudyRun> run_of_line(const std::string& line);

/// Runs that the plan asks for, given those that have ended: more only after a stop rule's look is whole.
std::vector<long> asked_runs(const StudyPlan& plan, const StudyRuns& ended);

/// Values of one quantity at a point by seed; runs that are not done have none.
std::map<int, double> values_at(const StudyPlan& plan, const StudyRuns& runs, std::size_t point,
                                std::size_t quantity);
/// Differences against the base at common seeds.
std::vector<double> differences(const StudyPlan& plan, const StudyRuns& runs, std::size_t point,
                                std::size_t quantity);

/// [point][factor] in [-1, 1] between the least and the greatest number of the factor (of their logarithms on
/// a logarithmic scale). None if a level is no number or a factor does not vary.
std::optional<std::vector<std::vector<double>>> scaled_points(const StudyPlan& plan);

}  // namespace driver
