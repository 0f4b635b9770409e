// SPDX-License-Identifier: Apache-2.0
// Units by name: their numbers in SI, and the lists in refusals.
#include "base/named_units.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

TEST(named_units, are_the_numbers_written_in_si) {
  const auto si = [](const char* name, const char* unit, double number) {
    return driver::unit_named(name, unit).to_si(number);
  };
  // As the decimal number nearest to it.
  EXPECT_EQ(si("ms", "s", 35.0), 0.035);
  EXPECT_EQ(si("µs", "s", 35.0), 35e-6);
  EXPECT_EQ(si("kPa", "Pa", 101.325), 101325.0);
  EXPECT_EQ(si("g/ms", "kg/s", 3.3), 3.3);
  EXPECT_EQ(si("mm²", "m²", 700.0), 700e-6);
  EXPECT_EQ(si("l", "m³", 60.0), 0.06);
  EXPECT_EQ(si("L", "m3", 60.0), 0.06);
  EXPECT_EQ(si("%", "", 7.0), 0.07);
  EXPECT_EQ(si("N·mm", "N m", 7.0), 7e-3);
  // Fixed points of the scales of temperature, and definitions of inch and pound.
  EXPECT_NEAR(si("degF", "K", 32.0), 273.15, 1e-13);
  EXPECT_NEAR(si("°F", "K", 212.0), 373.15, 2e-13);
  EXPECT_NEAR(si("in2", "m2", 1.0), 0.0254 * 0.0254, rounding * 1e-3);
  EXPECT_NEAR(si("psi", "Pa", 1.0), 0.45359237 * 9.80665 / (0.0254 * 0.0254), 4.0 * rounding * 6895.0);
  const auto pressure = [](const char* name, driver::PressureZero zero) {
    return driver::unit_named(name, "Pa", zero, 100e3).to_si(50.0);
  };
  using driver::PressureZero;
  EXPECT_EQ(pressure("kPa", PressureZero::vacuum), 50e3);
  EXPECT_EQ(pressure("kPa absolute", PressureZero::vacuum), 50e3);
  EXPECT_EQ(pressure("kPa gauge", PressureZero::vacuum), 150e3);
  EXPECT_EQ(pressure("barg", PressureZero::vacuum), 5.1e6);
  EXPECT_EQ(pressure("kPa", PressureZero::ambient), 50e3);
  EXPECT_EQ(pressure("kPa gauge", PressureZero::ambient), 50e3);
  EXPECT_EQ(pressure("kPa absolute", PressureZero::ambient), -50e3);
  EXPECT_EQ(pressure("bara", PressureZero::ambient), 4.9e6);
  EXPECT_THROW(pressure("kPa gauge", PressureZero::none), std::invalid_argument);
  EXPECT_THROW(driver::unit_named("psig", "Pa", PressureZero::vacuum), std::invalid_argument);
  EXPECT_THROW(driver::unit_named("s gauge", "s"), std::invalid_argument);
  EXPECT_THROW(driver::unit_named("", "s"), std::invalid_argument);
}

TEST(named_units, that_are_allowed_are_listed) {
  const auto refusal = [](const char* name, const char* si, driver::PressureZero zero) {
    try {
      driver::unit_named(name, si, zero);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using driver::PressureZero;
  EXPECT_EQ(refusal("min", "s", PressureZero::vacuum), "is \"min\", allowed: s, ms, us");
  EXPECT_EQ(refusal("kPa gauge", "s", PressureZero::vacuum), "is \"kPa gauge\", allowed: s, ms, us");
  EXPECT_EQ(refusal("km", "Pa", PressureZero::none),
            "is \"km\", allowed: Pa, hPa, kPa, MPa, GPa, mbar, bar, atm, psi");
  EXPECT_EQ(refusal("km", "Pa", PressureZero::vacuum),
            "is \"km\", allowed: Pa, hPa, kPa, MPa, GPa, mbar, bar, atm, psi, also with gauge or absolute");
  // Quantities without other units have their own.
  for (const char* si : {"W", "N s", "kg K/s", "m/s²"}) {
    EXPECT_EQ(refusal(si, si, PressureZero::vacuum), "accepted");
    EXPECT_EQ(driver::unit_named(si, si).to_si(7.5), 7.5);
  }
  EXPECT_EQ(refusal("kW", "W", PressureZero::vacuum), "is \"kW\", allowed: W");
}

}  // namespace
