// SPDX-License-Identifier: Apache-2.0
#include "bands.hpp"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

namespace gas {
namespace {

template <typename Quantity>
Band band(std::span<const Sample> samples, const Quantity& quantity) {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(quantity(sample));
  std::ranges::sort(values);
  return {gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), 0.025),
          gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), 0.975)};
}

/// Of a quantity that the inversion biases (the burn is cut where K <= 0, which noise moves): the draws are
/// to the estimate as the estimate is to the truth.
template <typename Quantity>
Band reflected_band(double estimate, std::span<const Sample> samples, const Quantity& quantity) {
  const Band draws = band(samples, quantity);
  return {2.0 * estimate - draws.high, 2.0 * estimate - draws.low};
}

}  // namespace

NormalNumbers::NormalNumbers() : generator_(gsl::allocated(gsl_rng_alloc(gsl_rng_mt19937))) {
  gsl_rng_set(generator_.get(), 1);
}

std::span<const double> NormalNumbers::operator()(std::size_t count) {
  numbers_.resize(count);
  for (double& number : numbers_) number = gsl_ran_gaussian_ziggurat(generator_.get(), 1.0);
  return numbers_;
}

void add_bands(std::span<const Sample> samples, Identified& result) {
  result.mean_temperature_band = reflected_band(result.mean_temperature, samples,
                                                [](const Sample& s) { return s.flow.mean_temperature; });
  result.effective_area_band =
      reflected_band(result.effective_area, samples, [](const Sample& s) { return s.flow.effective_area; });
  std::vector<double> k(samples.size());
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    IdentifiedPoint& point = result.points[i];
    point.mass_flow_band = band(samples, [&](const Sample& s) { return s.flow.mass_flow[i]; });
    point.temperature_band = band(samples, [&](const Sample& s) { return s.flow.temperature[i]; });
    std::ranges::transform(samples, k.begin(), [&](const Sample& s) { return s.enthalpy_flow[i]; });
    const double deviation = gsl_stats_sd(k.data(), 1, k.size());
    if (result.tank.noise > 0.0)
      point.amplification =
          deviation / std::max(std::abs(point.enthalpy_flow), result.threshold) / result.tank.noise;
  }
}

}  // namespace gas
