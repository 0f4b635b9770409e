// SPDX-License-Identifier: Apache-2.0
// Pictures of a sampled design: a panel for each factor, and the fitted surface over pairs of factors.
#include <fmt/format.h>

#include <algorithm>

#include "picture_panels.hpp"
#include "results/gnuplot.hpp"
#include "study_pictures.hpp"
#include "study_plan.hpp"

namespace driver {
namespace {

constexpr std::size_t most_panels = 24;

// A logarithmic scale that spans less than a decade would have a single tic.
std::string axis(const char* letter, const StudyFactor& factor, const std::optional<FactorScale>& scale) {
  constexpr double decade = 2.3;
  const bool is_logarithmic = scale && scale->logarithmic && scale->high - scale->low > decade;
  return fmt::format("{0} logscale {1}\nset {1}label {2}\n", is_logarithmic ? "set" : "unset", letter,
                     gnuplot_text(factor.name));
}

std::string rows_of_points(const StudyPlan& plan, const std::vector<std::optional<double>>& means,
                           std::size_t f) {
  std::string rows;
  for (std::size_t p = 0; p < means.size(); ++p)
    if (means[p] && is_sample(plan, p)) rows += fmt::format("{} {}\n", plan.points[p][f], *means[p]);
  return rows;
}

std::string rows_of_trend(const FactorScale& scale, const Trend& trend) {
  constexpr int steps = 40;
  std::string rows;
  for (int i = 0; i <= steps; ++i) {
    const double x = scale.value(2.0 * i / steps - 1.0);
    rows += fmt::format("{} {}\n", x, trend.at(x));
  }
  return rows;
}

// Over two factors, or one twice: a row of gnuplot's for each place.
std::string rows_of_surface(const ResponseSurface& surface, std::size_t factors, std::size_t a, std::size_t b,
                            const FactorScale& of_a, const FactorScale& of_b) {
  constexpr int steps = 20;
  std::string rows;
  std::vector<double> point(factors, 0.0);
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      point[a] = 2.0 * i / steps - 1.0, point[b] = 2.0 * j / steps - 1.0;
      rows += fmt::format("{} {} {}\n", of_a.value(point[a]), of_b.value(point[b]), surface.at(point));
    }
    rows += '\n';
  }
  return rows;
}

}  // namespace

StudyPicture trends_picture(const StudyPlan& plan, const RunJournal::Runs& runs, const SpreadTable& table) {
  if (plan.points.size() * plan.quantities.size() * plan.factors.size() > most_marks)
    return {{}, fmt::format("more than {} points in all panels", most_marks)};
  if (plan.quantities.size() * plan.factors.size() > 2 * most_panels)
    return {{}, fmt::format("more than {} panels", 2 * most_panels)};
  std::string blocks, panels;
  Panels all;
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto means = point_means(plan, runs, q);
    for (std::size_t f = 0; f < plan.factors.size(); ++f) {
      const std::string rows = rows_of_points(plan, means, f);
      if (rows.empty()) continue;
      blocks += gnuplot_block(fmt::format("means_{}_{}", q, f), rows);
      std::vector<std::string> plots{
          fmt::format("$means_{}_{} with points pointtype 7 pointsize 0.35 linecolor rgb '#56b4e9'", q, f)};
      const auto scale = scale_of(plan, f);
      if (const auto& trend = table[q].trends[f]; trend && scale) {
        blocks += gnuplot_block(fmt::format("trend_{}_{}", q, f), rows_of_trend(*scale, *trend));
        plots.push_back(fmt::format("$trend_{}_{} with lines linestyle 2 dashtype 1", q, f));
      }
      panels += axis("x", plan.factors[f], scale) + panel(plan.quantities[q], plots);
      ++all.count;
    }
  }
  if (all.count == 0) return {{}, "no means"};
  all.columns = all.count > 1 ? 2 : 1;
  return {"# Means of the points, and their trend over each factor.\n" + blocks +
              open_panels("means", all, "set offsets graph 0.04, graph 0.04, graph 0.06, graph 0.06\n") +
              panels,
          {}};
}

StudyPicture surface_picture(const StudyPlan& plan, const RunJournal::Runs& runs) {
  const std::size_t factors = plan.factors.size(), pairs = factors * (factors - 1) / 2;
  if (pairs == 0) return {{}, "a surface needs two factors or more"};
  if (pairs * plan.quantities.size() > most_panels)
    return {{},
            fmt::format("more than {} panels: {} pairs of factors, {} quantities", most_panels, pairs,
                        plan.quantities.size())};
  std::string blocks, panels;
  Panels all;
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto surface = surface_of(plan, runs, q);
    for (std::size_t a = 0; surface && a < factors; ++a)
      for (std::size_t b = a + 1; b < factors; ++b) {
        const auto of_a = scale_of(plan, a), of_b = scale_of(plan, b);
        const std::string name = fmt::format("surface_{}_{}_{}", q, a, b);
        blocks += gnuplot_block(name, rows_of_surface(*surface, factors, a, b, *of_a, *of_b));
        panels += axis("x", plan.factors[a], of_a) + axis("y", plan.factors[b], of_b) +
                  fmt::format("set title {}\nsplot ${} with pm3d\n", gnuplot_text(plan.quantities[q]), name);
        ++all.count;
      }
  }
  if (all.count == 0) return {{}, "no surface"};
  all.columns = all.count > 1 ? 2 : 1;
  all.height = 260;
  all.right = 90;
  all.left = 100;
  return {"# The fitted surface over pairs of factors, the others in the middle of their scales.\n" + blocks +
              open_panels(
                  "surface", all,
                  "set view map\nset pm3d corners2color mean\nset colorbox\nset palette defined (0 "
                  "'#0072b2', 0.5 '#f7f7f7', 1 '#d55e00')\nset autoscale fix\nset xlabel offset 0,-0.3\n") +
              panels,
          {}};
}

}  // namespace driver
