// SPDX-License-Identifier: Apache-2.0
#include "phase_lag.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sampled.hpp"

namespace driver {
namespace {

constexpr int kPoints = 400;  // points of the common grid; a quarter of it is searched on either side

std::vector<double> on_grid(std::span<const double> time, std::span<const double> values) {
  std::vector<double> grid;
  const double span = time.back() - time.front();
  for (int i = 0; i <= kPoints; ++i)
    grid.push_back(interpolate(time, values, time.front() + span * i / kPoints).value);
  return grid;
}

bool changes(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low >
         1e-9 * std::max(std::abs(*low), std::abs(*high));  // larger than a decimal file's round-off
}

// Mean square distance when mine is taken `shift` cells later; linear between grid points.
double distance(const std::vector<double>& mine, const std::vector<double>& reference, double shift) {
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = i + shift;
    if (x < 0.0 || x > kPoints) continue;
    const auto below = static_cast<std::size_t>(std::min(std::floor(x), kPoints - 1.0));
    const double part = x - static_cast<double>(below);
    const double off =
        mine[below] + part * (mine[below + 1] - mine[below]) - reference[static_cast<std::size_t>(i)];
    sum += off * off;
    ++count;
  }
  return sum / count;
}

}  // namespace

std::optional<double> phase_lag(std::span<const double> time, std::span<const double> mine,
                                std::span<const double> reference) {
  if (time.size() < 8) return std::nullopt;
  const auto a = on_grid(time, mine), b = on_grid(time, reference);
  if (!changes(a) || !changes(b)) return std::nullopt;
  constexpr int most = kPoints / 4;
  int best = 0;
  double least = distance(a, b, 0.0);
  for (int magnitude = 1; magnitude <= most; ++magnitude)  // for equal distances, the smallest shift
    for (const int shift : {magnitude, -magnitude})
      if (const double d = distance(a, b, shift); d < least) least = d, best = shift;
  if (std::abs(best) == most) return std::nullopt;
  double low = best - 1.0, high = best + 1.0;
  for (int i = 0; i < 60; ++i) {  // ternary search: within one cell the mean square is close to a parabola
    const double third = (high - low) / 3.0;
    (distance(a, b, low + third) <= distance(a, b, high - third) ? high -= third : low += third);
  }
  const double shift = 0.5 * (low + high);
  constexpr double found_to = 1e-8;  // in cells; the root of eps, within which a least square is flat
  return std::abs(shift) < found_to ? 0.0 : shift * (time.back() - time.front()) / kPoints;
}

}  // namespace driver
