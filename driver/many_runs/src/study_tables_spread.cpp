// SPDX-License-Identifier: Apache-2.0
// spread.csv and effects.csv: percentiles, chances and main effects over the points of a sampled design.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "study_plan.hpp"
#include "study_tables.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

bool is_beyond(const StudyLimit& limit, double value) {
  return limit.above ? value > limit.value : value < limit.value;
}

Estimate chance_of(const StudyLimit& limit, const std::vector<std::vector<double>>& of_points) {
  long runs = 0, beyond = 0, points = 0;
  for (const auto& values : of_points) {
    runs += std::ssize(values);
    points += !values.empty();
    beyond += std::ranges::count_if(values, [&](double value) { return is_beyond(limit, value); });
  }
  return runs == 0 ? Estimate{0.0, 0.0, 1.0}
                   : chance(static_cast<double>(beyond) / static_cast<double>(runs), points);
}

std::vector<std::optional<Trend>> trends_of(const StudyPlan& plan, const RunJournal::Runs& runs,
                                            std::size_t q) {
  const auto means = point_means(plan, runs, q);
  std::vector<std::optional<Trend>> trends;
  for (std::size_t f = 0; f < plan.factors.size(); ++f) {
    std::vector<double> numbers, values;
    for (std::size_t p = 0; p < means.size(); ++p)
      if (means[p] && is_sample(plan, p)) numbers.push_back(plan.points[p][f]), values.push_back(*means[p]);
    trends.push_back(trend(numbers, values));
  }
  return trends;
}

QuantitySpread spread_of(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t q) {
  QuantitySpread result;
  std::vector<std::vector<double>> of_points;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (!is_sample(plan, p)) continue;
    of_points.emplace_back();
    for (const auto& [seed, value] : values_at(plan, runs, p, q)) of_points.back().push_back(value);
    const RunRange ended = runs_at(plan, runs, p);
    result.left_out += std::distance(ended.begin(), ended.end()) - std::ssize(of_points.back());
  }
  result.of_runs = spread(of_points);
  result.trends = trends_of(plan, runs, q);
  for (const auto& limit : plan.analysis.limits)
    result.chances.push_back(limit.quantity == q ? chance_of(limit, of_points) : Estimate{});
  return result;
}

const char* side(const StudyLimit& limit) {
  return limit.above ? "above" : "below";
}

// Calls `action` with each limit of a quantity and its chance.
template <typename Action>
void for_limits(const StudyPlan& plan, const QuantitySpread& one, std::size_t q, const Action& action) {
  for (std::size_t i = 0; i < plan.analysis.limits.size(); ++i)
    if (plan.analysis.limits[i].quantity == q) action(plan.analysis.limits[i], one.chances[i]);
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "open";
}

std::string interval(const Percentile& p) {
  return fmt::format("{:.4g} ({} to {})", p.value, shown(p.low), shown(p.high));
}

void add_left_out(const StudyPlan& plan, const QuantitySpread& one, std::size_t q, StudyNotes& notes) {
  if (one.left_out == 0) return;
  notes.push_back(
      fmt::format("spread.csv, {}: {} of {} runs have no value; they are in no percentile and no chance",
                  plan.quantities[q], one.left_out, one.left_out + (one.of_runs ? one.of_runs->runs : 0)));
}

}  // namespace

bool is_sample(const StudyPlan& plan, std::size_t point) {
  return plan.design != StudyDesign::sobol_indices || point % (plan.factors.size() + 2) < 2;
}

SpreadTable spread_table(const StudyPlan& plan, const RunJournal::Runs& runs) {
  SpreadTable table;
  for (std::size_t q = 0; is_sampled(plan.design) && q < plan.quantities.size(); ++q)
    table.push_back(spread_of(plan, runs, q));
  return table;
}

