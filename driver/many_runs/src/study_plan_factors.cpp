// SPDX-License-Identifier: Apache-2.0
// [[factor]] and [[correlation]]: what a study varies.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>

#include "study_plan.hpp"

namespace driver {
namespace {

void read_levels(TableReader& table, StudyFactor& factor, int seeds) {
  for (auto& reader : table.tables("level")) {
    StudyLevel level{reader.at("name").text(), read_overrides(reader), std::nullopt};
    if (seeds == 0 && (reader.has("seeds") || reader.has("amplitude")))
      reader.fail("", "has seeds or an amplitude, which need study.seeds of 1 or more");
    if (reader.has("seeds")) level.seeds = reader.at("seeds").integer(1, seeds, seeds);
    if (seeds > 0) refuse_perturbation(reader, "set", level.overrides);
    level.amplitude = reader.at("amplitude").optional_number(small_length);
    reader.finish();
    factor.levels.push_back(std::move(level));
  }
  if (factor.levels.empty()) table.fail("key", "is missing, needed: a key or [[factor.level]]");
}

void read_range(TableReader& table, StudyFactor& factor) {
  const auto range = table.at("range").numbers(any_number);
  factor.logarithmic = table.at("scale").choice<bool>({{"linear", false}, {"logarithmic", true}}, "linear");
  if (range.size() != 2 || !(range[0] < range[1]))
    table.fail("range", "is not a range, allowed: [low, high] with low < high");
  if (factor.logarithmic && !(range[0] > 0.0))
    table.fail("range", "reaches 0 or below, which a logarithmic scale does not");
  factor.low = range[0], factor.high = range[1];
}

void require_rise(TableReader& table, double low, double high) {
  if (!(low < high)) table.fail("high", fmt::format("is {}, allowed: above low = {}", high, low));
}

Distribution read_normal(TableReader& table, bool is_truncated) {
  constexpr double least_share = 1e-6;  // else the limits, not the distribution, say what the values are
  constexpr double infinite = std::numeric_limits<double>::infinity();
  NormalDistribution normal{table.at("mean").number(any_number),
                            table.at("standard_deviation").number(positive), -infinite, infinite};
  if (!is_truncated) return normal;
  normal.low = table.at("low").number(any_number), normal.high = table.at("high").number(any_number);
  require_rise(table, normal.low, normal.high);
  if (const double share = share_inside(normal); !(share >= least_share))
    table.fail("low", fmt::format("to high has {:.2g} of the distribution, allowed: {} or more", share,
                                  least_share));
  return normal;
}

Distribution read_triangular(TableReader& table) {
  const TriangularDistribution d{table.at("low").number(any_number), table.at("mode").number(any_number),
                                 table.at("high").number(any_number)};
  require_rise(table, d.low, d.high);
  if (!(d.low <= d.mode && d.mode <= d.high))
    table.fail("mode", fmt::format("is {}, allowed: from low = {} to high = {}", d.mode, d.low, d.high));
  return d;
}

void read_distribution(TableReader& table, StudyFactor& factor) {
  for (const char* key : {"range", "values"})
    if (table.has(key)) table.fail(key, "is given with a distribution: leave out one of the two");
  enum class Shape { normal, truncated_normal, triangular, log_normal };
  switch (table.at("distribution")
              .choice<Shape>({{"normal", Shape::normal},
                              {"truncated_normal", Shape::truncated_normal},
                              {"triangular", Shape::triangular},
                              {"log_normal", Shape::log_normal}})) {
    case Shape::normal:
      factor.distribution = read_normal(table, false);
      break;
    case Shape::truncated_normal:
      factor.distribution = read_normal(table, true);
      break;
    case Shape::triangular:
      factor.distribution = read_triangular(table);
      break;
    case Shape::log_normal:
      constexpr Bounds above_one{1.0, std::numeric_limits<double>::max(), true, "a number above 1"};
      factor.distribution = LogNormalDistribution{table.at("median").number(positive),
                                                  table.at("deviation_factor").number(above_one)};
      factor.logarithmic = true;
      break;
  }
}

StudyFactor read_factor(TableReader& table, int seeds) {
  StudyFactor factor;
  factor.path = table.path();
  if (table.has("key")) factor.key = table.at("key").text();
  if (seeds > 0) refuse_perturbation(table, "key", {factor.key});
  factor.name = factor.key.empty() ? table.at("name").text() : table.at("name").text(factor.key);
  if (factor.key.empty())
    read_levels(table, factor, seeds);
  else if (table.has("values"))
    for (const auto& [text, number] : table.at("values").elements())
      factor.levels.push_back({text, {factor.key + '=' + text}, number});
  else if (table.has("distribution"))
    read_distribution(table, factor);
  else if (table.has("range"))
    read_range(table, factor);
  table.finish();
  return factor;
}

bool is_same(const PathPart& a, const PathPart& b) {
  return a.key == b.key;
}

// What a factor sets: its key, or those of its levels.
std::vector<std::vector<PathPart>> paths_of(const StudyFactor& factor) {
  if (!factor.key.empty()) return {split_path(factor.key)};
  std::vector<std::vector<PathPart>> paths;
  for (const auto& level : factor.levels)
    for (const auto& text : level.overrides)
      if (!text.starts_with(unset_prefix)) paths.push_back(split_path(text.substr(0, text.find('='))));
  return paths;
}

// A factor that sets what one before it sets, or a table around that, would leave the other without effect.
void require_own_keys(TableReader& table, const std::vector<StudyFactor>& factors) {
  const auto later = paths_of(factors.back());
  for (std::size_t f = 0; f + 1 < factors.size(); ++f)
    for (const auto& earlier : paths_of(factors[f]))
      for (const auto& path : later)
        if (path.size() <= earlier.size() && std::equal(path.begin(), path.end(), earlier.begin(), is_same))
          table.fail(factors.back().key.empty() ? "" : "key",
                     fmt::format("sets again what {} sets: use another key, or levels that set both",
                                 factors[f].name));
}

// A factor of a pair, by its name.
std::size_t sampled_factor(TableReader& table, const StudyPlan& plan, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < plan.factors.size(); ++f) {
    if (plan.factors[f].is_sampled()) names.push_back(plan.factors[f].name);
    if (plan.factors[f].name == name && plan.factors[f].is_sampled()) return f;
  }
  table.fail("factors", fmt::format("has \"{}\", allowed: factors with a distribution or a range{}{}", name,
                                    names.empty() ? "" : ": ", fmt::join(names, ", ")));
}

std::pair<std::size_t, std::size_t> correlated_pair(TableReader& table, const StudyPlan& plan) {
  const auto names = table.at("factors").texts();
  if (names.size() != 2 || names[0] == names[1])
    table.fail("factors", "is not a pair, needed: [\"NAME\", \"NAME\"], the names of two factors");
  return {sampled_factor(table, plan, names[0]), sampled_factor(table, plan, names[1])};
}

}  // namespace

