// SPDX-License-Identifier: Apache-2.0
#include "initial_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <elementary/error_function.hpp>
#include <elementary/exponential.hpp>
#include <numbers>

namespace gas {
namespace {

constexpr double kRisen = 6.0;            // standard deviations of a reading: a larger rise counts as risen
constexpr std::size_t kReference = 3;     // the rise is measured from the mean of so many readings
constexpr std::size_t kMostShares = 200;  // numbers of flat readings that are tried

constexpr std::size_t kTerms = 3;  // 1 and two powers of the time since the onset

using Row = std::array<double, kTerms>;
using Matrix = std::array<Row, kTerms>;

/// One past the last reading to use: the first of two successive readings that have risen.
std::size_t find_risen(std::span<const double> readings, double deviation) {
  double reference = 0.0;
  for (std::size_t i = 0; i < kReference; ++i) reference += readings[i] / kReference;
  const auto risen = [&](std::size_t i) { return readings[i] > reference + kRisen * deviation; };
  std::size_t i = 1;
  while (i + 1 < readings.size() && !(risen(i) && risen(i + 1))) ++i;
  return i;
}

/// Cholesky factors in place; returns the logarithm of the determinant.
double factorize(Matrix& m) {
  double logarithm = 0.0;
  for (std::size_t k = 0; k < kTerms; ++k) {
    for (std::size_t j = 0; j < k; ++j) m[k][k] -= m[k][j] * m[k][j];
    m[k][k] = std::sqrt(m[k][k]);
    logarithm += 2.0 * elementary::log(m[k][k]);
    for (std::size_t i = k + 1; i < kTerms; ++i) {
      for (std::size_t j = 0; j < k; ++j) m[i][k] -= m[i][j] * m[k][j];
      m[i][k] /= m[k][k];
    }
  }
  return logarithm;
}

}  // namespace

InitialPressure::InitialPressure(std::span<const double> times, std::span<const double> readings,
                                 double deviation) {
  const std::size_t end = find_risen(readings, deviation), step = end / kMostShares + 1;
  // Scaled by the deviation and the mean interval, so that a and b are of the order of the rise.
  const double interval = (times[end] - times[0]) / static_cast<double>(end), origin = readings[0];
  std::vector<double> logarithms;
  for (std::size_t last = 0; last < end; last += step) {
    // The normal matrix with c last, so that the last row of its factor gives c alone.
    Matrix m{};
    Row right{};
    double square = 0.0;
    for (std::size_t k = 0; k + 1 < kTerms; ++k) m[k][k] = 1.0 / (kRisen * kRisen);
    for (std::size_t i = 0; i < end; ++i) {
      const double x = std::max(0.0, (times[i] - times[last]) / interval);
      const double y = (readings[i] - origin) / deviation;
      const Row row{x * x, x, 1.0};
      for (std::size_t j = 0; j < kTerms; ++j) {
        for (std::size_t k = 0; k <= j; ++k) m[j][k] += row[j] * row[k];
        right[j] += row[j] * y;
      }
      square += y * y;
    }
    const double determinant = factorize(m);
    for (std::size_t k = 0; k < kTerms; ++k) {
      for (std::size_t j = 0; j < k; ++j) right[k] -= m[k][j] * right[j];
      right[k] /= m[k][k];
      square -= right[k] * right[k];
    }
    logarithms.push_back(-0.5 * (square + determinant) - elementary::log(static_cast<double>(last + 1)));
    shares_.push_back(
        {0.0, origin + deviation * right.back() / m.back().back(), deviation / m.back().back()});
  }
  const double best = *std::ranges::max_element(logarithms);
  double sum = 0.0;
  for (std::size_t i = 0; i < shares_.size(); ++i)
    sum += shares_[i].weight = elementary::exp(logarithms[i] - best);
  for (Share& share : shares_) {
    share.weight /= sum;
    value_ += share.weight * share.mean;
  }
}

double InitialPressure::draw(double choice, double normal) const {
  double left = 0.5 * elementary::erfc(-choice / std::numbers::sqrt2);
  std::size_t i = 0;
  while (i + 1 < shares_.size() && left > shares_[i].weight) left -= shares_[i++].weight;
  return shares_[i].mean + shares_[i].deviation * normal;
}

}  // namespace gas