std::string spread_text(const StudyPlan& plan, const SpreadTable& table, StudyNotes& notes) {
  std::string csv = "quantity,statistic,limit,value,low,high,points,runs,left_out\n";
  for (std::size_t q = 0; q < table.size(); ++q) {
    const auto& one = table[q];
    add_left_out(plan, one, q, notes);
    if (!one.of_runs) {
      notes.push_back(fmt::format("spread.csv, {}: no percentiles, fewer than 2 points have a value",
                                  plan.quantities[q]));
      continue;
    }
    const Spread& s = *one.of_runs;
    const std::string counts = fmt::format(",{},{},{}\n", s.points, s.runs, one.left_out);
    const auto add = [&](const std::string& statistic, const std::optional<double>& limit, double value,
                         const std::optional<double>& low, const std::optional<double>& high) {
      csv += fmt::format("{},{},{},{},{},{}{}", plan.quantities[q], statistic, csv_cell(limit), value,
                         csv_cell(low), csv_cell(high), counts);
    };
    add("mean", {}, s.mean.value, s.mean.low, s.mean.high);
    add("standard_error", {}, s.standard_error, {}, {});
    add("standard_deviation", {}, s.standard_deviation, {}, {});
    for (const Percentile& p : s.percentiles)
      add(fmt::format("percentile_{}", p.percent), {}, p.value, p.low, p.high);
    for_limits(plan, one, q, [&](const StudyLimit& limit, const Estimate& chance) {
      add(std::string("chance_") + side(limit), limit.value, chance.value, chance.low, chance.high);
    });
  }
  return csv;
}

std::string effects_text(const StudyPlan& plan, const SpreadTable& table, StudyNotes& notes) {
  std::string csv = "quantity,factor,share,share_low,share_high,change_per_deviation\n";
  for (std::size_t q = 0; q < table.size(); ++q) {
    const auto& trends = table[q].trends;
    for (std::size_t f = 0; f < trends.size(); ++f)
      if (const auto& t = trends[f])
        csv += fmt::format("{},{},{},{},{},{}\n", plan.quantities[q], csv_cell(plan.factors[f].name),
                           t->share.value, t->share.low, t->share.high, t->change);
    if (std::ranges::none_of(trends, [](const auto& t) { return t.has_value(); }))
      notes.push_back(fmt::format("effects.csv, {}: no effects, it does not vary or has too few points",
                                  plan.quantities[q]));
  }
  return csv;
}

nlohmann::ordered_json spread_json(const StudyPlan& plan, const SpreadTable& table) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t q = 0; q < table.size(); ++q) {
    if (!table[q].of_runs) continue;
    const Spread& s = *table[q].of_runs;
    auto& of = json[plan.quantities[q]];
    of = {{"mean", s.mean.value},
          {"standard_error", s.standard_error},
          {"standard_deviation", s.standard_deviation}};
    for (const Percentile& p : s.percentiles)
      of["percentiles"][fmt::format("{}", p.percent)] = {
          {"value", p.value}, {"low", number(p.low)}, {"high", number(p.high)}};
    for_limits(plan, table[q], q, [&](const StudyLimit& limit, const Estimate& chance) {
      of["limits"].push_back(
          {{side(limit), limit.value}, {"chance", chance.value}, {"low", chance.low}, {"high", chance.high}});
    });
  }
  return json;
}

std::vector<std::string> spread_lines(const StudyPlan& plan, const SpreadTable& table) {
  std::vector<std::string> lines;
  for (std::size_t q = 0; q < table.size(); ++q) {
    if (!table[q].of_runs) continue;
    const Spread& s = *table[q].of_runs;
    lines.push_back(fmt::format("{}: mean {:.4g}, standard error {:.2g}; percentiles 5, 50, 95: {}, {}, {}",
                                plan.quantities[q], s.mean.value, s.standard_error,
                                interval(s.percentiles.front()), interval(s.percentiles[2]),
                                interval(s.percentiles.back())));
    for_limits(plan, table[q], q, [&](const StudyLimit& limit, const Estimate& chance) {
      lines.push_back(fmt::format("  {} {}: {:.3g} % of the runs, 95 % interval {:.3g} to {:.3g} %",
                                  side(limit), limit.value, 100.0 * chance.value, 100.0 * chance.low,
                                  100.0 * chance.high));
    });
  }
  return lines;
}

}  // namespace driver
