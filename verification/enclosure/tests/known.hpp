// SPDX-License-Identifier: Apache-2.0
// Tubes beside exact values.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "ball.hpp"
#include "enclosure/enclose.hpp"

namespace test {

using enclosure::Ball;

/// The decimal bounds of a column as exact as their text.
struct Known {
  Ball lower, upper;
};

inline Ball decimal(const std::string& text) {
  Ball x;
  EXPECT_EQ(arb_set_str(x.get(), text.c_str(), 4 * enclosure::bits), 0) << text;
  return x;
}

inline std::size_t column(const enclosure::Tube& tube, const std::string& name) {
  for (std::size_t i = 0; i < tube.columns.size(); ++i)
    if (tube.columns[i] == name) return i;
  ADD_FAILURE() << "no column " << name;
  return 0;
}

inline Known bounds_of(const enclosure::Tube& tube, std::size_t moment, const std::string& name) {
  const enclosure::Bounds& b = tube.moments.at(moment).bounds.at(column(tube, name));
  return {decimal(b.lower_text), decimal(b.upper_text)};
}

inline std::string text(const Ball& x) {
  char* s = arb_get_str(x.get(), 32, 0);
  const std::string result(s);
  flint_free(s);
  return result;
}

/// Expects `exact`, a thin ball, between the bounds of the last moment, and these no farther apart than
/// `width`.
inline void expect_contains(const enclosure::Tube& tube, const std::string& name, const Ball& exact,
                            double width) {
  const Known b = bounds_of(tube, tube.moments.size() - 1, name);
  EXPECT_FALSE((b.lower - exact).is_positive())
      << name << ": " << text(exact) << " is below " << text(b.lower);
  EXPECT_FALSE((exact - b.upper).is_positive())
      << name << ": " << text(exact) << " is above " << text(b.upper);
  EXPECT_LE((b.upper - b.lower).middle(), width * std::abs(exact.middle())) << name;
  const enclosure::Bounds& doubles = tube.moments.back().bounds.at(column(tube, name));
  EXPECT_FALSE((Ball(doubles.lower) - exact).is_positive() || (exact - Ball(doubles.upper)).is_positive())
      << name;
}

inline Ball pow(const Ball& x, const Ball& y) {
  Ball c;
  arb_pow(c.get(), x.get(), y.get(), enclosure::bits);
  return c;
}

inline Ball sqrt(const Ball& x) {
  return pow(x, Ball(0.5));
}

/// Numbers by seed.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double operator()(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }

 private:
  std::mt19937 engine_;
};

/// A gas of constant cp/R.
inline enclosure::Species gas(double molar_mass, double cp_over_r, const std::string& name = "gas") {
  return {.name = name, .molar_mass = molar_mass, .low = {cp_over_r}, .high = {cp_over_r}};
}

inline Ball gas_constant(double molar_mass) {
  return Ball(8.31446261815324) / Ball(molar_mass);
}

/// A closed tank of one gas: random volume, pressure and temperature.
inline enclosure::Scene tank(Draw& draw) {
  enclosure::Scene s;
  s.species = {gas(draw(0.004, 0.05), draw(2.6, 5.0))};
  s.initial_fractions = {1.0};
  s.initial_pressure = draw(1e5, 1e6);
  s.initial_temperature = draw(250.0, 1500.0);
  s.volume = {{0.0, draw(1e-3, 0.1)}};
  return s;
}

/// Numbers of a tank of one gas.
struct OneGas {
  explicit OneGas(const enclosure::Scene& s)
      : r(gas_constant(s.species[0].molar_mass)),
        gamma(Ball(s.species[0].low[0]) / (Ball(s.species[0].low[0]) - Ball(1.0))),
        p(s.initial_pressure),
        t(s.initial_temperature),
        v(s.volume.empty() ? 0.0 : s.volume[0].value),
        mass(p * v / (r * t)),
        cv(r / (gamma - Ball(1.0))) {}
  Ball r, gamma, p, t, v, mass, cv;
};

inline enclosure::Tube tube_at(const enclosure::Scene& scene, double time, double width = 1e-10) {
  return enclosure::enclose(scene, {.times = {time}, .width = width});
}

/// Asked for. The tests' exact values are 1e-30 wide. Wide bounds show what narrow ones hide behind the
/// rounding of doubles: steps are as long as their remainders allow, so that one too small misses the exact
/// value.
inline double width_of(unsigned seed) {
  return seed % 3 == 0 ? 1e-5 : 1e-10;
}

inline constexpr unsigned draws = 24, few = 3;  // few: of what takes long

}  // namespace test
