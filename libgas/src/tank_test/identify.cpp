// SPDX-License-Identifier: Apache-2.0
#include "tank_test/identify.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <elementary/hypot.hpp>
#include <optional>

#include "bands.hpp"
#include "checks.hpp"
#include "clipping.hpp"
#include "forward.hpp"
#include "initial_pressure.hpp"
#include "inversion.hpp"
#include "tank_test/smoothing_spline.hpp"
#include "wall_heat.hpp"

namespace gas {
namespace {

constexpr double kLeastRise = 5.0;       // standard deviations of the largest slope
constexpr double kResolved = 4.0;        // standard deviations of K: above these its inverse has a band
constexpr double kFirm = 10.0;           // standard deviations of K: its temperature is known to a fifth
constexpr double kFalls = 5.0;           // standard deviations: a fall of the tank's pressure after the burn
constexpr double kUndersmoothing = 3.0;  // divisor of lambda in the draws: keeps the bias of smoothing below
                                         // the noise
constexpr double kSharp = 4.0;        // multiple of the burn's mean roughness: smoothing rounds bends sharper
                                      // than this
constexpr double kBeyond = 0.025;     // share of the draws outside a band, at each end
constexpr double kMostMisfits = 0.1;  // of the draws
constexpr double kMiss = 0.005;       // share of the pressure: 501 points over 150 ms miss 7e-4 in a rise of
                                      // 1 ms
constexpr double kMissNoise = 5.0;    // standard deviations of a reading
constexpr long kLeastReadings = 30;   // in the burn: with fewer, smoothing rounds the pulse itself

/// The spline of one pressure, and its basis at the times of the result.
struct Smoothed {
  SmoothingSpline spline;
  std::vector<SplineBasis> basis;

