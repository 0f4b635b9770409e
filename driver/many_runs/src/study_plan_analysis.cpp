// SPDX-License-Identifier: Apache-2.0
// What a plan has computed of its runs: [analysis] and [stop].
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "many_runs/regression.hpp"
#include "study_plan.hpp"

namespace driver {
namespace {

constexpr Bounds rate{0.0, 0.5, true, "a number above 0, at most 0.5"};

std::size_t factor_named(TableReader& table, const char* key, const StudyPlan& plan) {
  const auto name = table.at(key).text();
  const auto found = std::ranges::find(plan.factors, name, &StudyFactor::name);
  if (found != plan.factors.end()) return static_cast<std::size_t>(found - plan.factors.begin());
  std::vector<std::string> names;
  for (const auto& factor : plan.factors) names.push_back(factor.name);
  table.fail(key, names.empty() ? fmt::format("is \"{}\", but the plan has no factors", name)
                                : fmt::format("is \"{}\", allowed: one of the factors {}", name,
                                              fmt::join(names, ", ")));
}

std::size_t quantity_named(TableReader& table, const StudyPlan& plan) {
  const auto name = table.at("quantity").text();
  const auto found = std::ranges::find(plan.quantities, name);
  if (found == plan.quantities.end())
    table.fail("quantity", fmt::format("is \"{}\", allowed: one of the study's quantities {}", name,
                                       fmt::join(plan.quantities, ", ")));
  return static_cast<std::size_t>(found - plan.quantities.begin());
}

// Base of each point: all its levels but one are the same.
void set_bases(StudyPlan& plan) {
  const StudyFactor& factor = plan.factors[plan.base->factor];
  const auto others = [&](const StudyPoint& point) {
    StudyPoint rest = point;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(plan.base->factor));
    return rest;
  };
  const auto is_base = [&](const StudyPoint& point) {
    return factor.name_of(point[plan.base->factor]) == plan.base->level;
  };
  std::map<StudyPoint, std::size_t> at;
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    if (is_base(plan.points[p])) at.emplace(others(plan.points[p]), p);
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    if (const auto found = at.find(others(plan.points[p])); found != at.end() && found->second != p)
      plan.bases[p] = found->second;
}

std::string shown_levels(const StudyFactor& factor) {
  if (factor.levels.empty()) return "it has no levels";
  std::vector<std::string> names;
  for (const auto& level : factor.levels) names.push_back('"' + level.name + '"');
  return fmt::format("it has {}", fmt::join(names, ", "));
}

void read_base(TableReader& analysis, StudyPlan& plan) {
  auto table = analysis.optional_table("base");
  if (!table) return;
  plan.base = StudyBase{factor_named(*table, "factor", plan), table->at("level").text()};
  const auto& factor = plan.factors[plan.base->factor];
  if (std::ranges::find(factor.levels, plan.base->level, &StudyLevel::name) == factor.levels.end())
    table->fail("level", fmt::format("is \"{}\", which the factor does not have: {}", plan.base->level,
                                     shown_levels(factor)));
  table->finish();
  set_bases(plan);
  if (std::ranges::none_of(plan.bases, [](const auto& base) { return base.has_value(); }))
    analysis.fail("base", fmt::format("pairs no points: it needs two that differ in {} only, as in a grid",
                                      factor.name));
}

// Points that tell the terms of a quadratic apart; of many a part is looked at first.
bool has_full_rank(const std::vector<std::vector<double>>& points, std::size_t terms) {
  const auto fits = [&](std::size_t count) {
    std::vector<std::vector<double>> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(points[i * points.size() / count]);
    return fit_surface(some, std::vector<double>(count, 0.0)).has_value();
  };
  const std::size_t few = std::max<std::size_t>(4 * terms, 2000);
  return (few < points.size() && fits(few)) || fits(points.size());
}

void check_surface(TableReader& table, const StudyPlan& plan) {
  constexpr std::size_t most_cells = 100'000'000;  // of the matrix: 0.8 GB
  const char* key = "response_surface";
  const std::size_t factors = plan.factors.size(), terms = (factors + 1) * (factors + 2) / 2;
  if (factors == 0) table.fail(key, "needs factors");
  for (std::size_t f = 0; f < factors; ++f) {
    const auto number = [&](const StudyPoint& point) { return plan.factors[f].number_of(point[f]); };
    const auto& name = plan.factors[f].name;
    if (!std::ranges::all_of(plan.points, [&](const auto& point) { return number(point).has_value(); }))
      table.fail(key, fmt::format("needs factors that are numbers, {} has levels or other values", name));
    const auto [low, high] = std::ranges::minmax_element(plan.points, {}, number);
    if (number(*low) == number(*high))
      table.fail(key, fmt::format("needs factors that vary, {} is always {}", name, *number(*low)));
  }
  if (plan.points.size() < terms + 1)
    table.fail(key, fmt::format("of {} factors has {} terms and needs {} points or more, the plan has {}",
                                factors, terms, terms + 1, plan.points.size()));
  if (plan.points.size() > most_cells / terms)
    table.fail(key,
               fmt::format("has {} terms at {} points, allowed for this number of terms: at most {} points",
                           terms, plan.points.size(), most_cells / terms));
  if (!has_full_rank(*scaled_points(plan), terms))
    table.fail(
        key, fmt::format("has {} terms that the points do not distinguish: use three or more values of each "
                         "factor, and points that vary them in turn",
                         terms));
}

void read_convergence(TableReader& table, StudyPlan& plan) {
  plan.analysis.convergence = factor_named(table, "convergence", plan);
  const auto& levels = plan.factors[*plan.analysis.convergence].levels;
  if (levels.size() < 3 ||
      !std::ranges::all_of(levels, [](const auto& level) { return level.number.value_or(0.0) > 0.0; }))
    table.fail("convergence", "needs a factor with 3 or more sizes above 0");
  for (const auto& [others, points] : size_groups(plan))
    if (points.size() >= 3) return;
  table.fail("convergence", "needs 3 points or more that differ in the size only, as in a grid");
}

void read_tables(TableReader& root, StudyPlan& plan) {
  plan.bases.assign(plan.points.size(), std::nullopt);
  auto table = root.optional_table("analysis");
  if (!table) return;
  read_base(*table, plan);
  plan.analysis.response_surface = table->at("response_surface").flag(false);
  if (plan.analysis.response_surface) check_surface(*table, plan);
  plan.analysis.pictures = table->at("pictures").flag(false);
  if (table->has("convergence")) read_convergence(*table, plan);
  table->finish();
}

void read_stop(TableReader& root, StudyPlan& plan) {
  auto table = root.optional_table("stop");
  if (table) table->allow_only({"most_seeds", "quantity", "sign_error_rate", "standard_error"});
  if (!table) return;
  StudyStop stop;
  stop.quantity = plan.quantities[quantity_named(*table, plan)];
  stop.standard_error = table->at("standard_error").optional_number(positive);
  stop.error_rate = table->at("sign_error_rate").optional_number(rate);
  if (stop.standard_error.has_value() == stop.error_rate.has_value())
    table->fail("standard_error", stop.error_rate ? "is given with sign_error_rate: leave out one of the two"
                                                  : "is missing, needed: it or sign_error_rate");
  if (stop.error_rate && !plan.base) table->fail("sign_error_rate", "needs [analysis.base]");
  if (plan.seeds < 4) table->fail("", "needs study.seeds of 4 or more: runs of the first look");
  for (const auto& factor : plan.factors)
    for (const auto& level : factor.levels)
      if (level.seeds)
        table->fail("",
                    fmt::format("decides on seeds, but the level \"{}\" has some of its own", level.name));
  stop.most_seeds = table->at("most_seeds").integer(plan.seeds, 1'000'000, 1024);
  plan.stop = stop;
  table->finish();
}

}  // namespace

