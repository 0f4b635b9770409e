// SPDX-License-Identifier: Apache-2.0
// What a plan has computed of its runs: [analysis] and [stop].
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "study/parts.hpp"

namespace driver {
namespace {

constexpr Bounds rate{0.0, 0.5, true, "a number above 0, at most 0.5"};

std::size_t factor_named(TableReader& table, const char* key, const StudyPlan& plan) {
  const auto name = table.at(key).text();
  const auto found = std::ranges::find(plan.factors, name, &StudyFactor::name);
  if (found != plan.factors.end()) return static_cast<std::size_t>(found - plan.factors.begin());
  std::vector<std::string> names;
  for (const auto& factor : plan.factors) names.push_back(factor.name);
  table.fail(key, fmt::format("is \"{}\", a factor is needed: {}", name, fmt::join(names, ", ")));
}

// Base of each point: all its levels but one are the same.
void set_bases(StudyPlan& plan) {
  plan.bases.assign(plan.points.size(), std::nullopt);
  if (!plan.base) return;
  const auto others = [&](const StudyPoint& point) {
    std::vector<std::string> names;
    for (std::size_t f = 0; f < point.levels.size(); ++f)
      if (f != plan.base->factor) names.push_back(point.levels[f].name);
    return names;
  };
  const auto is_base = [&](const StudyPoint& point) {
    return point.levels[plan.base->factor].name == plan.base->level;
  };
  std::map<std::vector<std::string>, std::size_t> at;
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    if (is_base(plan.points[p])) at.emplace(others(plan.points[p]), p);
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    if (const auto found = at.find(others(plan.points[p])); found != at.end() && found->second != p)
      plan.bases[p] = found->second;
}

void read_tables(TableReader& root, StudyPlan& plan) {
  auto table = root.optional_table("analysis");
  if (!table) return;
  if (auto base = table->optional_table("base")) {
    plan.base = StudyBase{factor_named(*base, "factor", plan), base->at("level").text()};
    const auto& levels = plan.factors[plan.base->factor].levels;
    if (std::ranges::find(levels, plan.base->level, &StudyLevel::name) == levels.end())
      base->fail("level", fmt::format("is \"{}\", which the factor does not have", plan.base->level));
    base->finish();
  }
  plan.response_surface = table->at("response_surface").flag(false);
  if (table->has("convergence")) {
    plan.convergence = factor_named(*table, "convergence", plan);
    const auto& levels = plan.factors[*plan.convergence].levels;
    if (levels.size() < 3 ||
        !std::ranges::all_of(levels, [](const auto& level) { return level.number.value_or(0.0) > 0.0; }))
      table->fail("convergence", "needs a factor with 3 or more values above 0: sizes");
  }
  table->finish();
}

void read_stop(TableReader& root, StudyPlan& plan) {
  auto table = root.optional_table("stop");
  if (!table) return;
  StudyStop stop;
  stop.quantity = table->at("quantity").text();
  if (std::ranges::find(plan.quantities, stop.quantity) == plan.quantities.end())
    table->fail("quantity", fmt::format("is \"{}\", one of the study's is needed: {}", stop.quantity,
                                        fmt::join(plan.quantities, ", ")));
  stop.standard_error = table->at("standard_error").optional_number(positive);
  stop.error_rate = table->at("sign_error_rate").optional_number(rate);
  if (stop.standard_error.has_value() == stop.error_rate.has_value())
    table->fail("standard_error", "or sign_error_rate is needed, one of the two");
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

void read_analysis(TableReader& root, StudyPlan& plan) {
  read_tables(root, plan);
  set_bases(plan);
  read_stop(root, plan);
}

}  // namespace driver