  Smoothed(std::span<const double> readings_times, std::span<const double> readings, Noise noise,
           std::span<const double> times, const char* name)
      : spline(readings_times, readings, name, noise) {
    for (const double t : times) basis.push_back(spline.basis(t));
  }
  Smoothing report() const { return {spline.smoothing(), spline.degrees_of_freedom(), spline.noise()}; }
};

struct Splines {
  Smoothed tank;
  std::optional<Smoothed> chamber;
};

/// Pressures at the times of the result, from coefficients of both splines.
Pressures pressures(const Splines& splines, double initial, std::span<const double> tank,
                    std::span<const double> chamber) {
  Pressures p;
  p.initial = initial;
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

Pressures pressures(const Splines& splines, double initial) {
  return pressures(splines, initial, splines.tank.spline.coefficients(),
                   splines.chamber ? splines.chamber->spline.coefficients() : std::span<const double>());
}

/// Point at which the tank holds all of the mass: the end of the record, or the peak of the pressure if it
/// then falls by more than the noise.
std::size_t find_end(const Splines& splines, const Pressures& p, const std::optional<std::size_t>& tail) {
  if (tail) return *tail;
  const auto deviation = [&](std::size_t i) {
    return splines.tank.spline.deviation(splines.tank.basis[i]).value;
  };
  const std::size_t last = p.tank.size() - 1;
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(p.tank) - p.tank.begin());
  const double fall = p.tank[peak] - p.tank[last];
  return fall > kFalls * elementary::hypot(deviation(peak), deviation(last)) ? peak : last;
}

/// Sets the burn: all points that are not masked, extended on both sides as far as K > 0.
void set_burn(const std::vector<double>& k, Burn& burn) {
  burn.first = 0;
  burn.last = burn.end;
  while (burn.first < burn.last && burn.masked[burn.first]) ++burn.first;
  while (burn.first < burn.last && burn.masked[burn.last]) --burn.last;
  while (burn.first > 0 && k[burn.first - 1] > 0.0) --burn.first;
  while (burn.last < burn.end && k[burn.last + 1] > 0.0) ++burn.last;
}

/// Finds the burn. A point is masked if K is below `threshold` of its maximum or hidden by noise, if the
/// chamber drives no flow, or if its gauge is cut off.
Burn find_burn(const Splines& splines, const Pressures& p, double threshold, std::vector<char> clipped,
               const std::optional<std::size_t>& tail) {
  const std::vector<double>& rate = p.adiabatic_rate;
  const std::size_t n = rate.size();
  std::vector<double> signal;
  for (std::size_t i = 0; i < n; ++i)
    signal.push_back(rate[i] / splines.tank.spline.deviation(splines.tank.basis[i]).slope);
  const auto peak = std::ranges::max_element(rate);
  const double best = *std::ranges::max_element(signal);
  if (!(*peak > 0.0 && best > kLeastRise))
    throw DomainError("tank test: the tank pressure does not rise above its noise");
  Burn burn;
  burn.clipped = std::move(clipped);
  burn.end = find_end(splines, p, tail);
  for (std::size_t i = 0; i < n; ++i) {
    const bool masked = !(rate[i] >= threshold * *peak && signal[i] >= kResolved && i <= burn.end) ||
                        (!p.chamber.empty() && (p.chamber[i] <= p.tank[i] || burn.clipped[i]));
    burn.masked.push_back(masked);
    burn.firm.push_back(!masked && signal[i] >= std::min(kFirm, 0.9 * best));
  }
  set_burn(rate, burn);
  return burn;
}

FlowCurves invert(const TankTest& test, std::span<const double> times, const Pressures& p, const Burn& burn,
                  const FlowCurves* guess) {
  const Inversion inversion(test, times, p);
  FlowCurves flow = inversion.average_temperature(burn);
  if (p.chamber.empty()) return flow;
  const double mean = flow.mean_temperature;
  if (guess) flow = *guess;
  flow = inversion.dual_pressure(burn, flow);
  flow.mean_temperature = mean;
  return flow;
}

/// Point from which on the tank holds all of the mass, if the pressure's peak does not show it.
std::optional<std::size_t> full_from(const WallHeat& walls, const IdentifyOptions& options,
                                     std::span<const double> times) {
  if (walls.conductance == 0.0 && !options.fit_heat_loss) return std::nullopt;
  if (!options.fit_heat_loss) return times.size() - 1;
  return static_cast<std::size_t>(std::ranges::lower_bound(times, walls.start) - times.begin());
}

std::vector<double> equally_spaced(double first, double last, int points) {
  std::vector<double> times;
  for (int i = 0; i < points; ++i) times.push_back(first + (last - first) * i / (points - 1));
  times.back() = last;
  return times;
}

/// The times at which the gauge is cut off.
std::vector<char> within(const std::optional<Clipping>& clipping, std::span<const double> times) {
  std::vector<char> inside;
  for (const double t : times) inside.push_back(clipping && t >= clipping->first && t <= clipping->last);
  return inside;
}

InitialPressure initial_pressure(const TankReadings& readings, const SmoothingSpline& spline, Noise noise) {
  constexpr double kLeast = 1e-12;  // share of the scale, for readings without noise
  const double scale =
      noise == Noise::of_reading ? readings.tank.front() : *std::ranges::max_element(readings.tank);
  return {readings.times, readings.tank, scale * std::max(kLeast, spline.noise())};
}

std::vector<double> drawn_coefficients(const SmoothingSpline& spline, double undersmoothing,
                                       NormalNumbers& normals) {
  std::vector<double> drawn(spline.coefficients().size());
  spline.draw(normals(drawn.size() + 1), undersmoothing, drawn);
  return drawn;
}

Sample draw(const Splines& splines, const TankTest& test, std::span<const double> times, const Burn& burn,
            const FlowCurves& best, const HeldSpread& spread, double initial, double conductance,
            NormalNumbers& normals) {
  const std::vector<double> tank = drawn_coefficients(splines.tank.spline, kUndersmoothing, normals);
  const std::vector<double> chamber =
      splines.chamber ? drawn_coefficients(splines.chamber->spline, kUndersmoothing, normals)
                      : std::vector<double>();
  Burn moved = burn;
  const std::span<const double> numbers = normals(2);
  Pressures p = pressures(splines, initial, tank, chamber);
  p.conductance = conductance;
  set_adiabatic_rate(test, Inversion(test, times, p).masses(best.mass_flow), p);
  moved.before = elementary::exp(spread.before * numbers[0]);
  moved.after = elementary::exp(spread.after * numbers[1]);
  set_burn(p.adiabatic_rate, moved);
  return {invert(test, times, p, moved, &best),
          Inversion(test, times, p).enthalpy_flow(best.mean_temperature)};
}

/// Claims bands, except where the burn has too few readings, the pressure bends too sharply for the
/// smoothing, the point is masked, or the estimate or too many draws are at an end of the range of
/// temperatures.
void claim(std::span<const double> readings, TankGas::Range range, const SmoothingSpline& tank,
           const Burn& burn, std::span<const Sample> samples, Identified& result) {
  const double start = result.points[burn.first].time, end = result.points[burn.last].time;
  const auto inside = std::ranges::count_if(readings, [&](double t) { return start <= t && t <= end; });
  const bool claims = result.bands && inside >= kLeastReadings;
  double sum = 0.0;
  for (std::size_t i = burn.first; i <= burn.last; ++i) sum += tank.roughness(result.points[i].time);
  const double limit = kSharp * sum / static_cast<double>(burn.last - burn.first + 1);
  const auto at_end = [&](double t) { return t <= range.low || t >= range.high; };
  const auto ends = [&](std::size_t i) {
    const auto count = std::ranges::count_if(
        samples, [&](const Sample& sample) { return at_end(sample.flow.temperature[i]); });
    return at_end(result.points[i].temperature) ||
           static_cast<double>(count) > kBeyond * static_cast<double>(samples.size());
  };
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    IdentifiedPoint& point = result.points[i];
    point.band_claimed = claims && !point.masked && tank.roughness(point.time) <= limit && !ends(i);
  }
}

}  // namespace

