// SPDX-License-Identifier: Apache-2.0
// Prints proved bounds of a tank as CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/build_info.hpp"
#include "base/case_reader.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "enclosure_module.hpp"
#include "enclosure_scene.hpp"
#include "results/load_scene.hpp"
#include "time_list.hpp"

namespace driver::commands {
namespace {

/// The widest bounds, as a share of their value; of masses, of the gas and of what came in.
struct Widest {
  double share = 0.0, time = 0.0;
  std::string column;
};

Widest widest_of(const enclosure::Tube& tube) {
  Widest widest;
  for (const auto& moment : tube.moments) {
    double mass = 0.0;
    for (std::size_t c = 3; c < tube.columns.size(); ++c) mass = std::max(mass, moment.bounds[c].upper);
    for (std::size_t c = 0; c < tube.columns.size(); ++c) {
      const auto& b = moment.bounds[c];
      // A rounding of each end does not count as width.
      const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(b.upper);
      const double share = (b.upper - b.lower - rounding) / (c < 4 ? std::abs(b.upper) : mass);
      if (share > widest.share) widest = {share, moment.time, tube.columns[c]};
    }
  }
  return widest;
}

void print_csv(const EncloseArguments& a, const enclosure::Tube& tube, double laminar_share) {
  fmt::print("# gasjet: {} {}\n# case: {}\n# laminar_share: {}\n# width: {}\n# steps: {}\n# crossings: {}\n",
             build_info::version, build_info::commit, a.scene.file.string(), laminar_share, a.width,
             tube.steps, tube.crossings);
  for (const auto& text : a.scene.overrides) fmt::print("# set: {}\n", text);
  fmt::print("time_s");
  for (const auto& column : tube.columns) fmt::print(",{0}_lower,{0}_upper", column);
  for (const auto& moment : tube.moments) {
    fmt::print("\n{}", moment.time);
    for (const auto& b : moment.bounds) fmt::print(",{},{}", b.lower_text, b.upper_text);
  }
  fmt::print("\n");
}

}  // namespace

int enclose(const EncloseArguments& a) {
  CaseDocument document(a.scene.file, a.scene.overrides);
  const Scene scene = load_scene(document);
  enclosure::Request request{parse_times(a.times), a.width, a.longest};
  if (a.times.empty())
    for (int i = 0; i <= 10; ++i) request.times.push_back(scene.time.end * i / 10.0);
  enclosure::Scene tank = enclosure_scene(scene, std::max(scene.time.end, request.times.back()));
  if (a.literal) tank.laminar_share = 0.0;
  try {
    const enclosure::Tube tube = enclose_by_module(tank, request);
    print_csv(a, tube, tank.laminar_share);
    const Widest widest = widest_of(tube);
    if (!(widest.share > a.width)) return exit_done;
    tell(fmt::format(
        "gasjet: the bounds of {} at {:.6g} s are {:.3g} of the value apart, asked for: {:.3g}; a smaller "
        "--width takes shorter steps",
        widest.column, widest.time, widest.share, a.width));
    return exit_domain;
  } catch (const std::invalid_argument& error) {
    throw CaseError(error.what());
  }
}

}  // namespace driver::commands
