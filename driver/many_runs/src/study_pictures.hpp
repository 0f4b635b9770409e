// SPDX-License-Identifier: Apache-2.0
// Pictures of a study's tables.
#pragma once

#include "study_tables.hpp"

namespace driver {

/// gnuplot's commands of a picture, or why there is none.
struct StudyPicture {
  std::string commands, why_not;
};
/// Against the first factor that has numbers, else by point.
StudyPicture means_picture(const StudyPlan& plan, const RunJournal::Runs& runs);
/// Of a sampled design: a panel for each quantity and factor, the points with their trend.
StudyPicture trends_picture(const StudyPlan& plan, const RunJournal::Runs& runs, const SpreadTable& table);
/// A panel for each quantity and pair of factors, the others in the middle of their scales.
StudyPicture surface_picture(const StudyPlan& plan, const RunJournal::Runs& runs);
StudyPicture sobol_picture(const StudyPlan& plan, const SobolTable& table);
StudyPicture convergence_picture(const StudyPlan& plan, const std::vector<SizeFit>& fits);

}  // namespace driver
