// SPDX-License-Identifier: Apache-2.0
#include "filtered.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "engine/channel_filter.hpp"

namespace driver {

// The rows need a sampling rate of ten times the class, as SAE J211 requires.
Filtered filtered_as(const History& reference, const History& mine) {
  Filtered result;
  const auto *first = mine.find("pendulum_cg_tangential_m_s2"),
             *second = mine.find("pendulum_cg_radial_m_s2");
  if (!first || !second || mine.runs > 1) return result;
  double widest = 0.0;
  for (std::size_t i = 1; i < mine.time.size(); ++i)
    widest = std::max(widest, mine.time[i] - mine.time[i - 1]);
  for (const int channel_class : channel_classes) {
    const std::string name = filtered_column(channel_class);
    if (mine.find(name) || !reference.find(name)) continue;
    if (widest > widest_interval(channel_class) * (1.0 + 1e-12))
      result.too_coarse[name] =
          fmt::format("mine has rows {} s apart, CFC {} needs {:.3g} s or less",
                      digits_beside(widest, widest_interval(channel_class)), channel_class,
                      three_digits_below(widest_interval(channel_class)));
    else
      result.columns.columns.emplace_back(name,
                                          filtered_resultant({mine.time, *first, *second}, channel_class));
  }
  return result;
}

}  // namespace driver
