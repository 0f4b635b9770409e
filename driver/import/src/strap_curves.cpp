// SPDX-License-Identifier: Apache-2.0
#include "strap_curves.hpp"

#include <algorithm>
#include <cmath>

namespace driver::imported {

StrapLaw strap_law(const Knots& force, Place at) {
  const auto& [last_x, last_y] = force.back();
  std::size_t first = force.size();
  for (std::size_t i = force.size(); i-- > 0 && force[i][1] > 0.0;) first = i;
  if (first == force.size() || first == 0)
    throw DeckFault(at, "the spring's force does not rise from 0 or below to above 0");
  const auto& [x0, y0] = force[first - 1];
  const auto& [x1, y1] = force[first];
  StrapLaw law;
  law.slack = x0 - y0 * (x1 - x0) / (y1 - y0);
  if (!(last_x > law.slack)) throw DeckFault(at, "the spring's force jumps");
  law.stiffness = last_y / (last_x - law.slack);
  for (const auto& [x, y] : force)
    law.misfit = std::max(law.misfit, std::abs(std::max(0.0, law.stiffness * (x - law.slack)) - y) / last_y);
  constexpr double rounding = 1e-9;
  if (law.misfit < rounding) law.misfit = 0.0;
  return law;
}

}  // namespace driver::imported
