// SPDX-License-Identifier: Apache-2.0
// The channel filter against its published frequency response, and that it shifts nothing.
#include "engine/channel_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "claim.hpp"
#include "coupling/sphere_contact.hpp"

namespace {

using std::numbers::pi;

// Gain of a sine after the ends have died away.
double gain(double frequency, double channel_class, double interval) {
  const int count = static_cast<int>(40.0 / (std::min(frequency, channel_class) * interval));
  std::vector<double> samples;
  for (int n = 0; n < count; ++n) samples.push_back(std::sin(2.0 * pi * frequency * interval * n));
  const auto filtered = driver::channel_filter(samples, interval, channel_class);
  // Projection on the sine: a phase would show as a loss. Without one every window gives the gain, once the
  // ends have died away: they have by exp(-0.7 w_c 10/f) < 1e-38.
  double in = 0.0, out = 0.0;
  for (int n = count / 4; n < 3 * count / 4; ++n) {
    const auto i = static_cast<std::size_t>(n);
    in += samples[i] * samples[i];
    out += samples[i] * filtered[i];
  }
  return out / in;
}

TEST(channel_filter, response_eq_published) {
  for (const double channel_class : {60.0, 180.0, 600.0, 1000.0}) {
    const double interval = 1e-5, corner = 2.0775 * channel_class;
    for (const double part : {0.1, 0.5, 1.0, 2.0, 4.0}) {
      const double frequency = part * channel_class;
      // The bilinear transform bends the frequency axis: tan(pi f T) for f, about the corner.
      const double bent = std::tan(pi * frequency * interval) / std::tan(pi * corner * interval);
      claim::expect_near({"K.22", "channel filters CFC 60 to 1000: gain by frequency [-]",
                          "poles close to 1: roundings of two passes times 1/(w_c T)^2 = 7e4"},
                         gain(frequency, channel_class, interval), 1.0 / (1.0 + std::pow(bent, 4)), 3e-11);
    }
    // SAE J211-1: flat to 0.5 dB up to the class, -3 dB (+0.5, -1) at 1.65 times it, falling by 24 dB an
    // octave.
    const auto decibel = [&](double part) {
      return 20.0 * std::log10(gain(part * channel_class, channel_class, interval));
    };
    // The cut-off is CFC/0.6, as 2.0775 0.6 = (sqrt 2 - 1)^(-1/4); the bent axis moves it by (pi f_c T)^2 / 3
    // at most.
    EXPECT_NEAR(gain(channel_class / 0.6, channel_class, interval), std::sqrt(0.5), 1.5e-3);
    EXPECT_NEAR(decibel(0.5), 0.0, 0.5);
    EXPECT_NEAR(decibel(1.65), -3.0, 0.5);
    EXPECT_NEAR(decibel(4.0) - decibel(8.0), 24.0, 3.0);
  }
}

TEST(channel_filter, constants_and_slopes_pass_and_a_pulse_stays_where_it_is) {
  std::vector<double> constant(2000, 7.0), slope, pulse(2001, 0.0);
  for (int n = 0; n < 2000; ++n) slope.push_back(0.01 * n);
  pulse[1000] = 1.0;
  // Poles that close to 1 amplify a rounding by 1/(pi 374 Hz 1e-5 s)^2 a pass: 2 x 7 eps x 7e3.
  for (const double y : driver::channel_filter(constant, 1e-5, 180.0)) EXPECT_NEAR(y, 7.0, 2.2e-11);
  const auto ramp = driver::channel_filter(slope, 1e-5, 180.0);
  EXPECT_NEAR(ramp[1000], 10.0, 1e-3);  // the ends, 10 ms off, ring with exp(-0.7 w_c t) = exp(-16)
  const auto spread = driver::channel_filter(pulse, 1e-5, 180.0);
  double sum = 0.0;
  for (const double y : spread) sum += y;
  EXPECT_NEAR(sum, 1.0, 1e-5);
  for (std::size_t n = 1; n < 300; ++n) EXPECT_NEAR(spread[1000 - n], spread[1000 + n], 1e-12) << n;
}

TEST(channel_filter, peak_of_a_slow_signal_at_uneven_times_is_kept) {
  driver::VectorSignal signal;
  for (double t = 0.0; t < 0.1; t += 2e-5 * (1.5 + std::sin(1e3 * t))) {
    signal.time.push_back(t);
    signal.first.push_back(30.0 * std::sin(2.0 * pi * 20.0 * t));
    signal.second.push_back(40.0 * std::sin(2.0 * pi * 20.0 * t));
  }
  // 20 Hz through CFC 180: 1 - (20/374)^4; linear resampling: (2 pi 20 5e-5)^2 / 8.
  EXPECT_NEAR(driver::filtered_peak(signal, 180.0), 50.0, 50.0 * 2e-5);
  EXPECT_EQ(driver::filtered_peak({}, 180.0), 0.0);
}

// Acceleration [m/s2] in three components that have the resultant of `at`, in steps of 1e-5 s.
template <class Resultant>
driver::VectorSignal head_of(double end, Resultant at) {
  driver::VectorSignal signal;
  for (int n = 0; n * 1e-5 <= end; ++n) {
    const double a = at(n * 1e-5);
    signal.time.push_back(n * 1e-5);
    signal.first.push_back(a * 2.0 / 7.0);
    signal.second.push_back(a * 3.0 / 7.0);
    signal.third.push_back(a * 6.0 / 7.0);
  }
  return signal;
}

TEST(head_injury, of_a_half_sine_and_a_constant_follow_their_closed_forms) {
  constexpr double g = 9.80665, peak = 80.0;
  // Of a half sine of T: T A^2.5 times the largest of (2 sin(pi x / 2) / (pi x))^2.5 x, 0.4146 at x = 0.6702.
  for (const double duration : {0.01, 0.02}) {
    const auto pulse = head_of(0.06, [&](double t) {
      return t < 0.01 || t > 0.01 + duration ? 0.0 : peak * g * std::sin(pi * (t - 0.01) / duration);
    });
    claim::expect_relative({"K.58", "head injury criterion of a half sine of 80 g, intervals of up to 15 ms",
                            "the filter of class 1000 and intervals of whole 0.1 ms"},
                           driver::head_injury_criterion(pulse, 0.015),
                           0.414646 * duration * std::pow(peak, 2.5), 2e-3);
  }
  const auto constant = head_of(0.1, [&](double) { return 60.0 * g; });
  for (const double window : {0.015, 0.036})
    claim::expect_relative(
        {"K.58", "head injury criterion of a constant 60 g: window times 60^2.5", "rounding"},
        driver::head_injury_criterion(constant, window), window * std::pow(60.0, 2.5), 1e-9);
  EXPECT_EQ(driver::head_injury_criterion({}, 0.015), 0.0);
}

// --- free skin that arrives at the impactor: peaks by the contact's stiffness

constexpr double kSide = 0.04, kSpeed = 5.0, kDensity = 0.31;  // [m] [m/s] [kg/m2]
constexpr double kSample = 1e-6;                               // [s] the step too

// Force [N] on a sphere so large that a square of free skin meets it all at once, 20 ms before and after.
std::vector<double> arrival(double stiffness) {
  constexpr double radius = 1e5;
  const Eigen::Matrix3Xi triangles{{0, 0}, {1, 2}, {2, 3}};
  Eigen::Matrix3Xd x{{0.0, kSide, kSide, 0.0}, {0.0, 0.0, kSide, kSide}, {0.0, 0.0, 0.0, 0.0}};
  const double sixth = kDensity * kSide * kSide / 6.0;
  const double masses[] = {2.0 * sixth, sixth, 2.0 * sixth, sixth};
  const coupling::ContactModel contact(triangles, x, masses, 8.41, {coupling::Sphere{radius}, stiffness});
  auto cache = contact.make_state();
  Eigen::RowVector4d speed = Eigen::RowVector4d::Constant(kSpeed);
  std::vector<double> force(40000, 0.0);
  for (std::size_t n = 20000; n < force.size(); ++n) {
    Eigen::Matrix3Xd f = Eigen::Matrix3Xd::Zero(3, 4);
    force[n] = contact.evaluate(cache, x, {{0.5 * kSide, 0.5 * kSide, radius + 1e-5}}, f).force.z();
    for (int a = 0; a < 4; ++a) speed[a] += kSample * f(2, a) / masses[a];
    x.row(2) += kSample * speed;
  }
  return force;
}

// Behind CFC 180, by the spectrum of a half sine that lasts T: J cos(pi f T) / (1 - (2 f T)^2).
double filtered_half_sine(double impulse, double duration) {
  double sum = 0.0;
  for (double f = 0.5; f < 4e4; f += 1.0)
    sum += 2.0 / (1.0 + std::pow(f / (2.0775 * 180.0), 4)) * std::cos(pi * f * duration) /
           (1.0 - std::pow(2.0 * f * duration, 2));
  return impulse * sum;
}

TEST(channel_filter, peak_of_arriving_skin_follows_the_stiffness_raw_and_the_impulse_filtered) {
  const double area = kSide * kSide, impulse = 2.0 * kDensity * kSpeed * area;
  std::vector<double> filtered;
  for (const double stiffness : {1.67e8, 3.35e8, 13.4e8}) {  // half, once and four times the default
    const auto force = arrival(stiffness);
    const double rate = std::sqrt(stiffness / kDensity), tolerance = std::pow(rate * kSample, 2) + 1e-4;
    const char* why = "(omega dt)^2, of entry and exit within a step";
    double given = 0.0;
    for (const double f : force) given += f * kSample;
    claim::expect_relative(
        {"K.23", "free skin arrives at the impactor, three stiffnesses: raw peak [N]", why},
        *std::max_element(force.begin(), force.end()), kSpeed * std::sqrt(stiffness * kDensity) * area,
        tolerance);
    claim::expect_relative({"K.23", "the same: impulse [N s]", why}, given, impulse, tolerance);
    const auto channel = driver::channel_filter(force, kSample, 180.0);
    filtered.push_back(*std::max_element(channel.begin(), channel.end()));
    claim::expect_relative({"K.23", "the same: peak filtered with CFC 180 [N]", why}, filtered.back(),
                           filtered_half_sine(impulse, pi / rate), tolerance);
  }
  // Raw peaks are as 1 to 2.83; a filter whose corner is at f_c sees (f_c T)^2 = 0.3 % of that.
  EXPECT_NEAR(filtered.back() / filtered.front(), 1.0, 1e-2);
}

TEST(channel_filter, bad_class_or_interval_is_named) {
  const std::vector<double> samples(10, 1.0);
  EXPECT_THROW(driver::channel_filter(samples, 1e-5, 0.0), std::invalid_argument);
  EXPECT_THROW(driver::channel_filter(samples, 1e-5, std::nan("")), std::invalid_argument);
  EXPECT_THROW(driver::channel_filter(samples, 0.0, 180.0), std::invalid_argument);
  EXPECT_THROW(driver::channel_filter(samples, 1e-3, 180.0), std::invalid_argument);  // 1 kHz for 180
}

}  // namespace
