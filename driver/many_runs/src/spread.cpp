// SPDX-License-Identifier: Apache-2.0
#include "many_runs/spread.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <elementary/exponential.hpp>

#include "many_runs/regression.hpp"

namespace driver {
namespace {

constexpr double beyond = 0.025;  // share at each end of an interval

// Boost's beta function serves a million points, where GSL's continued fraction ends too early. Long double,
// its default, would end the program under valgrind.
using Doubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// Chance that at most `count` of n values lie below the quantile of `share`.
double binomial(long count, double share, long n) {
  if (count < 0) return 0.0;
  if (count >= n) return 1.0;
  return boost::math::ibetac(static_cast<double>(count) + 1.0, static_cast<double>(n - count), share,
                             Doubles());
}

// Hazen's: the middle of the i-th of n values is at (i - 1/2) / n.
double percentile_of(const std::vector<double>& sorted, double share) {
  const double last = static_cast<double>(sorted.size()) - 1.0;
  const double place = std::clamp(share * static_cast<double>(sorted.size()) - 0.5, 0.0, last);
  const double whole = std::floor(place);
  const auto at = static_cast<std::size_t>(whole);
  return sorted[at] + (place - whole) * (sorted[std::min(at + 1, sorted.size() - 1)] - sorted[at]);
}

// The greatest count for which at most `beyond` of the binomial counts lie below it.
long low_rank(long n, double share) {
  long low = 0, high = n + 1;
  while (high - low > 1) {
    const long middle = (low + high) / 2;
    (binomial(middle - 1, share, n) <= beyond ? low : high) = middle;
  }
  return low;
}

// Ranks among n independent values; the upper one is the lower one from the other end. Scaled outwards to all
// runs of the points.
Percentile with_interval(const std::vector<double>& sorted, long points, double percent) {
  Percentile p{percent, percentile_of(sorted, percent / 100.0), {}, {}};
  const auto runs = static_cast<long>(sorted.size());
  const long low = low_rank(points, percent / 100.0), high = low_rank(points, 1.0 - percent / 100.0);
  if (low > 0) p.low = sorted[static_cast<std::size_t>((low - 1) * runs / points)];
  if (high > 0) p.high = sorted[static_cast<std::size_t>(runs - 1 - (high - 1) * runs / points)];
  return p;
}

// Mean and deviation, so that the numbers of a fit are of order one.
struct Scaled {
  double mean = 0.0, deviation = 0.0;
  std::vector<double> values;
};

Scaled scaled(const std::vector<double>& values) {
  const Statistics s = statistics(values);
  Scaled to{s.mean, s.standard_error * std::sqrt(static_cast<double>(s.count)), {}};
  if (s.minimum == s.maximum) to.deviation = 0.0;
  for (const double value : values)
    to.values.push_back(to.deviation > 0.0 ? (value - to.mean) / to.deviation : 0.0);
  return to;
}

// Of the square of a correlation coefficient: Fisher's z = atanh(r) has the standard error 1 / sqrt(n - 3).
Estimate share_of_variance(double explained, double n) {
  const double share = std::clamp(1.0 - (1.0 - explained) * (n - 1.0) / (n - 3.0), 0.0, 1.0);
  const double r = std::min(std::sqrt(share), 1.0 - 1e-15);
  const double z = 0.5 * elementary::log((1.0 + r) / (1.0 - r));
  const double reach = gsl_cdf_ugaussian_Qinv(beyond) / std::sqrt(n - 3.0);
  const auto back = [](double of) {
    const double grown = elementary::exp(2.0 * std::max(0.0, of));
    const double t = std::isfinite(grown) ? (grown - 1.0) / (grown + 1.0) : 1.0;
    return t * t;
  };
  return {share, std::min(share, back(z - reach)), std::max(share, back(z + reach))};
}

}  // namespace

std::optional<Spread> spread(const std::vector<std::vector<double>>& of_points) {
  std::vector<double> means, all;
  for (const auto& runs : of_points) {
    if (runs.empty()) continue;
    means.push_back(statistics(runs).mean);
    all.insert(all.end(), runs.begin(), runs.end());
  }
  if (means.size() < 2) return std::nullopt;
  const Statistics s = statistics(means), single = statistics(all);
  Spread result;
  result.points = s.count;
  result.runs = single.count;
  const double reach = gsl_cdf_tdist_Qinv(beyond, s.count - 1.0) * s.standard_error;
  result.mean = {s.mean, s.mean - reach, s.mean + reach};
  result.standard_error = s.standard_error;
  result.standard_deviation = single.standard_error * std::sqrt(static_cast<double>(single.count));
  std::ranges::sort(all);
  for (const double percent : percentiles)
    result.percentiles.push_back(with_interval(all, result.points, percent));
  return result;
}

Estimate chance(double share, long points) {
  const double n = static_cast<double>(points), beyond_it = share * n;
  using boost::math::ibeta_inv;
  return {share, share > 0.0 ? ibeta_inv(beyond_it, n - beyond_it + 1.0, beyond, Doubles()) : 0.0,
          share < 1.0 ? ibeta_inv(beyond_it + 1.0, n - beyond_it, 1.0 - beyond, Doubles()) : 1.0};
}

double Trend::at(double x) const {
  const double scaled_x = (x - mean) / deviation;
  return constant + scaled_x * (slope + scaled_x * bend);
}

std::optional<Trend> trend(const std::vector<double>& factor, const std::vector<double>& values) {
  constexpr std::size_t fewest = 5;
  if (values.size() < fewest) return std::nullopt;
  const Scaled x = scaled(factor), y = scaled(values);
  constexpr double rounding = 1e-12;  // of a result that only rounding moves
  if (!(x.deviation > 0.0 && y.deviation > rounding * std::abs(y.mean))) return std::nullopt;
  std::vector<std::vector<double>> points;
  for (const double one : x.values) points.push_back({one});
  const auto fit = fit_surface(points, y.values);
  if (!fit) return std::nullopt;
  const auto of = [&](std::size_t term) { return y.deviation * fit->terms[term].coefficient; };
  return Trend{share_of_variance(fit->explained, static_cast<double>(values.size())),
               of(1),
               y.mean + of(0),
               of(1),
               of(2),
               x.mean,
               x.deviation};
}

}  // namespace driver
