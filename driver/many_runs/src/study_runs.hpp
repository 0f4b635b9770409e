// SPDX-License-Identifier: Apache-2.0
// Which runs a plan asks for, all at once or look by look, and what they say of each point.
#pragma once

#include <limits>
#include <map>

#include "many_runs/statistics.hpp"
#include "many_runs/study.hpp"
#include "run_journal.hpp"

namespace driver {

/// What the records of a plan, which must outlive it, are like.
RunShape shape_of(const StudyPlan& plan);

/// Seed of a run; 0 without a perturbation.
int seed_of(const StudyPlan& plan, long run);
std::size_t point_of(const StudyPlan& plan, long run);

/// Runs of a point that have ended, of its first `most` seeds.
struct RunRange {
  RunJournal::Runs::const_iterator first, last;
  RunJournal::Runs::const_iterator begin() const { return first; }
  RunJournal::Runs::const_iterator end() const { return last; }
};
RunRange runs_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                 int most = std::numeric_limits<int>::max());

/// Runs that the plan asks for, given those that have ended: more only after a stop rule's look is whole.
std::vector<long> asked_runs(const StudyPlan& plan, const RunJournal::Runs& ended);

/// What a stop rule has come to at a point: nothing where it claims nothing, as at a base.
enum class StopClaim { none, open, decided, undecided };
/// Of each point; none without a stop rule.
std::vector<StopClaim> stop_claims(const StudyPlan& plan, const RunJournal::Runs& ended);

/// Values of one quantity at a point by seed; runs that are not done have none.
std::map<int, double> values_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                                std::size_t quantity);
Statistics statistics_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                         std::size_t quantity);
/// Differences against the base at common seeds.
std::vector<double> differences(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                                std::size_t quantity);

}  // namespace driver
