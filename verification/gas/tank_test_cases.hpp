// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "cases.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/tank_test.hpp"
#include "tank_test/identify.hpp"

// Tank tests made up from known pulses.
namespace cases {

/// 80 g in 50 ms into 60 litres, 800 K falling to 400 K; mean temperature 600 K by symmetry of the pulse.
inline closed_form::TankTestPulse pulse(double outlet_area) {
  return {0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0, outlet_area};
}

using Truth = std::function<closed_form::TankTestReadings(double)>;

struct Record {
  std::vector<double> times, tank, chamber;

  /// `count` readings from 0 to `end` [s], equally spaced.
  Record(const Truth& truth, double end, int count) {
    for (int i = 0; i < count; ++i) {
      times.push_back(end * i / (count - 1));
      const auto reading = truth(times.back());
      tank.push_back(reading.tank_pressure);
      chamber.push_back(reading.chamber_pressure);
    }
  }
  /// Gaussian noise that is a fraction of the reading, independent at every reading.
  void add_noise(double fraction, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    for (double& p : tank) p *= 1.0 + fraction * normal(generator);
    for (double& p : chamber) p *= 1.0 + fraction * normal(generator);
  }
  /// The same, a fraction of the largest reading of each gauge.
  void add_full_scale_noise(double fraction, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    for (auto* readings : {&tank, &chamber}) {
      const double deviation = fraction * *std::max_element(readings->begin(), readings->end());
      for (double& p : *readings) p += deviation * normal(generator);
    }
  }
  gas::TankReadings average() const { return {times, tank, {}}; }
  gas::TankReadings dual() const { return {times, tank, chamber}; }
};

inline gas::TankTest one_gas_test() {
  return {nitrogen(), 0.06, 293.15, kPure, kPure, 0.08};
}

inline Truth one_gas_truth(double outlet_area) {
  return [=](double t) { return closed_form::tank_test_pulse({}, {}, pulse(outlet_area), t); };
}

inline closed_form::Nasa7Gas shares(const gas::Thermo& thermo, const std::vector<double>& fractions) {
  closed_form::Nasa7Gas gas;
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const gas::Species& s = thermo.species(k);
    gas.push_back({fractions[k], thermo.gas_constant(k), s.low, s.high});
  }
  return gas;
}

/// 50 g of a mixture of cp(T), 1200 K falling to 700 K, into air.
inline gas::TankTest nasa7_test() {
  const gas::Thermo thermo = nasa7({"N2", "O2", "Ar", "CO2", "H2O"});
  return {thermo,
          0.06,
          293.15,
          thermo.mass_fractions_by_mole(gas::air_by_mole()),
          thermo.mass_fractions_by_mole(std::vector<gas::Component>{{"N2", 0.5}, {"CO2", 0.3}, {"H2O", 0.2}}),
          0.05};
}

inline closed_form::TankTestPulse nasa7_pulse() {
  return {0.06, 101325.0, 293.15, 0.05, 0.05, 1200.0, 700.0, 1e-4};
}

/// The readings of that test by an oracle of its own.
inline Truth nasa7_truth(const gas::TankTest& test) {
  return [own = shares(test.thermo, test.tank_fractions),
          inflator = shares(test.thermo, test.inflator_fractions)](double t) {
    return closed_form::nasa7_tank_test_pulse(own, inflator, nasa7_pulse(), t);
  };
}

/// Largest relative errors where the analysis does not mask.
struct Errors {
  double mass_flow = 0.0, temperature = 0.0;
  int points = 0;
};

inline Errors errors(const gas::Identified& found, const Truth& truth) {
  Errors e;
  for (const auto& point : found.points) {
    if (point.masked) continue;
    const auto exact = truth(point.time);
    e.mass_flow = std::max(e.mass_flow, relative(point.mass_flow, exact.mass_flow));
    e.temperature = std::max(e.temperature, relative(point.temperature, exact.temperature));
    ++e.points;
  }
  return e;
}

/// Share of the unmasked points whose true value is inside the band, over several seeds, and how wide it is.
struct Coverage {
  double mass_flow = 0.0, temperature = 0.0;            // shares
  double mean_temperature = 0.0, effective_area = 0.0;  // share of the records whose band holds them
  double width = 0.0;                                   // mean of the band's half width of ln T_s over 1.96
  double error = 0.0;  // mean of the actual error |ln T_s| over 0.798, which is its mean for unit deviation
};

/// 80 g at 700 K that rise linearly over 10 ms and fall over 40: corners where no smooth curve follows.
inline closed_form::TankTestReadings triangle_truth(double t) {
  constexpr double peak = 2.0 * 0.08 / 0.05, rise = 0.01, end = 0.05;
  const double left = end - std::min(t, end);
  const double flow = t < rise ? peak * t / rise : peak * left / (end - rise);
  const double mass = t < rise ? 0.5 * flow * t : 0.08 - 0.5 * flow * left;
  const double pressure = closed_form::tank_fill({{}, 0.06, 101325.0, 293.15, 1.0, 700.0}, mass).pressure;
  return {pressure, closed_form::chamber_pressure({}, 1e-4, flow, 700.0, pressure), flow, 700.0};
}

/// Readings of `truth` at 10 kHz over 60 ms: a burn of 50 ms and 10 ms of rest; Cd A is 1e-4 m2.
inline Coverage coverage(const gas::TankTest& test, const Truth& truth, double mean_temperature, double noise,
                         int first_seed, int seeds, const gas::IdentifyOptions& options) {
  Coverage c;
  int points = 0;
  for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
    Record record(truth, 0.06, 601);
    record.add_noise(noise, static_cast<unsigned>(seed));
    const gas::Identified found = gas::identify(test, record.dual(), options);
    const auto inside = [](const gas::Band& band, double x) { return band.low <= x && x <= band.high; };
    c.mean_temperature += inside(found.mean_temperature_band, mean_temperature);
    c.effective_area += inside(found.effective_area_band, 1e-4);
    EXPECT_LT(found.mean_temperature_band.high - found.mean_temperature_band.low, 0.05 * mean_temperature);
    for (const auto& point : found.points) {
      if (!point.band_claimed) continue;
      const auto exact = truth(point.time);
      c.mass_flow += inside(point.mass_flow_band, exact.mass_flow);
      c.temperature += inside(point.temperature_band, exact.temperature);
      c.width += std::log(point.temperature_band.high / point.temperature_band.low) / (2.0 * 1.96);
      c.error += std::abs(std::log(point.temperature / exact.temperature)) / 0.798;
      ++points;
    }
  }
  EXPECT_GT(points, 50 * seeds);
  return {c.mass_flow / points,     c.temperature / points, c.mean_temperature / seeds,
          c.effective_area / seeds, c.width / points,       c.error / points};
}

}  // namespace cases
