// SPDX-License-Identifier: Apache-2.0
#include "wall_heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <elementary/exponential.hpp>
#include <functional>
#include <stdexcept>

#include "require.hpp"

namespace gas {
namespace {

constexpr std::size_t kFewestOfTail = 30;  // readings of a tail
constexpr double kShortest = 0.15;         // share of the record that a tail takes
constexpr double kRiseOfTail = 0.9;        // share of the rise before which no tail begins
constexpr int kStarts = 40;                // starts that are tried
constexpr double kHidden = 1.5;            // standard deviations of the further term that noise explains
constexpr double kFading = 0.2;            // of the tail: time in which the further term fades
constexpr double kLeastWarmth = 20.0;      // [K] above the walls: below that the fall says too little
constexpr double kRises = 3.0;             // standard errors of a conductance below 0
constexpr std::size_t kMargin = 8;         // of the readings that are left, one in so many is left out
constexpr int kSteps = 6;                  // of Gauss and Newton; the first ones reduce the error by a tenth

constexpr std::size_t kTailTerms = 3;
using TailRow = std::array<double, kTailTerms>;

/// The gas after the flow: all of both gases.
class Tail {
 public:
  Tail(const TankTest& test, double initial_pressure) : test_(test), walls_(test.initial_temperature) {
    const double own = initial_pressure * test.volume /
                       (test.thermo.gas_constant(test.tank_fractions) * test.initial_temperature);
    std::vector<double> masses;
    for (std::size_t k = 0; k < test.tank_fractions.size(); ++k)
      masses.push_back(own * test.tank_fractions[k] + test.total_mass * test.inflator_fractions[k]);
    gas_.emplace(test.thermo.mixture(masses));
  }
  double temperature(double pressure) const { return pressure * test_.volume / gas_->gas_constant_sum; }
  double pressure(double temperature) const { return temperature * gas_->gas_constant_sum / test_.volume; }
  double walls() const { return walls_; }
  /// d theta/dp, with theta the integral of C_v dT/(T - T_w), which falls at the rate of the conductance.
  double slope(double temperature) const {
    return gas_->cv(temperature) / (temperature - walls_) * test_.volume / gas_->gas_constant_sum;
  }
  /// T at theta, 0 at `from`. Newton's method in ln(T - T_w), whose slope is C_v; five points of Gauss.
  double at(double theta, double from, double guess) const {
    const double begin = elementary::log(from - walls_);
    double u = elementary::log(guess - walls_);
    for (int i = 0; i < 30; ++i) {
      const double step = (theta - integral(begin, u)) / gas_->cv(walls_ + elementary::exp(u));
      u += step;
      if (std::abs(step) < 1e-13) break;
    }
    return walls_ + elementary::exp(u);
  }

 private:
  double integral(double a, double b) const {
    constexpr double points[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const auto cv = [&](double x) {
      return gas_->cv(walls_ + elementary::exp(0.5 * (a + b) + 0.5 * (b - a) * x));
    };
    double sum = weights[0] * cv(0.0);
    for (int i = 1; i < 3; ++i) sum += weights[i] * (cv(points[i]) + cv(-points[i]));
    return 0.5 * (b - a) * sum;
  }

  const TankTest& test_;
  double walls_;  // [K] of the walls
  std::optional<Mixture> gas_;
};

struct Fit {
  TailRow value{}, deviation{};  // theta at the start, -conductance, further term
  bool holds = false;
};

/// Solves normal equations of the first `terms` rows by Gauss-Jordan; the inverse is the covariance.
Fit solve(std::array<TailRow, kTailTerms> matrix, const TailRow& right, std::size_t terms) {
  std::array<TailRow, kTailTerms> inverse{};
  for (std::size_t i = 0; i < terms; ++i) inverse[i][i] = 1.0;
  for (std::size_t k = 0; k < terms; ++k) {
    const double pivot = matrix[k][k];
    if (!(pivot > 0.0)) return {};
    for (std::size_t j = 0; j < terms; ++j) matrix[k][j] /= pivot, inverse[k][j] /= pivot;
    for (std::size_t i = 0; i < terms; ++i) {
      if (i == k) continue;
      const double share = matrix[i][k];
      for (std::size_t j = 0; j < terms; ++j)
        matrix[i][j] -= share * matrix[k][j], inverse[i][j] -= share * inverse[k][j];
    }
  }
  Fit fit;
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t j = 0; j < terms; ++j) fit.value[i] += inverse[i][j] * right[j];
    fit.deviation[i] = std::sqrt(inverse[i][i]);
  }
  fit.holds = true;
  return fit;
}

/// Readings from `first` on, with `terms` terms.
Fit fit_tail(const Tail& tail, const TankReadings& readings, std::size_t first,
             const std::function<double(double)>& deviation, std::size_t terms) {
  const std::size_t n = readings.times.size();
  double mean = 0.0;
  constexpr std::size_t begin = 5;
  for (std::size_t i = first; i < first + begin; ++i) mean += readings.tank[i] / begin;
  const double from = tail.temperature(mean), length = readings.times[n - 1] - readings.times[first];
  if (!(from > tail.walls() + kLeastWarmth / 4.0)) return {};
  Fit fit;
  for (int step = 0; step < kSteps; ++step) {
    std::array<TailRow, kTailTerms> matrix{};
    TailRow right{};
    double t = from;
    for (std::size_t i = first; i < n; ++i) {
      const double x = (readings.times[i] - readings.times[first]) / length;
      const TailRow row{1.0, -x, -elementary::exp(-x / kFading)};
      double theta = 0.0;
      for (std::size_t k = 0; k < terms; ++k) theta += row[k] * fit.value[k];
      t = tail.at(theta, from, t);
      const double p = tail.pressure(t), slope = tail.slope(t);
      const double weight = 1.0 / (deviation(p) * slope * deviation(p) * slope);
      const double wanted = theta + slope * (readings.tank[i] - p);
      for (std::size_t j = 0; j < terms; ++j) {
        for (std::size_t k = 0; k < terms; ++k) matrix[j][k] += weight * row[j] * row[k];
        right[j] += weight * row[j] * wanted;
      }
    }
    fit = solve(matrix, right, terms);
    if (!fit.holds || !std::isfinite(fit.value[0])) return {};
  }
  fit.value[1] /= length, fit.deviation[1] /= length;
  return fit;
}

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("heat_loss = fit: " + why + "; give its value [W/K] instead");
}

