// SPDX-License-Identifier: Apache-2.0
#include "many_runs/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>

namespace driver {

Statistics statistics(const std::vector<double>& values) {
  Statistics s;
  s.count = static_cast<int>(values.size());
  if (values.empty()) return s;
  const double n = static_cast<double>(values.size());
  for (const double v : values) s.mean += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.standard_error = values.size() > 1 ? std::sqrt(squares / (n - 1.0) / n) : 0.0;
  s.minimum = *std::min_element(values.begin(), values.end());
  s.maximum = *std::max_element(values.begin(), values.end());
  return s;
}

bool means_differ(std::span<const Statistics> means, double rounding) {
  for (const Statistics& a : means)
    for (const Statistics& b : means)
      if (a.mean - b.mean > std::max(rounding, 2.0 * elementary::hypot(a.standard_error, b.standard_error)))
        return true;
  return false;
}

std::optional<MeanRange> mean_with_left_out(const Statistics& s, int left_out) {
  if (s.count == 0 || (s.count == 1 && left_out > 0)) return std::nullopt;
  const double share = left_out / (static_cast<double>(s.count) + left_out);
  return MeanRange{s.mean - share * (s.mean - s.minimum), s.mean + share * (s.maximum - s.mean)};
}

}  // namespace driver
