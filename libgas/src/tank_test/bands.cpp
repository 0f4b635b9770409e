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

}  // namespace

NormalNumbers::NormalNumbers(unsigned long seed)
    : generator_(gsl::allocated(gsl_rng_alloc(gsl_rng_mt19937))) {
  gsl_rng_set(generator_.get(), seed);
}

std::span<const double> NormalNumbers::operator()(std::size_t count) {
  numbers_.resize(count);
  for (double& number : numbers_) number = gsl_ran_gaussian_ziggurat(generator_.get(), 1.0);
  return numbers_;
}

Band band_of(double value, std::span<const double> draws) {
  const double reach = 1.96 * gsl_stats_sd(draws.data(), 1, draws.size());
  return {value - reach, value + reach};
}

void add_bands(std::span<const Sample> samples, Identified& result) {
  result.mean_temperature_band = band(samples, [](const Sample& s) { return s.flow.mean_temperature; });
  double shift = 1.0;
  if (result.effective_area > 0.0) {
    std::vector<double> areas;
    for (const Sample& sample : samples) areas.push_back(sample.flow.effective_area);
    std::ranges::sort(areas);
    shift = result.effective_area / gsl_stats_median_from_sorted_data(areas.data(), 1, areas.size());
    result.effective_area_band =
        band(samples, [&](const Sample& s) { return shift * s.flow.effective_area; });
  }
  const double square = shift * shift;
  std::vector<double> k(samples.size());
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    IdentifiedPoint& point = result.points[i];
    point.mass_flow_band = band(samples, [&](const Sample& s) { return square * s.flow.mass_flow[i]; });
    point.temperature_band = band(samples, [&](const Sample& s) { return s.flow.temperature[i] / square; });
    std::ranges::transform(samples, k.begin(), [&](const Sample& s) { return s.enthalpy_flow[i]; });
    const double deviation = gsl_stats_sd(k.data(), 1, k.size());
    if (result.tank.noise > 0.0)
      point.amplification =
          deviation / std::max(std::abs(point.enthalpy_flow), result.threshold) / result.tank.noise;
  }
}

}  // namespace gas
