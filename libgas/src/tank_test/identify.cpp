// SPDX-License-Identifier: Apache-2.0
#include "tank_test/identify.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bands.hpp"
#include "forward.hpp"
#include "inversion.hpp"
#include "require.hpp"
#include "tank_test/smoothing_spline.hpp"

namespace gas {
namespace {

constexpr double kChamberSlack = 5.0;       // standard deviations: what noise alone does not reach
constexpr double kMedianOfNormal = 0.6745;  // of the magnitude, for unit deviation
constexpr double kLeastRise = 5.0;          // standard deviations of the largest slope

void check_fractions(const TankTest& test, std::span<const double> fractions, const char* name) {
  require(fractions.size() == test.thermo.size(), name, static_cast<double>(fractions.size()),
          "number of mass fractions: must be one per species");
  double sum = 0.0;
  for (const double y : fractions) {
    require(std::isfinite(y) && y >= 0.0, name, y, "mass fractions must be 0 to 1");
    sum += y;
  }
  require(std::abs(sum - 1.0) <= 1e-9, name, sum, "mass fractions must sum to 1");
}

void check(const TankTest& test, const IdentifyOptions& options) {
  const auto positive = [](double value, const char* name) {
    require(std::isfinite(value) && value > 0.0, name, value, "must be above 0 and finite");
  };
  positive(test.volume, "volume [m3]");
  positive(test.total_mass, "total_mass [kg]");
  positive(test.initial_temperature, "initial_temperature [K]");
  check_fractions(test, test.tank_fractions, "tank_fractions");
  check_fractions(test, test.inflator_fractions, "inflator_fractions");
  const auto within = [](double value, double low, double high, const char* name) {
    require(value >= low && value <= high, name, value, "must be " + to_text(low) + " to " + to_text(high));
  };
  within(test.initial_temperature, test.thermo.minimum_temperature(), test.thermo.maximum_temperature(),
         "initial_temperature [K]");
  within(options.points, 20, 10000, "points");
  within(options.threshold, 0.001, 0.9, "threshold");
  within(options.draws, 40, 2000, "draws");
}

/// One pressure: its spline, and the basis at the times of the result.
struct Smoothed {
  SmoothingSpline spline;
  std::vector<SplineBasis> basis;

  Smoothed(std::span<const double> readings_times, std::span<const double> readings,
           std::span<const double> times, const char* name)
      : spline(readings_times, readings, name) {
    for (const double t : times) basis.push_back(spline.basis(t));
  }
  Smoothing report() const { return {spline.smoothing(), spline.degrees_of_freedom(), spline.noise()}; }
};

struct Splines {
  Smoothed tank;
  std::optional<Smoothed> chamber;
};

/// Pressures at the result's times from coefficients of both splines.
Pressures pressures(const Splines& splines, std::span<const double> tank, std::span<const double> chamber) {
  Pressures p;
  for (const SplineBasis& basis : splines.tank.basis) {
    const SplinePoint point = evaluate(basis, tank);
    p.tank.push_back(point.value);
    p.rate.push_back(point.slope);
  }
  if (splines.chamber)
    for (const SplineBasis& basis : splines.chamber->basis)
      p.chamber.push_back(evaluate(basis, chamber).value);
  return p;
}

Pressures pressures(const Splines& splines) {
  return pressures(splines, splines.tank.spline.coefficients(),
                   splines.chamber ? splines.chamber->spline.coefficients() : std::span<const double>());
}

/// Noise of one reading as a fraction of it, from the median of the second differences (6 is the sum of the
/// squares of 1, -2, 1): an outlier does not count.
double robust_noise(std::span<const double> readings) {
  std::vector<double> differences;
  for (std::size_t i = 1; i + 1 < readings.size(); ++i)
    differences.push_back(std::abs(readings[i - 1] - 2.0 * readings[i] + readings[i + 1]) / readings[i]);
  std::ranges::sort(differences);
  return gsl_stats_median_from_sorted_data(differences.data(), 1, differences.size()) /
         (kMedianOfNormal * std::sqrt(6.0));
}

void check_chamber(const TankReadings& readings) {
  const double slack =
      kChamberSlack * std::hypot(robust_noise(readings.tank), robust_noise(readings.chamber));
  for (std::size_t i = 0; i < readings.times.size(); ++i)
    if (readings.chamber[i] < readings.tank[i] * (1.0 - slack))
      throw ReadingError("chamber pressure", i,
                         to_text(readings.chamber[i]) + " Pa is below the tank's " +
                             to_text(readings.tank[i]) +
                             " Pa by more than noise explains: must not be below it");
}

/// Points where |K| is at `limit` or more and the chamber drives a flow; `k` in the scale of `limit`.
std::vector<char> find_masked(const std::vector<double>& k, const Pressures& p, double limit) {
  std::vector<char> masked;
  for (std::size_t i = 0; i < k.size(); ++i)
    masked.push_back(!(k[i] >= limit) || (!p.chamber.empty() && p.chamber[i] <= p.tank[i]));
  return masked;
}

/// From the first point that is not masked to the last, and on either side as far as K > 0.
Burn find_burn(const std::vector<double>& k, std::vector<char> masked) {
  Burn burn{0, k.size() - 1, std::move(masked)};
  while (burn.first < burn.last && burn.masked[burn.first]) ++burn.first;
  while (burn.first < burn.last && burn.masked[burn.last]) --burn.last;
  while (burn.first > 0 && k[burn.first - 1] > 0.0) --burn.first;
  while (burn.last + 1 < k.size() && k[burn.last + 1] > 0.0) ++burn.last;
  return burn;
}

/// The first guess of Cd A: the one that gives the total mass at the mean temperature.
double guessed_area(const TankTest& test, const Pressures& p, std::span<const double> times,
                    double temperature) {
  const TankGas gas(test, p.tank.front());
  double mass = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i)
    mass += gas.outlet_flow(1.0, temperature, p.chamber[i], p.tank[i]) * (times[i] - times[i - 1]);
  if (!(mass > 0.0)) throw DomainError("tank test: the chamber pressure is never above the tank's");
  return test.total_mass / mass;
}

Flow invert(const TankTest& test, std::span<const double> times, const Pressures& p, const Burn& burn,
            const Flow* guess) {
  const Inversion inversion(test, times, p);
  Flow flow = inversion.average_temperature(burn);
  if (p.chamber.empty()) return flow;
  const double mean = flow.mean_temperature;
  if (guess)
    flow = *guess;
  else
    flow.effective_area = guessed_area(test, p, times, mean);
  flow = inversion.dual_pressure(burn, flow);
  flow.mean_temperature = mean;
  return flow;
}

std::vector<double> equally_spaced(double first, double last, int points) {
  std::vector<double> times;
  for (int i = 0; i < points; ++i) times.push_back(first + (last - first) * i / (points - 1));
  times.back() = last;
  return times;
}

std::vector<double> drawn_coefficients(const SmoothingSpline& spline, NormalNumbers& normals) {
  std::vector<double> drawn(spline.coefficients().size());
  spline.draw(normals(drawn.size()), drawn);
  return drawn;
}

/// The largest slope must stand clear of its own scatter.
void check_rise(const Smoothed& tank, const std::vector<double>& slopes, int draws) {
  const auto peak = std::ranges::max_element(slopes);
  const SplineBasis& basis = tank.basis[static_cast<std::size_t>(peak - slopes.begin())];
  NormalNumbers normals;
  double variance = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double miss = evaluate(basis, drawn_coefficients(tank.spline, normals)).slope - *peak;
    variance += miss * miss / draws;
  }
  if (!(*peak > kLeastRise * std::sqrt(variance)))
    throw DomainError("tank test: the tank pressure does not rise above its noise");
}

