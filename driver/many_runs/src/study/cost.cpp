// SPDX-License-Identifier: Apache-2.0
// What a study costs, told beforehand.
#include "study/parts.hpp"

namespace driver {

std::vector<StudyRun> sample_runs(const StudyPlan& plan) {
  std::vector<long> numbers{0};
  if (plan.points.size() > 1) numbers.push_back(plan.end_of_numbers() - plan.most_seeds());
  StudyScenes scenes(1);
  std::vector<StudyRun> runs;
  for (const long number : numbers)
    run_chunk(plan, {number}, scenes, [&](const StudyRun& run) { runs.push_back(run); });
  return runs;
}

}  // namespace driver
