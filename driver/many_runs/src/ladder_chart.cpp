// SPDX-License-Identifier: Apache-2.0
// The chart of a ladder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "many_runs/ladder.hpp"
#include "results/gnuplot.hpp"
#include "results/results.hpp"
#include "results/unit_endings.hpp"

namespace driver {
namespace {

// Data blocks $rungs (cost, error, low, high), $front (cost, error, place), $named (cost, error) and the
// numbers `tolerance` and `uncertainty` stand before it; errors in per cent of the reference.
constexpr std::string_view commands = R"(set logscale xy
set format xy '%g'
set rmargin 36
set offsets graph 0.05, graph 0.05, 0, 0
set xlabel 'CPU time of a run [s]'
set label 1 'none is cheaper and as good:' at graph 1.03, graph 0.98
set label 2 list at graph 1.03, graph 0.92 font ',11'
set key bottom left at graph 1.03, graph 0.02 Left reverse samplen 2 font ',11'
set style fill solid 1 noborder
plot (uncertainty > 0 ? uncertainty : NaN) with filledcurves y1=1e-30 fillcolor rgb '#dddddd' \
    title 'uncertainty of the reference', \
  tolerance with lines linecolor rgb '#222222' linewidth 1.6 dashtype 2 title 'tolerance', \
  $rungs using 1:2:3:4 with yerrorbars linecolor rgb '#767676' pointtype 6 title 'rung, ± 2 s.e.', \
  $front using 1:2 with points linecolor rgb '#0072b2' pointtype 7 title 'none is cheaper and as good', \
  $named using 1:2 with points linecolor rgb '#d55e00' linewidth 2 pointtype 6 pointsize 2 \
    title 'the cheapest within the tolerance', \
  $front using 1:2:3 with labels textcolor rgb '#0072b2' offset 1.2,0.8 font ',11' notitle
)";

// "peak_pressure_Pa" as "peak pressure": errors are shares of it, without a unit.
std::string in_words(const std::string& quantity) {
  std::string words = without_unit(quantity);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string chart(const LadderResult& result, const LadderOptions& options) {
  const double percent = 100.0 / std::abs(result.reference.value - result.zero),
               floor = 100.0 * least_share * options.tolerance;
  const auto shown = [&](double error) { return std::max(percent * error, floor); };
  std::string rungs, front, named;
  std::vector<std::string> names(result.rungs.size());
  for (const LadderRung& rung : result.rungs) {
    if (rung.verdict == Verdict::not_judged) continue;
    const double error = std::abs(rung.error), bar = 2.0 * rung.standard_error;
    const std::string point = fmt::format("{} {}", rung.cpu_seconds, shown(error));
    rungs += fmt::format("{} {} {}\n", point, shown(error - bar), shown(error + bar));
    if (result.cheapest && &rung == &result.rungs[*result.cheapest]) named = point + '\n';
    if (rung.front == 0) continue;
    front += fmt::format("{} {}\n", point, rung.front);
    names[static_cast<std::size_t>(rung.front) - 1] = fmt::format("{}  {}", rung.front, rung.name);
  }
  std::string list = "''";
  for (const std::string& name : names)
    if (!name.empty()) list += " . " + gnuplot_text(name) + " . \"\\n\"";
  // Where it is not known it fills nothing: all would be grey.
  const double uncertainty =
      std::isfinite(result.reference.uncertainty) ? percent * result.reference.uncertainty : 0.0;
  return fmt::format(
             "# Error against CPU time of the rungs of a ladder; filled: the front, than which nothing "
             "cheaper is as "
             "exact.\n# Errors below {1:g} of the tolerance are drawn there. `gnuplot ladder.gp` draws "
             "ladder.svg.\n"
             "tolerance = {2}\nuncertainty = {3}\nlist = {4}\nset ylabel {0}\n",
             gnuplot_text(fmt::format("Error of {} [%]", in_words(result.quantity))), least_share,
             100.0 * options.tolerance, uncertainty, list) +
         gnuplot_block("rungs", rungs) + gnuplot_block("front", front) + gnuplot_block("named", named) +
         gnuplot_head("ladder", 900, 560) + std::string(commands);
}

}  // namespace

std::string draw_ladder(ResultFolder& folder, const LadderResult& result, const LadderOptions& options) {
  const std::string problem = draw_picture(folder, "ladder", chart(result, options));
  if (problem.empty()) return {};
  return fmt::format("{}; its commands are in {}", problem, (folder.path() / "ladder.gp").string());
}

}  // namespace driver
