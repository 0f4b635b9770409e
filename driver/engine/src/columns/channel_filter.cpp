// SPDX-License-Identifier: Apache-2.0
#include "engine/channel_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>
#include <elementary/trigonometric.hpp>
#include <numbers>
#include <stdexcept>

namespace driver {
namespace {

// y_n = a0 x_n + a1 x_{n-1} + a2 x_{n-2} + b1 y_{n-1} + b2 y_{n-2}
struct TwoPole {
  double a0, a1, a2, b1, b2;
};

TwoPole two_pole(double interval, double channel_class) {
  // The bilinear transform's frequency is prewarped: the gain at f_c is exactly 1/sqrt(2) a pass.
  const double wa = elementary::tan(std::numbers::pi * channel_class * 2.0775 * interval);
  const double root = std::numbers::sqrt2 * wa, square = wa * wa, all = 1.0 + root + square;
  return {square / all, 2.0 * square / all, square / all, -2.0 * (square - 1.0) / all,
          (-1.0 + root - square) / all};
}

// In place, from the steady state of the first sample.
template <class Iterator>
void pass(const TwoPole& f, Iterator begin, Iterator end) {
  double x1 = *begin, x2 = x1, y1 = x1, y2 = x1;
  for (auto i = begin; i != end; ++i) {
    const double x = *i, y = f.a0 * x + f.a1 * x1 + f.a2 * x2 + f.b1 * y1 + f.b2 * y2;
    x2 = x1, x1 = x;
    y2 = y1, y1 = y;
    *i = y;
  }
}

std::vector<double> resample(const std::vector<double>& time, const std::vector<double>& value,
                             double interval) {
  std::vector<double> samples;
  std::size_t k = 0;
  for (double t = time.front(); t <= time.back();
       t = time.front() + interval * static_cast<double>(samples.size())) {
    while (k + 2 < time.size() && time[k + 1] < t) ++k;
    const double part = (t - time[k]) / (time[k + 1] - time[k]);
    samples.push_back(value[k] + part * (value[k + 1] - value[k]));
  }
  return samples;
}

}  // namespace

std::string filtered_column(int channel_class, bool of_pendulum) {
  return fmt::format("{}_cfc{}_m_s2", of_pendulum ? "pendulum_cg_acceleration" : "impactor_acceleration",
                     channel_class);
}

std::vector<double> channel_filter(std::span<const double> samples, double interval, double channel_class) {
  if (!(std::isfinite(channel_class) && channel_class > 0.0))
    throw std::invalid_argument(fmt::format("channel_class = {}: must be a number above 0", channel_class));
  if (!(interval > 0.0 && interval * channel_class <= 0.1))
    throw std::invalid_argument(
        fmt::format("interval = {} s: must be above 0, at most 1/(10 channel_class)", interval));
  std::vector<double> filtered(samples.begin(), samples.end());
  if (filtered.empty()) return filtered;
  const TwoPole coefficients = two_pole(interval, channel_class);
  pass(coefficients, filtered.begin(), filtered.end());
  pass(coefficients, filtered.rbegin(), filtered.rend());
  return filtered;
}

namespace {

constexpr double fine_interval = 1e-5;  // [s] twice as fine as the finest steps of a bag

std::vector<double> filtered_at_100_khz(const VectorSignal& signal, double channel_class) {
  const auto filtered = [&](const std::vector<double>& component) {
    return channel_filter(resample(signal.time, component, fine_interval), fine_interval, channel_class);
  };
  std::vector<double> first = filtered(signal.first);
  const std::vector<double> second = filtered(signal.second);
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = elementary::hypot(first[i], second[i]);
  if (signal.third.empty()) return first;
  const std::vector<double> third = filtered(signal.third);
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = elementary::hypot(first[i], third[i]);
  return first;
}

}  // namespace

double filtered_peak(const VectorSignal& signal, double channel_class) {
  if (signal.time.size() < 2) return 0.0;
  return std::ranges::max(filtered_at_100_khz(signal, channel_class));
}

std::vector<double> filtered_resultant(const VectorSignal& signal, double channel_class) {
  const std::vector<double> fine = filtered_at_100_khz(signal, channel_class);
  std::vector<double> values;
  for (const double t : signal.time) {
    const double place = (t - signal.time.front()) / fine_interval;
    values.push_back(fine[std::min(fine.size() - 1, static_cast<std::size_t>(std::lround(place)))]);
  }
  return values;
}

double head_injury_criterion(const VectorSignal& signal, double window) {
  if (signal.time.size() < 2) return 0.0;
  constexpr double g = 9.80665, class_of_head = 1000.0, interval = 1e-4;  // [m/s2] [Hz] [s]
  const std::vector<double> fine = filtered_at_100_khz(signal, class_of_head);
  // Change of velocity over g [s] up to each tenth sample, by trapezoids of all.
  constexpr std::size_t every = 10;
  std::vector<double> change{0.0};
  double sum = 0.0;
  for (std::size_t i = 1; i < fine.size(); ++i) {
    sum += 0.5 * (fine[i - 1] + fine[i]) * fine_interval / g;
    if (i % every == 0) change.push_back(sum);
  }
  const auto longest = static_cast<std::size_t>(std::lround(window / interval));
  double largest = 0.0;
  for (std::size_t begin = 0; begin < change.size(); ++begin)
    for (std::size_t length = 1; length <= longest && begin + length < change.size(); ++length) {
      const double mean = (change[begin + length] - change[begin]) / (static_cast<double>(length) * interval);
      largest = std::max(largest, static_cast<double>(length) * interval * mean * mean * std::sqrt(mean));
    }
  return largest;
}

}  // namespace driver
