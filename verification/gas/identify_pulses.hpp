// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <numbers>

#include "tank_test_cases.hpp"

// Tank tests of pulses of any shape, gases of constant cp.
namespace cases {

using History = std::function<double(double)>;

/// One test: what is known, what is true, the end of its record [s], and the true mean temperature [K].
struct Pulse {
  gas::TankTest test;
  Truth truth;
  double end;
  double mean_temperature;
};

/// `mass` [kg] that flows as `shape` and at `temperature`, by Simpson's rule on 60 000 pieces; 60 litres,
/// Cd A = 1e-4 m2.
inline Pulse make_pulse(const gas::TankTest& test, const closed_form::PerfectGas& own,
                        const closed_form::PerfectGas& in, const History& shape, const History& temperature,
                        double end) {
  constexpr int pieces = 60000;
  const double step = end / pieces;
  auto mass = std::make_shared<std::vector<double>>(1, 0.0);
  auto heat = std::make_shared<std::vector<double>>(1, 0.0);
  for (int i = 1; i <= pieces; ++i) {
    const double a = (i - 1) * step, b = i * step, c = 0.5 * (a + b);
    mass->push_back(mass->back() + step / 6.0 * (shape(a) + 4.0 * shape(c) + shape(b)));
    heat->push_back(heat->back() + step / 6.0 *
                                       (shape(a) * temperature(a) + 4.0 * shape(c) * temperature(c) +
                                        shape(b) * temperature(b)));
  }
  const double scale = test.total_mass / mass->back();
  const double own_mass = 101325.0 * test.volume / (own.gas_constant * test.initial_temperature);
  const auto cv = [](const closed_form::PerfectGas& g) {
    return closed_form::specific_heat_cp(g) - g.gas_constant;
  };
  const auto truth = [=](double t) {
    const double x = std::min(t / step, pieces - 1e-6);
    const auto i = static_cast<std::size_t>(x);
    const double w = x - static_cast<double>(i);
    const double m = scale * ((*mass)[i] * (1.0 - w) + (*mass)[i + 1] * w);
    const double q = scale * ((*heat)[i] * (1.0 - w) + (*heat)[i + 1] * w);
    const double tank_temperature =
        (own_mass * cv(own) * test.initial_temperature + closed_form::specific_heat_cp(in) * q) /
        (own_mass * cv(own) + m * cv(in));
    const double p = (own_mass * own.gas_constant + m * in.gas_constant) * tank_temperature / test.volume;
    const double flow = scale * shape(t);
    return closed_form::TankTestReadings{
        p, flow > 0.0 ? closed_form::chamber_pressure(in, 1e-4, flow, temperature(t), p) : p, flow,
        temperature(t)};
  };
  return {test, truth, end, heat->back() / mass->back()};
}

inline History sine_squared(double start, double duration) {
  return [=](double t) {
    const double x = (t - start) / duration;
    return x > 0.0 && x < 1.0 ? std::pow(std::sin(std::numbers::pi * x), 2) : 0.0;
  };
}
/// Rises linearly, then decays.
inline History with_tail(double rise, double decay) {
  return [=](double t) { return t < rise ? t / rise : std::exp((rise - t) / decay); };
}
/// Flow that jumps on at `start` and falls to half over `duration`, where it jumps off.
inline History kinked(double start, double duration) {
  return [=](double t) {
    const double x = (t - start) / duration;
    return x >= 0.0 && x < 1.0 ? 1.0 - 0.5 * x : 0.0;
  };
}
/// Records of `pulse` with noise of full scale whose band of the mean temperature holds it, by average
/// temperature.
inline int records_with_the_mean(const Pulse& pulse, double noise, int readings, int seeds) {
  int inside = 0;
  for (int seed = 5000; seed < 5000 + seeds; ++seed) {
    Record record(pulse.truth, pulse.end, readings);
    record.add_full_scale_noise(noise, static_cast<unsigned>(seed));
    const gas::Identified found = gas::identify(
        pulse.test, record.average(), {.points = 201, .draws = 200, .noise = gas::Noise::of_full_scale});
    const auto [low, high] = found.mean_temperature_band;
    inside += low <= pulse.mean_temperature && pulse.mean_temperature <= high;
  }
  return inside;
}
inline History falling(double first, double last, double end) {
  return [=](double t) { return first + (last - first) * std::min(1.0, t / end); };
}

}  // namespace cases
