// SPDX-License-Identifier: Apache-2.0
// Tables of what is computed from the means of all points.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "study_plan.hpp"
#include "study_tables.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

struct SizeRow {
  std::vector<double> sizes, values;
  std::vector<Statistics> means;
  long steps = 1;  // of its longest run
};

SizeRow size_row(const StudyPlan& plan, const RunJournal::Runs& runs, const std::vector<std::size_t>& points,
                 std::size_t q) {
  const StudyFactor& size = plan.factors[*plan.analysis.convergence];
  SizeRow row;
  for (const std::size_t p : points) {
    const Statistics s = statistics_at(plan, runs, p, q);
    if (s.count == 0) continue;
    row.sizes.push_back(*size.number_of(plan.points[p][*plan.analysis.convergence]));
    row.values.push_back(s.mean);
    row.means.push_back(s);
    for (const auto& [number, run] : runs_at(plan, runs, p)) row.steps = std::max(row.steps, run.steps);
  }
  return row;
}

// A run rounds in each of its steps, and in the sub-steps of its gas.
double rounding_of(const SizeRow& row) {
  constexpr long fewest_steps = 1000;
  double most = 0.0;
  for (const double value : row.values) most = std::max(most, std::abs(value));
  return static_cast<double>(std::max(row.steps, fewest_steps)) * std::numeric_limits<double>::epsilon() *
         most;
}

// Whether more than rounding moves the values; a single one may do.
bool varies(const std::vector<double>& values) {
  constexpr double rounding = 1e-12;
  const auto is_first = [&](double value) {
    return std::abs(value - values.front()) <= rounding * std::abs(values.front());
  };
  return values.size() < 2 || !std::ranges::all_of(values, is_first);
}

std::string why_no_surface(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t q) {
  std::vector<double> values;
  for (const auto& mean : point_means(plan, runs, q))
    if (mean) values.push_back(*mean);
  if (!varies(values)) return "no surface, it does not vary";
  return fmt::format("no surface, the {} of {} points with a mean are too few", values.size(),
                     plan.points.size());
}

}  // namespace

std::vector<std::optional<double>> point_means(const StudyPlan& plan, const RunJournal::Runs& runs,
                                               std::size_t quantity) {
  std::vector<std::optional<double>> means;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    const Statistics s = statistics_at(plan, runs, p, quantity);
    means.push_back(s.count == 0 ? std::nullopt : std::optional(s.mean));
  }
  return means;
}

SobolTable sobol_table(const StudyPlan& plan, const RunJournal::Runs& runs) {
  SobolTable table;
  for (std::size_t q = 0; q < plan.quantities.size(); ++q)
    table.push_back(sobol_indices(point_means(plan, runs, q), static_cast<int>(plan.factors.size())));
  return table;
}

std::string sobol_text(const StudyPlan& plan, const SobolTable& table, StudyNotes& notes) {
  std::string csv =
      "quantity,factor,first_order,first_order_low,first_order_high,total,total_low,total_high\n";
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto& list = table[q];
    for (std::size_t f = 0; f < list.size(); ++f)
      csv += fmt::format("{},{},{},{},{},{},{},{}\n", plan.quantities[q], csv_cell(plan.factors[f].name),
                         list[f].first_order.value, list[f].first_order.low, list[f].first_order.high,
                         list[f].total.value, list[f].total.low, list[f].total.high);
    if (list.empty())
      notes.push_back(
          fmt::format("sobol.csv, {}: no indices, it does not vary or fewer than {} rows are whole",
                      plan.quantities[q], fewest_sobol_rows));
  }
  return csv;
}

std::optional<ResponseSurface> surface_of(const StudyPlan& plan, const RunJournal::Runs& runs,
                                          std::size_t quantity) {
  const auto scaled = scaled_points(plan);
  if (!scaled) return std::nullopt;
  const auto means = point_means(plan, runs, quantity);
  std::vector<std::vector<double>> points;
  std::vector<double> values;
  for (std::size_t p = 0; p < means.size(); ++p)
    if (means[p]) points.push_back((*scaled)[p]), values.push_back(*means[p]);
  if (!varies(values)) return std::nullopt;
  return fit_surface(points, values);
}

std::string surface_text(const StudyPlan& plan, const RunJournal::Runs& runs, StudyNotes& notes) {
  std::string csv = "quantity,term,coefficient,standard_error,residual_deviation,explained\n";
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto surface = surface_of(plan, runs, q);
    if (!surface) {
      notes.push_back(fmt::format("surface.csv, {}: {}", plan.quantities[q], why_no_surface(plan, runs, q)));
      continue;
    }
    for (const auto& term : surface->terms) {
      std::vector<std::string> names;
      for (const int f : term.factors) names.push_back(plan.factors[static_cast<std::size_t>(f)].name);
      csv +=
          fmt::format("{},{},{},{},{},{}\n", plan.quantities[q],
                      names.empty() ? "1" : csv_cell(fmt::format("{}", fmt::join(names, " * "))),
                      term.coefficient, term.standard_error, surface->residual_deviation, surface->explained);
    }
  }
  return csv;
}

// One fit for each set of levels of the other factors.
std::vector<SizeFit> size_fits(const StudyPlan& plan, const RunJournal::Runs& runs) {
  std::vector<SizeFit> fits;
  const auto groups = size_groups(plan);
  for (std::size_t q = 0; q < plan.quantities.size(); ++q)
    for (const auto& [others, points] : groups) {
      SizeRow row = size_row(plan, runs, points, q);
      const bool differ = means_differ(row.means, rounding_of(row));
      const auto fit = differ ? fit_convergence(row.sizes, row.values) : std::nullopt;
      fits.push_back({q, others, std::move(row.sizes), std::move(row.values), differ, fit});
    }
  return fits;
}

std::string convergence_text(const StudyPlan& plan, const std::vector<SizeFit>& fits, StudyNotes& notes) {
  std::string csv = "quantity" + factor_names(plan) + ",limit,order,coefficient,residual,sizes\n";
  for (const SizeFit& one : fits) {
    std::string cells, levels;
    for (const auto& other : one.others) {
      cells += ',' + csv_cell(other);
      if (!other.empty()) levels += ", " + other;
    }
    const std::string& quantity = plan.quantities[one.quantity];
    const auto& fit = one.fit;
    csv += quantity + cells;
    csv += fit ? fmt::format(",{},{},{},{},{}\n", fit->limit, fit->order, fit->coefficient, fit->residual,
                             one.sizes.size())
               : fmt::format(",,,,,{}\n", one.sizes.size());
    if (!fit)
      notes.push_back(fmt::format(
          "convergence.csv, {}{}: no order, {}", quantity, levels,
          one.sizes.size() < 3 ? "fewer than 3 sizes have a mean"
          : one.means_differ   ? "none from 0.1 to 8 fits best"
                               : "the means do not differ beyond twice their standard errors or rounding"));
  }
  return csv;
}

}  // namespace driver
