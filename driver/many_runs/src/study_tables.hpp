// SPDX-License-Identifier: Apache-2.0
// The tables of a study and what is drawn of them.
#pragma once

#include "base/result_folder.hpp"
#include "many_runs/regression.hpp"
#include "many_runs/sampling.hpp"
#include "study_runs.hpp"

namespace driver {

/// What a study could not say, for its reader.
using StudyNotes = std::vector<std::string>;
/// What runs that are left out could change is the first of the notes.
std::string means_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes);
/// Indices of each quantity; none if it has none.
using SobolTable = std::vector<std::vector<SobolIndex>>;
SobolTable sobol_table(const StudyPlan& plan, const RunJournal::Runs& runs);
/// Means of a quantity over sizes, at one set of levels of the other factors, and their fit.
struct SizeFit {
  std::size_t quantity = 0;
  std::vector<std::string> others;  // names of the levels; empty for the size
  std::vector<double> sizes, means;
  bool means_differ = false;
  std::optional<Convergence> fit;
};
std::vector<SizeFit> size_fits(const StudyPlan& plan, const RunJournal::Runs& runs);
/// Tables of the analysis; what has no answer is in the notes.
std::string sobol_text(const StudyPlan& plan, const SobolTable& table, StudyNotes& notes);
std::string surface_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes);
std::string convergence_text(const StudyPlan& plan, const std::vector<SizeFit>& fits, StudyNotes& notes);

/// The cells of a point's levels with a comma before each.
std::string level_cells(const StudyPlan& plan, std::size_t point);
/// Names of the factors, with a comma before each.
std::string factor_names(const StudyPlan& plan);

}  // namespace driver
