// SPDX-License-Identifier: Apache-2.0
#include "tank_test/smoothing_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "cases.hpp"

namespace {

using cases::relative;
using gas::SmoothingSpline;

struct Readings {
  std::vector<double> times, values;
};

/// 3 + sin(2 pi t) from t = 0.3 on: neither value nor slope is special at the ends.
Readings sine(int count, double noise, unsigned seed) {
  Readings readings;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < count; ++i) {
    const double t = 0.3 + i / (count - 1.0);
    readings.times.push_back(t);
    readings.values.push_back((3.0 + std::sin(2.0 * std::numbers::pi * t)) *
                              (1.0 + noise * normal(generator)));
  }
  return readings;
}

double slope_error(int count) {
  const Readings readings = sine(count, 0.0, 0);
  const SmoothingSpline spline(readings.times, readings.values);
  double largest = 0.0;
  for (const double reading : readings.times) {
    if (reading < 0.5 || reading > 1.1) continue;  // away from the ends, where the spline is freer
    // Off the readings: on breakpoints the slope of a quintic spline is of sixth order.
    const double t = reading + 0.3 / (count - 1.0);
    const double slope = evaluate(spline.basis(t), spline.coefficients()).slope;
    largest =
        std::max(largest, std::abs(slope - 2.0 * std::numbers::pi * std::cos(2.0 * std::numbers::pi * t)));
  }
  return largest;
}

/// Least squares in quintic splines: the slope is of fifth order in the interval of four readings.
TEST(smoothing_spline, slope_of_exact_readings_is_of_fifth_order) {
  double coarse = slope_error(41);
  for (const int count : {81, 161}) {
    const double fine = slope_error(count);
    // Where the largest error lies between breakpoints varies with the grid: half an order on either side.
    EXPECT_GT(std::log2(coarse / fine), 4.5) << count;
    EXPECT_LT(std::log2(coarse / fine), 5.5) << count;
    coarse = fine;
  }
}

/// Parabolas have no roughness: they are reproduced whatever lambda is. The normal equations of a quintic
/// B-spline basis have a condition number of about 1e5.
TEST(smoothing_spline, parabola_is_reproduced_from_unequal_times) {
  std::vector<double> times, values;
  for (int i = 0; i < 60; ++i) {
    times.push_back(0.01 * i + 0.0001 * i * i);
    values.push_back(2.0 - times.back() + 3.0 * times.back() * times.back());
  }
  const SmoothingSpline spline(times, values);
  for (const double t : {0.0, 0.123, 0.7, times.back()}) {
    const gas::SplinePoint point = evaluate(spline.basis(t), spline.coefficients());
    EXPECT_NEAR(point.value, 2.0 - t + 3.0 * t * t, 1e5 * cases::kEpsilon);
    EXPECT_NEAR(point.slope, 6.0 * t - 1.0,
                60.0 * 1e5 * cases::kEpsilon);  // 60: intervals and more per second
  }
}

/// Noise and smoothing come from the data: the estimate of sigma has the relative standard error
/// 1/sqrt(2 (N - tr H)) = 0.032; four of them.
TEST(smoothing_spline, noise_is_estimated_and_smoothing_follows_it) {
  double previous = 0.0;
  for (const double noise : {1e-4, 1e-3, 1e-2}) {
    const Readings readings = sine(501, noise, 7);
    const SmoothingSpline spline(readings.times, readings.values);
    EXPECT_LT(relative(spline.noise(), noise), 4.0 * 0.032) << noise;
    EXPECT_GT(spline.smoothing(), previous) << noise;
    EXPECT_GT(spline.degrees_of_freedom(), 3.0);
    EXPECT_LT(spline.degrees_of_freedom(), 501.0 / 8.0);  // it smooths
    previous = spline.smoothing();
  }
}

/// Noise that is a fraction of the reading: what is large is weighted down. 1 % of readings between 1 and 100
/// leaves the low end well determined; equal weights would leave it an error of the order of 0.1.
TEST(smoothing_spline, readings_are_weighted_by_their_size) {
  std::vector<double> times, values;
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  const auto truth = [](double t) { return 1.0 + 99.0 * std::pow(std::sin(std::numbers::pi * t), 4); };
  for (int i = 0; i <= 500; ++i) {
    times.push_back(i / 500.0);
    values.push_back(truth(times.back()) * (1.0 + 0.01 * normal(generator)));
  }
  const SmoothingSpline spline(times, values);
  for (const double t : {0.02, 0.05, 0.95, 0.98})
    // Each of these is the mean of ten readings or more around it: 0.01/sqrt(10), three of that.
    EXPECT_LT(relative(evaluate(spline.basis(t), spline.coefficients()).value, truth(t)), 0.0095) << t;
}