std::vector<std::string> read_overrides(TableReader& table) {
  std::vector<std::string> overrides = table.at("set").texts();
  for (const auto& path : table.at("unset").texts()) overrides.push_back(std::string(unset_prefix) + path);
  return overrides;
}

void refuse_perturbation(TableReader& table, const char* key, const std::vector<std::string>& overrides) {
  for (const auto& text : overrides)
    if (text.starts_with("membrane.perturbation"))
      table.fail(key, fmt::format("has \"{}\", but seeds set the perturbation (amplitude)", text));
}

void read_factors(TableReader& root, StudyPlan& plan) {
  std::set<std::string> names;
  for (auto& table : root.tables("factor")) {
    table.allow_only({"deviation_factor", "distribution", "high", "key", "level", "low", "mean", "median",
                      "mode", "name", "range", "scale", "standard_deviation", "values"});
    plan.factors.push_back(read_factor(table, plan.seeds));
    if (!names.insert(plan.factors.back().name).second)
      table.fail("name", fmt::format("is \"{}\", which is another factor already", plan.factors.back().name));
    require_own_keys(table, plan.factors);
    std::set<std::string> levels;
    for (const auto& level : plan.factors.back().levels)
      if (!levels.insert(level.name).second)
        table.fail("", fmt::format("has the level \"{}\" twice", level.name));
  }
}

void read_correlations(TableReader& root, StudyPlan& plan) {
  constexpr Bounds coefficient{-0.999, 0.999, false, "-0.999 to 0.999"};
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (auto& table : root.tables("correlation")) {
    table.allow_only({"coefficient", "factors", "of"});
    const auto [a, b] = correlated_pair(table, plan);
    const double given = table.at("coefficient").number(coefficient);
    const bool of_ranks =
        table.at("of").choice<bool>({{"normal_scores", false}, {"ranks", true}}, "normal_scores");
    table.finish();
    if (!plan.correlation) plan.correlation.emplace(plan.factors.size());
    if (!pairs.insert(std::minmax(a, b)).second)
      table.fail("factors", fmt::format("has {} and {}, which have a correlation already",
                                        plan.factors[a].name, plan.factors[b].name));
    plan.correlation->set(a, b, of_ranks ? coefficient_from_ranks(given) : given);
  }
  if (plan.correlation && !plan.correlation->factorise())
    root.fail("correlation",
              "has coefficients that no factors have all together: use values nearer to 0, or "
              "name the pairs that are left out");
}

}  // namespace driver
