// SPDX-License-Identifier: Apache-2.0
#include "many_runs/distribution.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <elementary/trigonometric.hpp>
#include <numbers>

namespace driver {
namespace {

// The ends have no finite quantile; a sample may reach them by rounding.
double inside(double unit) {
  return std::clamp(unit, 0x1p-54, 1.0 - 0x1p-53);
}

// In the lower half of the numbers, where shares are not rounded to a multiple of epsilon.
double cut_normal(double low, double high, double unit) {
  if (low > 0.0) return -cut_normal(-high, -low, 1.0 - unit);
  const double below = gsl_cdf_ugaussian_P(low), above = gsl_cdf_ugaussian_P(high);
  const double share = below + unit * (above - below);
  return std::clamp(gsl_cdf_ugaussian_Pinv(inside(share)), low, high);
}

struct Quantile {
  double unit;

  double operator()(const NormalDistribution& d) const {
    const auto scaled = [&](double value) { return (value - d.mean) / d.standard_deviation; };
    return std::clamp(d.mean + d.standard_deviation * cut_normal(scaled(d.low), scaled(d.high), unit), d.low,
                      d.high);
  }
  double operator()(const TriangularDistribution& d) const {
    const double width = d.high - d.low, rise = d.mode - d.low;
    return unit * width <= rise ? d.low + std::sqrt(unit * width * rise)
                                : d.high - std::sqrt((1.0 - unit) * width * (d.high - d.mode));
  }
  double operator()(const LogNormalDistribution& d) const {
    return d.median * elementary::pow(d.factor, gsl_cdf_ugaussian_Pinv(unit));
  }
};

}  // namespace

double quantile(const Distribution& distribution, double unit) {
  return std::visit(Quantile{inside(unit)}, distribution);
}

double share_inside(const NormalDistribution& d) {
  const double low = (d.low - d.mean) / d.standard_deviation;
  const double high = (d.high - d.mean) / d.standard_deviation;
  return low > 0.0 ? gsl_cdf_ugaussian_Q(low) - gsl_cdf_ugaussian_Q(high)
                   : gsl_cdf_ugaussian_P(high) - gsl_cdf_ugaussian_P(low);
}

double coefficient_from_ranks(double of_ranks) {
  return 2.0 * elementary::sin(std::numbers::pi / 6.0 * of_ranks);
}

Correlation::Correlation(std::size_t inputs) : inputs_(inputs), matrix_(inputs * inputs, 0.0) {
  for (std::size_t i = 0; i < inputs; ++i) matrix_[i * inputs + i] = 1.0;
  factor_ = matrix_;
}

void Correlation::set(std::size_t a, std::size_t b, double coefficient) {
  matrix_[a * inputs_ + b] = matrix_[b * inputs_ + a] = coefficient;
}

bool Correlation::factorise() {
  constexpr double least = 1e-10;  // of a pivot: what is left of an input's variance, beyond rounding
  std::ranges::fill(factor_, 0.0);
  for (std::size_t i = 0; i < inputs_; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = coefficient(i, j);
      for (std::size_t k = 0; k < j; ++k) rest -= factor_[i * inputs_ + k] * factor_[j * inputs_ + k];
      if (i == j && !(rest > least)) return false;
      factor_[i * inputs_ + j] = i == j ? std::sqrt(rest) : rest / factor_[j * inputs_ + j];
    }
  return true;
}

void Correlation::apply(UnitPoint& point) const {
  std::vector<double> normal;
  for (const double unit : point) normal.push_back(gsl_cdf_ugaussian_Pinv(inside(unit)));
  for (std::size_t i = 0; i < inputs_; ++i) {
    double sum = 0.0;
    bool is_mixed = false;
    for (std::size_t j = 0; j <= i; ++j) {
      sum += factor_[i * inputs_ + j] * normal[j];
      is_mixed = is_mixed || (j < i && factor_[i * inputs_ + j] != 0.0);
    }
    if (is_mixed) point[i] = inside(gsl_cdf_ugaussian_P(sum));
  }
}

}  // namespace driver