std::map<std::vector<std::string>, std::vector<std::size_t>> size_groups(const StudyPlan& plan) {
  std::map<std::vector<std::string>, std::vector<std::size_t>> groups;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    auto others = level_names(plan, plan.points[p]);
    others[*plan.analysis.convergence].clear();
    groups[others].push_back(p);
  }
  return groups;
}

void read_limits(TableReader& root, StudyPlan& plan) {
  for (auto& table : root.tables("limit")) {
    table.allow_only({"above", "below", "quantity"});
    if (!is_sampled(plan.design))
      table.fail("",
                 "needs a design whose points are samples: \"latin_hypercube\", \"sobol\" or "
                 "\"sobol_indices\"");
    StudyLimit limit;
    limit.quantity = quantity_named(table, plan);
    const auto above = table.at("above").optional_number(any_number);
    const auto below = table.at("below").optional_number(any_number);
    if (above.has_value() == below.has_value())
      table.fail(above ? "below" : "above",
                 above ? "is given with above: leave out one of the two" : "is missing, needed: it or below");
    limit.above = above.has_value();
    limit.value = above ? *above : *below;
    plan.analysis.limits.push_back(limit);
    table.finish();
  }
}

void read_analysis(TableReader& root, StudyPlan& plan) {
  read_tables(root, plan);
  read_stop(root, plan);
}

}  // namespace driver
