// SPDX-License-Identifier: Apache-2.0
// Factors -> points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "base/csv_table.hpp"
#include "many_runs/sampling.hpp"
#include "study_inputs.hpp"
#include "study_plan.hpp"

namespace driver {
namespace {

constexpr std::size_t most_runs = 10'000'000;  // of the first look of a stop rule

// Asked before the points take memory. No product is as large as to overflow.
void require_few(const TableReader& table, const StudyPlan& plan, std::size_t points) {
  const std::size_t seeds = static_cast<std::size_t>(std::max(plan.seeds, 1));
  if (points > most_runs / seeds)
    table.fail("design", fmt::format("has {} points or more of {} runs each, allowed: at most {} runs",
                                     points, seeds, most_runs));
}

void require_levels(TableReader& table, const StudyPlan& plan, bool listed) {
  for (const auto& factor : plan.factors)
    if (factor.levels.empty() == listed || (!listed && !factor.is_sampled()))
      table.fail("design", fmt::format("needs {} of each factor, {} has none",
                                       listed ? "values" : "a range or a distribution", factor.name));
}

std::vector<StudyPoint> grid(TableReader& table, const StudyPlan& plan) {
  require_levels(table, plan, true);
  std::size_t count = 1;
  for (const auto& factor : plan.factors) require_few(table, plan, count *= factor.levels.size());
  std::vector<StudyPoint> points(1);
  for (const auto& factor : plan.factors) {
    std::vector<StudyPoint> longer;
    for (const auto& point : points)
      for (std::size_t i = 0; i < factor.levels.size(); ++i) {
        longer.push_back(point);
        longer.back().push_back(static_cast<double>(i));
      }
    points = std::move(longer);
  }
  return points;
}

// The first values of all factors, then the second ones, and so on.
std::vector<StudyPoint> list(TableReader& table, const StudyPlan& plan) {
  require_levels(table, plan, true);
  std::vector<StudyPoint> points(plan.factors.empty() ? 1 : plan.factors.front().levels.size());
  require_few(table, plan, points.size());
  for (const auto& factor : plan.factors) {
    if (factor.levels.size() != points.size())
      table.fail("design", fmt::format("\"list\" needs as many values of each factor: {} has {}, not {}",
                                       factor.name, factor.levels.size(), points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) points[i].push_back(static_cast<double>(i));
  }
  return points;
}

std::vector<StudyPoint> sampled(TableReader& table, const StudyPlan& plan) {
  require_levels(table, plan, false);
  if (plan.factors.empty()) table.fail("design", "needs factors");
  if (plan.correlation && plan.design == StudyDesign::sobol_indices)
    table.fail(
        "design",
        "\"sobol_indices\" needs independent factors, but the plan has [[correlation]]: use \"sobol\"");
  const int factors = static_cast<int>(plan.factors.size());
  const bool with_indices = plan.design == StudyDesign::sobol_indices;
  const int count = table.at("points").integer(with_indices ? fewest_sobol_rows : 1, 1'000'000, 64);
  require_few(table, plan, static_cast<std::size_t>(count) * (with_indices ? plan.factors.size() + 2 : 1));
  std::vector<StudyPoint> points;  // in the unit cube at first
  table.located("design", [&] {
    if (plan.design == StudyDesign::latin_hypercube)
      points = latin_hypercube(
          count, factors, static_cast<std::uint64_t>(table.at("sampling_seed").integer(0, 1'000'000'000, 1)));
    else if (plan.design == StudyDesign::sobol)
      points = sobol_sequence(count, factors);
    else
      points = sobol_index_points(count, factors);
  });
  for (StudyPoint& point : points) {
    if (plan.correlation) plan.correlation->apply(point);
    for (std::size_t f = 0; f < plan.factors.size(); ++f) point[f] = plan.factors[f].sampled_value(point[f]);
  }
  return points;
}

std::vector<StudyPoint> of_file(TableReader& table, StudyPlan& plan) {
  const auto file = table.beside_case(table.at("file").text());
  std::vector<std::string> names;
  for (const auto& factor : plan.factors) {
    if (!factor.levels.empty() || factor.is_sampled())
      table.fail("design",
                 fmt::format("\"file\" takes the values from there: {} needs its key alone", factor.name));
    names.push_back(factor.name);
  }
  if (names.empty()) table.fail("design", "needs factors: columns of the file");
  plan.points_file = file;
  plan.inputs->check({file});
  const CsvTable csv = read_csv(file, names);
  plan.inputs->check({file});
  if (csv.rows() == 0) table.fail("file", "has no rows");
  require_few(table, plan, csv.rows());
  std::vector<StudyPoint> points(csv.rows());
  for (std::size_t f = 0; f < names.size(); ++f)
    for (std::size_t i = 0; i < points.size(); ++i) points[i].push_back(csv.values[f][i]);
  return points;
}

}  // namespace

double StudyFactor::sampled_value(double unit) const {
  if (distribution) return quantile(*distribution, unit);
  if (!logarithmic) return low + unit * (high - low);
  return low * elementary::pow(high / low, unit);
}

bool is_sampled(StudyDesign design) {
  return design == StudyDesign::latin_hypercube || design == StudyDesign::sobol ||
         design == StudyDesign::sobol_indices;
}

const StudyLevel* StudyFactor::level_of(double value) const {
  return levels.empty() ? nullptr : &levels[static_cast<std::size_t>(value)];
}

std::string StudyFactor::name_of(double value) const {
  const StudyLevel* level = level_of(value);
  return level ? level->name : fmt::format("{}", value);
}

std::vector<std::string> StudyFactor::overrides_of(double value) const {
  const StudyLevel* level = level_of(value);
  return level ? level->overrides : std::vector{key + '=' + name_of(value)};
}

std::optional<double> StudyFactor::number_of(double value) const {
  const StudyLevel* level = level_of(value);
  return level ? level->number : value;
}

std::vector<std::string> level_names(const StudyPlan& plan, const StudyPoint& point) {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < point.size(); ++f) names.push_back(plan.factors[f].name_of(point[f]));
  return names;
}

int StudyPlan::seeds_at(std::size_t point) const {
  int fewest = most_seeds();
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (const StudyLevel* level = factors[f].level_of(points[point][f]))
      fewest = std::min(fewest, level->seeds.value_or(fewest));
  return fewest;
}

double StudyPlan::amplitude_at(std::size_t point) const {
  double last = amplitude;
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (const StudyLevel* level = factors[f].level_of(points[point][f]))
      last = level->amplitude.value_or(last);
  return last;
}

std::vector<StudyPoint> points_of(TableReader& table, StudyPlan& plan) {
  plan.design = table.at("design").choice<StudyDesign>({{"grid", StudyDesign::grid},
                                                        {"list", StudyDesign::list},
                                                        {"latin_hypercube", StudyDesign::latin_hypercube},
                                                        {"sobol", StudyDesign::sobol},
                                                        {"sobol_indices", StudyDesign::sobol_indices},
                                                        {"file", StudyDesign::file}},
                                                       "grid");
  if (plan.correlation && !is_sampled(plan.design))
    table.fail("design", "takes no [[correlation]], allowed with it: \"latin_hypercube\", \"sobol\"");
  switch (plan.design) {
    case StudyDesign::grid:
      return grid(table, plan);
    case StudyDesign::list:
      return list(table, plan);
    case StudyDesign::file:
      return of_file(table, plan);
    default:
      return sampled(table, plan);
  }
}

std::optional<FactorScale> scale_of(const StudyPlan& plan, std::size_t f) {
  const StudyFactor& factor = plan.factors[f];
  FactorScale scale{factor.low, factor.high, factor.logarithmic};
  if (!factor.has_range()) {
    const auto number = [&](const StudyPoint& point) { return factor.number_of(point[f]); };
    if (!std::ranges::all_of(plan.points, [&](const auto& point) { return number(point).has_value(); }))
      return std::nullopt;
    const auto [low, high] = std::ranges::minmax_element(plan.points, {}, number);
    scale.low = *number(*low), scale.high = *number(*high);
  }
  if (scale.logarithmic) scale.low = elementary::log(scale.low), scale.high = elementary::log(scale.high);
  return scale.high > scale.low ? std::optional(scale) : std::nullopt;
}

double FactorScale::scaled(double value) const {
  return 2.0 * ((logarithmic ? elementary::log(value) : value) - low) / (high - low) - 1.0;
}

double FactorScale::value(double scaled) const {
  const double linear = low + (scaled + 1.0) / 2.0 * (high - low);
  return logarithmic ? elementary::exp(linear) : linear;
}

std::optional<std::vector<std::vector<double>>> scaled_points(const StudyPlan& plan) {
  std::vector<std::vector<double>> scaled(plan.points.size());
  for (std::size_t f = 0; f < plan.factors.size(); ++f) {
    const auto scale = scale_of(plan, f);
    if (!scale) return std::nullopt;
    for (std::size_t p = 0; p < scaled.size(); ++p) {
      const auto number = plan.factors[f].number_of(plan.points[p][f]);
      if (!number) return std::nullopt;
      scaled[p].push_back(scale->scaled(*number));
    }
  }
  return scaled;
}

}  // namespace driver
