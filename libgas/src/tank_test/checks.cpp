// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>
#include <string>

#include "require.hpp"

namespace gas {
namespace {

constexpr double kChamberSlack = 5.0;       // standard deviations that noise alone does not reach
constexpr double kMedianOfNormal = 0.6745;  // median of the magnitude of a normal number with unit deviation

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

/// Standard deviation of one reading, from the median of the second differences, so that outliers do not
/// count (6 is the sum of the squares of 1, -2, 1). It is a fraction of the reading, or in its unit.
double robust_noise(std::span<const double> readings, Noise noise) {
  std::vector<double> differences;
  for (std::size_t i = 1; i + 1 < readings.size(); ++i)
    differences.push_back(std::abs(readings[i - 1] - 2.0 * readings[i] + readings[i + 1]) /
                          (noise == Noise::of_reading ? readings[i] : 1.0));
  std::ranges::sort(differences);
  return gsl_stats_median_from_sorted_data(differences.data(), 1, differences.size()) /
         (kMedianOfNormal * std::sqrt(6.0));
}

}  // namespace

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
  require(std::isfinite(options.heat_loss) && options.heat_loss >= 0.0, "heat_loss [W/K]", options.heat_loss,
          "must be 0 or more and finite");
  within(options.points, 20, 10000, "points");
  within(options.threshold, 0.001, 0.9, "threshold");
  within(options.draws, 40, 2000, "draws");
}

void check_pressures(const TankReadings& readings, Noise noise) {
  for (std::size_t i = 0; i < readings.tank.size(); ++i)
    if (!(readings.tank[i] > 0.0))
      throw ReadingError("tank pressure", i, to_text(readings.tank[i]) + ": must be above 0");
  if (readings.chamber.empty()) return;
  const double slack = kChamberSlack * elementary::hypot(robust_noise(readings.tank, noise),
                                                         robust_noise(readings.chamber, noise));
  for (std::size_t i = 0; i < readings.times.size(); ++i) {
    const double tank = readings.tank[i];
    if (readings.chamber[i] < tank - slack * (noise == Noise::of_reading ? tank : 1.0))
      throw ReadingError("chamber pressure", i,
                         to_text(readings.chamber[i]) + " Pa is below the tank's " + to_text(tank) +
                             " Pa by more than noise as a share of the " +
                             (noise == Noise::of_reading ? "reading" : "full scale") +
                             ": must not be below it");
  }
}

}  // namespace gas
