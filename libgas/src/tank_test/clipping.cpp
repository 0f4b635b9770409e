// SPDX-License-Identifier: Apache-2.0
#include "clipping.hpp"

#include <algorithm>

namespace gas {
namespace {

constexpr std::ptrdiff_t kFewest = 5;  // equal largest readings
// Least ratio of their number to that of the next lower reading. At a smooth peak the time above a level
// grows with the root of its depth, so the ratio is at most 1/(sqrt 2 - 1) = 2.4.
constexpr std::ptrdiff_t kPiled = 4;
constexpr double kComesToRest = 0.15;  // share of the steepest rise; with a gauge of 200 steps the rise at a
                                       // peak is 0.08 of it

/// Largest rise [Pa] of the readings over `span` of them.
double steepest(std::span<const double> readings, std::size_t span) {
  double rise = 0.0;
  for (std::size_t i = span; i < readings.size(); ++i)
    rise = std::max(rise, readings[i] - readings[i - span]);
  return rise;
}

/// A value next to others, and how many readings equal it.
struct Level {
  double value;
  std::ptrdiff_t count;
};

/// The largest reading below `top`, or the smallest of all.
Level next_below(std::span<const double> readings, double top) {
  double next = *std::ranges::min_element(readings);
  for (const double reading : readings)
    if (reading < top) next = std::max(next, reading);
  return {next, std::ranges::count(readings, next)};
}

/// True if the readings come to rest at the largest one: they never fall by more than the last step (their
/// resolution), and rise slowly over the last two steps.
bool rests(std::span<const double> readings, double top, const Level& next) {
  const double step = top - next.value;
  for (std::size_t i = 1; i < readings.size(); ++i)
    if (readings[i] < readings[i - 1] - step) return false;
  const Level lower = next_below(readings, next.value);
  return readings.back() >= next.value &&
         top - lower.value <
             kComesToRest * steepest(readings, static_cast<std::size_t>(next.count + lower.count));
}

}  // namespace

std::optional<Clipping> find_clipping(std::span<const double> times, std::span<const double> readings) {
  const double top = *std::ranges::max_element(readings);
  const std::ptrdiff_t count = std::ranges::count(readings, top);
  if (count < kFewest || count == std::ssize(readings)) return {};
  const Level next = next_below(readings, top);
  if (count <= kPiled * next.count) return {};
  const auto first = static_cast<std::size_t>(std::ranges::find(readings, top) - readings.begin());
  if (rests(readings, top, next)) return {};
  std::size_t last = readings.size() - 1;
  while (readings[last] < top) --last;
  return Clipping{top, times[first], times[last], count};
}

}  // namespace gas