/// Draws scatter about the estimate as the posterior says: their deviation at a point against the square root
/// of b^T C b, by a route of its own (C from unit vectors). 400 draws: 1/sqrt(800) = 0.035 standard error,
/// four.
TEST(smoothing_spline, draws_scatter_as_the_posterior_does) {
  const Readings readings = sine(201, 0.01, 11);
  const SmoothingSpline spline(readings.times, readings.values);
  const std::size_t n = spline.coefficients().size();
  const gas::SplineBasis basis = spline.basis(0.8);
  const double centre = evaluate(basis, spline.coefficients()).value;
  std::vector<double> numbers(n + 1, 0.0), drawn(n), mean(n);
  spline.draw(numbers, 1.0, mean);
  double variance = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    numbers[k] = 1.0;
    spline.draw(numbers, 1.0, drawn);
    variance += std::pow(evaluate(basis, drawn).value - centre, 2);
    numbers[k] = 0.0;
  }
  // Between the two ends: one reading's noise, and the noise of all readings' mean.
  EXPECT_LT(std::sqrt(variance), spline.noise() * centre);
  EXPECT_GT(std::sqrt(variance), spline.noise() * centre / std::sqrt(201.0));
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  double sum = 0.0;
  for (int i = 0; i < 400; ++i) {
    for (double& number : numbers) number = normal(generator);
    spline.draw(numbers, 1.0, drawn);
    sum += std::pow(evaluate(basis, drawn).value - centre, 2);
  }
  EXPECT_LT(relative(std::sqrt(sum / 400.0), std::sqrt(variance)), 4.0 * 0.035);
}

TEST(smoothing_spline, bad_readings_are_named) {
  const auto refused = [](std::vector<double> times, std::vector<double> values, std::size_t index,
                          const std::string& series) {
    try {
      SmoothingSpline(times, values, "tank pressure");
      ADD_FAILURE() << "not refused: " << series;
    } catch (const gas::ReadingError& error) {
      EXPECT_EQ(error.index, index);
      EXPECT_EQ(error.series, series);
    }
  };
  const Readings good = sine(30, 0.0, 0);
  for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY), 1e-7}) {
    auto values = good.values;
    values[17] = bad;
    refused(good.times, values, 17, "tank pressure");
  }
  for (const double bad : {good.times[8], good.times[7], double(NAN)}) {
    auto times = good.times;
    times[9] = bad;
    refused(times, good.values, 9, "time");
  }
  const std::vector<double> few(19, 1.0);
  EXPECT_THROW(SmoothingSpline(few, few), std::invalid_argument);
  EXPECT_THROW(SmoothingSpline(good.times, few), std::invalid_argument);
}

/// GSL's own handler would end the process.
TEST(smoothing_spline, bad_arguments_are_named) {
  const Readings readings = sine(30, 0.01, 1);
  const SmoothingSpline spline(readings.times, readings.values);
  const auto refused = [](const std::string& name, const auto& call) {
    try {
      call();
      ADD_FAILURE() << "not refused: " << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).find(name), 0u) << error.what();
    }
  };
  const std::size_t n = spline.coefficients().size();
  std::vector<double> drawn(n), numbers(n + 1, 0.0), few(5, 0.0);
  for (const double bad : {double(NAN), double(INFINITY)}) {
    refused("time [s] = ", [&] { (void)spline.basis(bad); });
    refused("time [s] = ", [&] { (void)spline.roughness(bad); });
    refused("undersmoothing = ", [&] { spline.draw(numbers, bad, drawn); });
    auto wrong = numbers;
    wrong[3] = bad;
    refused("normal number = ", [&] { spline.draw(wrong, 1.0, drawn); });
  }
  refused("number of normal numbers = ", [&] { spline.draw(few, 1.0, drawn); });
  refused("number of coefficients = ", [&] { spline.draw(numbers, 1.0, few); });
  refused("number of coefficients = ", [&] { (void)evaluate(spline.basis(1.3), few); });
}

/// Noise that is the same over the record: readings below zero count like any other.
TEST(smoothing_spline, noise_of_full_scale_is_estimated) {
  std::vector<double> times, values;
  std::mt19937_64 generator(4);
  std::normal_distribution<double> normal;
  for (int i = 0; i <= 500; ++i) {
    times.push_back(i / 500.0);
    values.push_back(100.0 * std::pow(std::sin(std::numbers::pi * times.back()), 4) + normal(generator));
  }
  const SmoothingSpline spline(times, values, "reading", gas::Noise::of_full_scale);
  // Four standard errors 1/sqrt(2 (N - tr H)) and the largest reading's own noise.
  EXPECT_LT(relative(spline.noise(), 0.01), 4.0 * 0.033 + 0.03);
  for (const double t : {0.05, 0.3, 0.5, 0.8})
    EXPECT_LT(std::abs(evaluate(spline.basis(t), spline.coefficients()).value -
                       100.0 * std::pow(std::sin(std::numbers::pi * t), 4)),
              1.0)
        << t;
}

}  // namespace
