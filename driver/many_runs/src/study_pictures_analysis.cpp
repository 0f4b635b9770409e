// SPDX-License-Identifier: Apache-2.0
// Pictures of sobol.csv and convergence.csv: a panel for each quantity.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "picture_panels.hpp"
#include "results/gnuplot.hpp"
#include "study_pictures.hpp"

namespace driver {
namespace {

// Of each factor: its number, then both shares, each with its interval. `most` becomes the greatest of all.
std::string rows_of_shares(const std::vector<SobolIndex>& list, double& most) {
  std::string rows;
  for (std::size_t f = 0; f < list.size(); ++f) {
    rows += std::to_string(f);
    for (const Estimate& share : {list[f].first_order, list[f].total}) {
      rows += fmt::format(" {} {} {}", share.value, share.low, share.high);
      most = std::max(most, share.high);
    }
    rows += '\n';
  }
  return rows;
}

// Two bars a factor; with their names if `is_named`.
std::vector<std::string> plots_of_shares(std::size_t q, bool is_named) {
  std::vector<std::string> plots;
  const auto bar = [&](int column, const char* low, const char* high, const char* colour, const char* of) {
    plots.push_back(
        fmt::format("$shares_{} using {}:1:(0):{}:($1{}):($1{}) with boxxyerror fillcolor rgb {} {}", q,
                    column, column, low, high, colour, is_named ? "title " + gnuplot_text(of) : "notitle"));
  };
  const auto interval = [&](int column, const char* place) {
    plots.push_back(
        fmt::format("$shares_{} using {}:($1{}):{}:{} with xerrorbars pointtype 0 linecolor rgb '#222222'", q,
                    column, place, column + 1, column + 2));
  };
  bar(2, "-0.36", "-0.02", "'#0072b2'", "of the factor alone");
  bar(5, "+0.02", "+0.36", "'#b9d9ec'", "with all others");
  interval(2, "-0.19");
  interval(5, "+0.19");
  return plots;
}

// What is off the limit at each size, and the line of the fit.
std::string blocks_of_fit(const SizeFit& one, std::size_t number) {
  std::string rows, line;
  for (std::size_t k = 0; k < one.sizes.size(); ++k)
    if (const double error = std::abs(one.means[k] - one.fit->limit); error > 0.0)
      rows += fmt::format("{} {}\n", one.sizes[k], error);
  const auto [low, high] = std::ranges::minmax(one.sizes);
  for (const double size : {low, high})
    line +=
        fmt::format("{} {}\n", size, std::abs(one.fit->coefficient) * elementary::pow(size, one.fit->order));
  return gnuplot_block(fmt::format("errors_{}", number), rows) +
         gnuplot_block(fmt::format("fit_{}", number), line);
}

std::string name_of_fit(const SizeFit& one) {
  std::vector<std::string> names{one.others};
  std::erase(names, "");
  names.push_back(fmt::format("order {:.3g}", one.fit->order));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string settings_of_sizes(const StudyFactor& size) {
  constexpr double room = 1.25;
  constexpr std::size_t most_tics = 8;
  std::vector<std::string> names;
  std::vector<double> places;
  for (const auto& level : size.levels) names.push_back(level.name), places.push_back(*level.number);
  const auto [low, high] = std::ranges::minmax(places);
  return fmt::format(
             "set logscale xy\nset xrange [{}:{}]\nset xlabel {}\nset ylabel 'distance from the limit'\n",
             low / room, high * room, gnuplot_text(size.name)) +
         "set key bottom right Left reverse\n" +
         (names.size() <= most_tics ? named_tics("xtics", names, places) : "");
}

}  // namespace

StudyPicture sobol_picture(const StudyPlan& plan, const SobolTable& table) {
  std::vector<std::string> names;
  for (const auto& factor : plan.factors) names.push_back(factor.name);
  std::string blocks, panels;
  Panels all;
  double most = 1.0;
  for (std::size_t q = 0; q < table.size(); ++q) {
    const std::string rows = rows_of_shares(table[q], most);
    if (rows.empty()) continue;
    blocks += gnuplot_block(fmt::format("shares_{}", q), rows);
    panels += panel(plan.quantities[q], plots_of_shares(q, all.count == 0));
    ++all.count;
  }
  if (all.count == 0) return {{}, "no indices"};
  const std::string settings =
      fmt::format("set xlabel 'share of the variance, 95 % interval'\nset xrange [*<0:{}]\n", most) +
      named_rows(all, names) + key_above(all, 2);
  return {"# Sobol indices.\n" + blocks + open_panels("sobol", all, settings) + panels, {}};
}

StudyPicture convergence_picture(const StudyPlan& plan, const std::vector<SizeFit>& fits) {
  if (fits.size() > most_marks) return {{}, fmt::format("more than {} fits", most_marks)};
  std::string blocks, panels;
  Panels all;
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    std::vector<std::string> plots;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < fits.size(); ++i) {
      const SizeFit& one = fits[i];
      if (one.quantity != q || !one.fit) continue;
      blocks += blocks_of_fit(one, i);
      const std::size_t style = lines++ % most_lines + 1;
      plots.push_back(fmt::format("$fit_{} with lines linestyle {}", i, style));
      plots.push_back(
          fmt::format("$errors_{} with points linestyle {} {}", i, style,
                      lines > most_lines ? "notitle" : "title " + gnuplot_text(name_of_fit(one))));
    }
    if (plots.empty()) continue;
    panels += panel(plan.quantities[q], plots);
    ++all.count;
  }
  if (all.count == 0) return {{}, "no fits"};
  all.columns = all.count > 1 ? 2 : 1;
  all.height = 260;
  const std::string settings = settings_of_sizes(plan.factors[*plan.analysis.convergence]);
  return {"# Means less the limit of their fit, and the fit.\n" + blocks +
              open_panels("convergence", all, settings) + panels,
          {}};
}

}  // namespace driver