Sample draw(const Splines& splines, const TankTest& test, std::span<const double> times, const Burn& burn,
            const Flow& best, NormalNumbers& normals) {
  const std::vector<double> tank = drawn_coefficients(splines.tank.spline, normals);
  const std::vector<double> chamber =
      splines.chamber ? drawn_coefficients(splines.chamber->spline, normals) : std::vector<double>();
  const Pressures p = pressures(splines, tank, chamber);
  return {invert(test, times, p, find_burn(p.rate, burn.masked), &best),
          Inversion(test, times, p).enthalpy_flow(best.mean_temperature)};
}

}  // namespace

Identified identify(const TankTest& test, const TankReadings& readings, const IdentifyOptions& options) {
  check(test, options);
  const bool dual = !readings.chamber.empty();
  const std::vector<double> times =
      readings.times.empty() ? std::vector<double>()
                             : equally_spaced(readings.times.front(), readings.times.back(), options.points);
  Splines splines{Smoothed(readings.times, readings.tank, times, "tank pressure"), {}};
  if (dual) splines.chamber.emplace(readings.times, readings.chamber, times, "chamber pressure");
  Identified result{};
  result.tank = splines.tank.report();
  if (dual) result.chamber = splines.chamber->report();
  if (dual) check_chamber(readings);
  const Pressures p = pressures(splines);
  check_rise(splines.tank, p.rate, options.draws);
  const double limit = options.threshold * *std::ranges::max_element(p.rate);
  const Burn burn = find_burn(p.rate, find_masked(p.rate, p, limit));
  const Flow flow = invert(test, times, p, burn, nullptr);
  const std::vector<double> k = Inversion(test, times, p).enthalpy_flow(flow.mean_temperature);
  result.threshold = options.threshold * *std::ranges::max_element(k);
  result.mean_temperature = flow.mean_temperature;
  result.effective_area = flow.effective_area;
  for (std::size_t i = 0; i < times.size(); ++i)
    result.points.push_back({times[i],
                             p.tank[i],
                             dual ? p.chamber[i] : 0.0,
                             k[i],
                             flow.mass_flow[i],
                             flow.temperature[i],
                             {},
                             {},
                             0.0,
                             burn.masked[i] != 0});

  result.forward_error = forward_error(test, result.points);

  NormalNumbers normals;
  std::vector<Sample> samples;
  for (int i = 0; i < options.draws; ++i) samples.push_back(draw(splines, test, times, burn, flow, normals));
  add_bands(samples, result);
  return result;
}

}  // namespace gas
