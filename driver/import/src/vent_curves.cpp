// SPDX-License-Identifier: Apache-2.0
#include "vent_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace driver::imported {

void not_below_zero(Knots& knots, const std::string& key, ImportReport& report) {
  double least = 0.0;
  for (auto& knot : knots) {
    least = std::min(least, knot[1]);
    knot[1] = std::max(knot[1], 0.0);
  }
  if (least < 0.0)
    report.note(fmt::format("{}: values down to {:.3g} are set to 0, the least allowed", key, least));
}

double value_at(const Knots& knots, double x) {
  if (x < knots.front()[0]) return knots.front()[1];
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto& [x0, y0] = knots[i - 1];
    const auto& [x1, y1] = knots[i];
    if (x < x1) return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return knots.back()[1];
}

void from_rest(Knots& knots) {
  const double at_rest = value_at(knots, 0.0);
  std::erase_if(knots, [](const auto& knot) { return knot[0] <= 0.0; });
  knots.insert(knots.begin(), {0.0, at_rest});
}

Knots flow_of_mass(const Knots& mass, double moment) {
  Knots flow;
  const double at_once = value_at(mass, 0.0);
  if (at_once > 0.0) flow = {{0.0, at_once / moment}, {moment, at_once / moment}};
  for (std::size_t i = 1; i < mass.size(); ++i) {
    const double span = mass[i][0] - mass[i - 1][0];
    if (!(span > 0.0) || mass[i][0] <= 0.0) continue;
    const double rate = (mass[i][1] - mass[i - 1][1]) / span, from = std::max(mass[i - 1][0], 0.0);
    flow.push_back({std::max(from, at_once > 0.0 ? moment : 0.0), rate});
    flow.push_back({mass[i][0], rate});
  }
  return flow;
}

void extend_to(Knots& knots, double end) {
  if (knots.size() < 2 || knots.back()[0] >= end) return;
  const auto& [x0, y0] = knots[knots.size() - 2];
  const auto& [x1, y1] = knots.back();
  const double slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0.0;
  knots.push_back({end, y1 + slope * (end - x1)});
}

}  // namespace driver::imported