Identified identify(const TankTest& test, const TankReadings& readings, const IdentifyOptions& options) {
  check(test, options);
  const bool dual = !readings.chamber.empty();
  const std::vector<double> times =
      readings.times.empty() ? std::vector<double>()
                             : equally_spaced(readings.times.front(), readings.times.back(), options.points);
  Splines splines{Smoothed(readings.times, readings.tank, options.noise, times, "tank pressure"), {}};
  if (dual)
    splines.chamber.emplace(readings.times, readings.chamber, options.noise, times, "chamber pressure");
  Identified result{};
  result.tank = splines.tank.report();
  if (dual) result.chamber = splines.chamber->report();
  check_pressures(readings, options.noise);
  result.tank_clipping = find_clipping(readings.times, readings.tank);
  if (dual) result.chamber_clipping = find_clipping(readings.times, readings.chamber);
  const InitialPressure initial = initial_pressure(readings, splines.tank.spline, options.noise);
  result.initial_pressure = initial.value();
  WallHeat walls{options.heat_loss, 0.0, 0.0, 0.0};
  if (options.fit_heat_loss)
    walls = fit_wall_heat(test, readings, options.noise, splines.tank.spline.noise(), initial.value());
  const auto tail = full_from(walls, options, times);
  Pressures p = pressures(splines, initial.value());
  p.conductance = walls.conductance;
  set_adiabatic_rate(test, masses_of_rise(test, p), p);
  Burn burn = find_burn(splines, p, options.threshold, within(result.chamber_clipping, times), tail);
  FlowCurves flow = invert(test, times, p, burn, nullptr);
  // The loss depends on the masses, weakly: each pass reduces their error by a tenth or more.
  constexpr int passes = 3;
  for (int i = 0; p.conductance != 0.0 && i < passes; ++i) {
    set_adiabatic_rate(test, Inversion(test, times, p).masses(flow.mass_flow), p);
    burn = find_burn(splines, p, options.threshold, within(result.chamber_clipping, times), tail);
    flow = invert(test, times, p, burn, nullptr);
  }
  result.heat_loss = walls.conductance;
  result.tail_start = walls.start;
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

  result.forward_error = forward_error(test, initial.value(), walls.conductance, result.points);
  const auto [low, high] = std::ranges::minmax(p.tank);
  const double share = options.noise == Noise::of_reading ? 1.0 : high / low;
  result.forward_noise = kMissNoise * result.tank.noise * share;
  result.fits = result.forward_error <= kMiss + result.forward_noise;

  const HeldSpread spread = held_spread(burn, flow.temperature);
  NormalNumbers normals(1), of_initial(2), of_walls(3);
  std::vector<Sample> samples;
  std::vector<double> conductances;
  for (int i = 0; i < options.draws; ++i) try {
      const std::span<const double> two = of_initial(2);
      const double before = initial.draw(two[0], two[1]);
      conductances.push_back(walls.conductance + walls.slope * (before - initial.value()) +
                             walls.deviation * of_walls(1)[0]);
      samples.push_back(draw(splines, test, times, burn, flow, spread, before, conductances.back(), normals));
    } catch (const DomainError&) {
      ++result.misfits;
    }
  result.heat_loss_band = band_of(walls.conductance, conductances);
  const bool samples_hold = result.misfits <= kMostMisfits * options.draws;
  if (samples_hold) add_bands(samples, result);
  result.bands = result.fits && samples_hold && !result.tank_clipping && !result.chamber_clipping;
  claim(readings.times, TankGas(test, initial.value()).temperatures(), splines.tank.spline, burn, samples,
        result);
  return result;
}

}  // namespace gas
