// SPDX-License-Identifier: Apache-2.0
#include "sampled.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace driver {
namespace {

// Polynomial through samples first .. first + count - 1.
double lagrange(std::span<const double> time, std::span<const double> values, std::size_t first,
                std::size_t count, double t) {
  double sum = 0.0;
  for (std::size_t i = first; i < first + count; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < first + count; ++j)
      if (j != i) weight *= (t - time[j]) / (time[i] - time[j]);
    sum += weight * values[i];
  }
  return sum;
}

}  // namespace

Sample interpolate(std::span<const double> time, std::span<const double> values, double t) {
  if (t <= time.front()) return {values.front(), 0.0};
  if (t >= time.back()) return {values.back(), 0.0};
  const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  const std::size_t below = above - 1;
  if (t == time[below]) return {values[below], 0.0};
  const double share = (t - time[below]) / (time[above] - time[below]);
  const double linear = values[below] + share * (values[above] - values[below]);
  const std::size_t count = std::min<std::size_t>(4, time.size());
  const std::size_t first = std::min(below > 0 ? below - 1 : 0, time.size() - count);
  return {linear, 2.0 * std::abs(lagrange(time, values, first, count, t) - linear)};
}

double root_mean_square(std::span<const double> time, std::span<const double> values) {
  if (values.size() == 1) return std::abs(values[0]);
  double sum = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i)
    sum += 0.5 * (time[i] - time[i - 1]) * (values[i] * values[i] + values[i - 1] * values[i - 1]);
  return std::sqrt(sum / (time.back() - time.front()));
}

}  // namespace driver