/// First reading at 90 % of the rise. The mean of three decides, because of the noise.
std::size_t end_of_rise(const TankReadings& readings, double initial_pressure) {
  const double largest = *std::ranges::max_element(readings.tank);
  const double level = initial_pressure + kRiseOfTail * (largest - initial_pressure);
  std::size_t i = 1;
  while (i + 2 < readings.tank.size() &&
         (readings.tank[i - 1] + readings.tank[i] + readings.tank[i + 1]) / 3.0 < level)
    ++i;
  return i;
}

void require_tail(const Tail& tail, const TankReadings& readings, std::size_t risen, double latest) {
  const double begin = readings.times[risen], end = readings.times.back();
  const std::size_t left = readings.times.size() - risen;
  if (left < kFewestOfTail || begin >= latest)
    refuse("after the rise the record has " + std::to_string(left) + " readings over " +
           to_short_text(end - begin) + " s, needed: " + std::to_string(kFewestOfTail) + " or more over " +
           to_short_text(end - latest) + " s");
  const double warm = tail.temperature(readings.tank.back()) - tail.walls();
  if (!(warm >= kLeastWarmth))
    refuse("the gas ends " + to_short_text(warm) +
           " K above the walls, needed: " + to_short_text(kLeastWarmth) + " K or more; use a shorter record");
}

}  // namespace

WallHeat fit_wall_heat(const TankTest& test, const TankReadings& readings, Noise kind, double noise,
                       double initial_pressure) {
  constexpr double kLeast = 1e-9;  // of readings without noise
  const double share = std::max(noise, kLeast), largest = *std::ranges::max_element(readings.tank);
  const auto deviation = [&](double p) { return share * (kind == Noise::of_reading ? p : largest); };
  const double moved = 1e-3 * initial_pressure;
  const Tail tail(test, initial_pressure), other_tail(test, initial_pressure + moved);
  const std::size_t n = readings.times.size(), risen = end_of_rise(readings, initial_pressure);
  const double begin = readings.times[risen];
  const double latest = readings.times[n - 1] - kShortest * (readings.times[n - 1] - readings.times[0]);
  require_tail(tail, readings, risen, latest);
  int hidden = 0;
  for (int i = 0; i < kStarts; ++i) {
    const auto at = std::ranges::lower_bound(readings.times, begin + (latest - begin) * i / (kStarts - 1));
    auto first = static_cast<std::size_t>(at - readings.times.begin());
    if (n - first < kFewestOfTail) break;
    const Fit with = fit_tail(tail, readings, first, deviation, kTailTerms);
    hidden = with.holds && std::abs(with.value[2]) <= kHidden * with.deviation[2] ? hidden + 1 : 0;
    if (hidden < 2) continue;
    // What noise hides of the further term at its start has faded later.
    first = std::min(first + (n - first) / kMargin, n - kFewestOfTail);
    const Fit fit = fit_tail(tail, readings, first, deviation, kTailTerms - 1);
    const Fit other = fit_tail(other_tail, readings, first, deviation, kTailTerms - 1);
    if (!fit.holds || !other.holds) continue;
    if (fit.value[1] < -kRises * fit.deviation[1])
      refuse("after the flow the pressure rises, as if the walls gave " + to_short_text(-fit.value[1]) +
             " W/K to the gas");
    return {fit.value[1], fit.deviation[1], (other.value[1] - fit.value[1]) / moved, readings.times[first]};
  }
  refuse(
      "after the rise the pressure does not fall as a loss to the walls makes it fall, at no start up to " +
      to_short_text(latest) + " s: the record is too short, or gas still flows");
}

}  // namespace gas
