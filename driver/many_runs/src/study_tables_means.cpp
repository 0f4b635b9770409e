// SPDX-License-Identifier: Apache-2.0
// means.csv: what the runs of each point say together, and what those that are left out could change.
#include <fmt/format.h>

#include <algorithm>

#include "study_plan.hpp"
#include "study_tables.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

// Runs left out of the means of a study, and how far they could move one.
struct LeftOut {
  long runs = 0, points = 0;
  long open_points = 0;   // of these: with too few other runs to tell
  double furthest = 0.0;  // [standard errors]
  std::string where;      // empty if no mean tells
};

// Runs of a point that have ended, but not well.
int left_out_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point) {
  int count = 0;
  for (const auto& [number, run] : runs_at(plan, runs, point)) count += !run.is_done();
  return count;
}

std::string cells(const std::optional<double>& a, const std::optional<double>& b) {
  return csv_cell(a) + ',' + csv_cell(b);
}

// A standard error of one run is not known: an empty cell.
std::string statistics_cells(const Statistics& s) {
  const auto known = [](bool is_known, double value) {
    return is_known ? std::optional(value) : std::nullopt;
  };
  return fmt::format("{},{}", cells(known(s.count > 0, s.mean), known(s.count > 1, s.standard_error)),
                     s.count);
}

std::string range_cells(const std::optional<MeanRange>& range) {
  return range ? cells(range->low, range->high) : ",";
}

// In standard errors of the mean.
double furthest_move(const Statistics& s, const MeanRange& range) {
  return s.standard_error > 0.0 ? std::max(range.high - s.mean, s.mean - range.low) / s.standard_error : 0.0;
}

std::string sentence(const StudyPlan& plan, const RunJournal::Runs& runs, const LeftOut& left) {
  std::string text = fmt::format("runs in no mean: {} of {}, at {} of {} points", left.runs, runs.size(),
                                 left.points, plan.points.size());
  if (!left.where.empty())
    text += fmt::format(
        "; with the least or the greatest value of a point's other runs in their place a mean "
        "moves by at most {:.2g} standard errors ({})",
        left.furthest, left.where);
  if (left.open_points > 0)
    text +=
        fmt::format("; fewer than two other runs at {} of these points: how far its mean moves is unknown",
                    left.open_points);
  return text;
}

}  // namespace

std::string means_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes) {
  std::string csv = "point" + factor_names(plan) + ",quantity,mean,standard_error,runs";
  if (plan.base) csv += ",difference,difference_standard_error,pairs";
  csv += ",left_out,mean_low,mean_high\n";
  LeftOut left;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    const int left_out = left_out_at(plan, runs, p);
    bool tells = false;
    for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
      const Statistics s = statistics_at(plan, runs, p, q);
      const auto range = mean_with_left_out(s, left_out);
      csv += fmt::format("{}{},{},{}", p, level_cells(plan, p), plan.quantities[q], statistics_cells(s));
      if (plan.base) csv += ',' + statistics_cells(statistics(differences(plan, runs, p, q)));
      csv += fmt::format(",{},{}\n", left_out, range_cells(range));
      if (left_out == 0 || !range) continue;
      tells = true;
      if (const double move = furthest_move(s, *range); left.where.empty() || move > left.furthest)
        left.furthest = move, left.where = fmt::format("{} at point {}", plan.quantities[q], p);
    }
    left.runs += left_out;
    left.points += left_out > 0;
    left.open_points += left_out > 0 && !tells;
  }
  if (left.runs > 0) notes.insert(notes.begin(), sentence(plan, runs, left));
  return csv;
}

}  // namespace driver
