// SPDX-License-Identifier: Apache-2.0
// The tables of a study and what is drawn of them.
#pragma once

#include <nlohmann/json.hpp>

#include "base/result_folder.hpp"
#include "many_runs/regression.hpp"
#include "many_runs/sampling.hpp"
#include "many_runs/spread.hpp"
#include "study_runs.hpp"

namespace driver {

/// What a study could not say, for its reader.
using StudyNotes = std::vector<std::string>;
/// What runs that are left out could change is the first of the notes.
std::string means_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes);
/// Indices of each quantity; none if it has none.
using SobolTable = std::vector<std::vector<SobolIndex>>;
SobolTable sobol_table(const StudyPlan& plan, const RunJournal::Runs& runs);
/// What a quantity is like over the points of a sampled design.
struct QuantitySpread {
  std::optional<Spread> of_runs;             // none: fewer than two points have a value
  std::vector<std::optional<Trend>> trends;  // of each factor; none if it or the quantity does not vary
  std::vector<Estimate> chances;             // of each limit of the plan; of other quantities zeros
  long left_out = 0;                         // runs that ended without a value
};
/// Of each quantity; empty if the design does not sample.
using SpreadTable = std::vector<QuantitySpread>;
SpreadTable spread_table(const StudyPlan& plan, const RunJournal::Runs& runs);
/// Points of a sampled design that are samples: those of Sobol indices have some of their values again.
bool is_sample(const StudyPlan& plan, std::size_t point);
/// [point]: the mean over its seeds, none without one.
std::vector<std::optional<double>> point_means(const StudyPlan& plan, const RunJournal::Runs& runs,
                                               std::size_t quantity);
/// The surface of a quantity; none if the points do not suffice or the quantity does not vary.
std::optional<ResponseSurface> surface_of(const StudyPlan& plan, const RunJournal::Runs& runs,
                                          std::size_t quantity);
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
std::string spread_text(const StudyPlan& plan, const SpreadTable& table, StudyNotes& notes);
std::string effects_text(const StudyPlan& plan, const SpreadTable& table, StudyNotes& notes);
nlohmann::ordered_json spread_json(const StudyPlan& plan, const SpreadTable& table);
/// Sentences on each quantity for the reader of the command.
std::vector<std::string> spread_lines(const StudyPlan& plan, const SpreadTable& table);
std::string surface_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes);
std::string convergence_text(const StudyPlan& plan, const std::vector<SizeFit>& fits, StudyNotes& notes);

/// The cells of a point's levels with a comma before each.
std::string level_cells(const StudyPlan& plan, std::size_t point);
/// Names of the factors, with a comma before each.
std::string factor_names(const StudyPlan& plan);

}  // namespace driver
