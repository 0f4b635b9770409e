// SPDX-License-Identifier: Apache-2.0
#include "readings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "require.hpp"

namespace gas {
namespace {

constexpr double kSmallestShare = 1e-6;  // share of the largest reading
constexpr std::size_t kWeightReach = 4;  // readings on each side that enter the mean of a weight

}  // namespace

void check_readings(std::span<const double> times, std::span<const double> readings, std::string_view name,
                    Noise noise) {
  require(noise == Noise::of_reading || noise == Noise::of_full_scale, "noise", static_cast<double>(noise),
          "must be one of its enumerators");
  require(times.size() >= SmoothingSpline::kFewestReadings, "number of readings",
          static_cast<double>(times.size()), "20 or more are needed");
  require(readings.size() == times.size(), "number of readings", static_cast<double>(readings.size()),
          "must be one for each time");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1]))
      throw ReadingError("time", i, to_text(times[i]) + " s: must be finite and later than the time before");
    if (!std::isfinite(readings[i])) throw ReadingError(name, i, to_text(readings[i]) + ": must be finite");
    if (noise == Noise::of_reading && readings[i] <= 0.0)
      throw ReadingError(name, i, to_text(readings[i]) + ": must be above 0");
  }
  const double largest = *std::ranges::max_element(readings);
  require(largest > 0.0, name, largest, "the largest reading must be above 0");
  // Weights are inverse squares: a larger range leaves the normal equations no digits.
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (noise == Noise::of_reading && !(readings[i] >= kSmallestShare * largest))
      throw ReadingError(name, i, to_text(readings[i]) + ": must not be below a millionth of the largest");
  if (!std::isfinite(times.back() - times.front()))
    throw ReadingError("time", times.size() - 1, "the record is too long");
}

std::vector<double> root_weights(std::span<const double> readings, Noise noise) {
  std::vector<double> weights(readings.size(), 1.0 / *std::ranges::max_element(readings));
  if (noise == Noise::of_full_scale) return weights;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::size_t reach = std::min({kWeightReach, i, readings.size() - 1 - i});
    double sum = 0.0;
    for (std::size_t j = i - reach; j <= i + reach; ++j) sum += readings[j];
    weights[i] = static_cast<double>(2 * reach + 1) / sum;
  }
  return weights;
}

}  // namespace gas
