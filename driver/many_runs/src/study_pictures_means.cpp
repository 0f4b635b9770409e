// SPDX-License-Identifier: Apache-2.0
// The picture of means.csv: a panel for each quantity.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "picture_panels.hpp"
#include "results/gnuplot.hpp"
#include "study_pictures.hpp"
#include "study_plan.hpp"

namespace driver {
namespace {

// Points that one line or one cloud shows.
struct Series {
  std::vector<std::string> names;  // of the lines; none: one cloud
  std::vector<std::vector<std::size_t>> points;
};

bool varies(const StudyPlan& plan, std::size_t f) {
  return std::ranges::any_of(plan.points,
                             [&](const auto& point) { return point[f] != plan.points.front()[f]; });
}

// The first factor that has numbers at all points.
std::optional<std::size_t> numbered_factor(const StudyPlan& plan) {
  for (std::size_t f = 0; f < plan.factors.size(); ++f)
    if (varies(plan, f) && std::ranges::all_of(plan.points, [&](const auto& point) {
          return plan.factors[f].number_of(point[f]).has_value();
        }))
      return f;
  return std::nullopt;
}

// A line for each set of levels of the other factors, if these are few; else all points.
Series series_of(const StudyPlan& plan, std::optional<std::size_t> x) {
  std::map<StudyPoint, std::vector<std::size_t>> groups;
  for (std::size_t p = 0; x && p < plan.points.size(); ++p) {
    StudyPoint others = plan.points[p];
    others[*x] = 0.0;
    groups[others].push_back(p);
  }
  Series series;
  if (groups.empty() || groups.size() > most_lines || groups.size() == plan.points.size()) {
    series.points.resize(1);
    for (std::size_t p = 0; p < plan.points.size(); ++p) series.points.front().push_back(p);
    return series;
  }
  for (auto& [others, points] : groups) {
    std::vector<std::string> names;
    for (std::size_t f = 0; f < others.size(); ++f)
      if (f != *x && varies(plan, f)) names.push_back(plan.factors[f].name_of(others[f]));
    series.names.push_back(fmt::format("{}", fmt::join(names, ", ")));
    series.points.push_back(std::move(points));
    std::ranges::sort(series.points.back(), {},
                      [&](std::size_t p) { return plan.factors[*x].number_of(plan.points[p][*x]); });
  }
  return series;
}

bool spans_decades(const StudyPlan& plan, std::size_t x) {
  const auto number = [&](const StudyPoint& point) { return *plan.factors[x].number_of(point[x]); };
  const auto [low, high] = std::ranges::minmax_element(plan.points, {}, number);
  return plan.factors[x].logarithmic || (number(*low) > 0.0 && number(*high) >= 100.0 * number(*low));
}

// Points without a number have rows with their names, if these are few.
bool has_rows(const StudyPlan& plan, std::optional<std::size_t> x) {
  constexpr std::size_t most_rows = 30;
  return !x && !plan.factors.empty() && plan.points.size() <= most_rows;
}

std::string axes_of_means(const StudyPlan& plan, std::optional<std::size_t> x, Panels& all) {
  const std::string margins = "set offsets graph 0.04, graph 0.04, graph 0.06, graph 0.06\n";
  all.columns = all.count > 1 ? 2 : 1;
  if (x)
    return margins + fmt::format("set xlabel {}\n{}", gnuplot_text(plan.factors[*x].name),
                                 spans_decades(plan, *x) ? "set logscale x\n" : "");
  if (!has_rows(plan, x)) return margins + "set xlabel 'point'\n";
  std::vector<std::string> names;
  for (const auto& point : plan.points)
    names.push_back(fmt::format("{}", fmt::join(level_names(plan, point), ", ")));
  return named_rows(all, names) + "set offsets graph 0.04, graph 0.04, 0, 0\n";
}

std::string rows_of_means(const StudyPlan& plan, const RunJournal::Runs& runs, std::optional<std::size_t> x,
                          const std::vector<std::size_t>& points, std::size_t quantity) {
  std::string rows;
  for (const std::size_t p : points) {
    const Statistics s = statistics_at(plan, runs, p, quantity);
    if (s.count == 0) continue;
    const double place = x ? *plan.factors[*x].number_of(plan.points[p][*x]) : static_cast<double>(p);
    rows += fmt::format("{} {} {}\n", place, s.mean, s.count > 1 ? s.standard_error : 0.0);
  }
  return rows;
}

}  // namespace

StudyPicture means_picture(const StudyPlan& plan, const RunJournal::Runs& runs) {
  if (plan.points.size() * plan.quantities.size() > most_marks)
    return {{}, fmt::format("more than {} means", most_marks)};
  const auto x = numbered_factor(plan);
  const Series series = series_of(plan, x);
  const char* columns = has_rows(plan, x)      ? "2:1:3 with xerrorbars"
                        : series.names.empty() ? "1:2:3 with yerrorbars"
                                               : "1:2:3 with yerrorlines";
  std::string blocks, panels;
  Panels all;
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    std::vector<std::string> plots;
    const bool is_named = all.count == 0 && !series.names.empty();
    for (std::size_t s = 0; s < series.points.size(); ++s) {
      const std::string rows = rows_of_means(plan, runs, x, series.points[s], q);
      if (rows.empty()) continue;
      blocks += gnuplot_block(fmt::format("means_{}_{}", q, s), rows);
      plots.push_back(fmt::format("$means_{}_{} using {} linestyle {} {}", q, s, columns, s + 1,
                                  is_named ? "title " + gnuplot_text(series.names[s]) : "notitle"));
    }
    if (plots.empty()) continue;
    panels += panel(plan.quantities[q], plots);
    ++all.count;
  }
  if (all.count == 0) return {{}, "no means"};
  std::string settings = axes_of_means(plan, x, all);
  if (!series.names.empty()) settings += key_above(all, series.names.size());
  return {"# Means with their standard errors.\n" + blocks + open_panels("means", all, settings) + panels,
          {}};
}

}  // namespace driver
