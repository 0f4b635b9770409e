// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>

#include "bisection.hpp"
#include "cases.hpp"
#include "claim.hpp"

// Temperature from internal energy: everywhere in the range, at its ends, and where the two NASA-7 ranges
// meet.
namespace {

using namespace cases;

gas::Mixture one_kilogram(const std::string& species) {
  return nasa7({species}).mixture(kPure);
}

/// u just above minus u at 1000 K [J/kg].
double jump(const gas::Mixture& gas) {
  gas::Mixture upper = gas;
  upper.low = gas.high;
  return upper.internal_energy(1000.0) - gas.internal_energy(1000.0);
}

TEST(temperature, inverts_internal_energy_from_any_guess) {
  std::map<std::string, gas::Mixture> gases;
  for (const std::string& name : gas::species_names()) gases.emplace(name, one_kilogram(name));
  const gas::Thermo thermo = nasa7({"N2", "O2", "Ar", "CO2", "H2O"});
  gases.emplace("air", thermo.mixture(thermo.mass_fractions_by_mole(gas::air_by_mole())));
  gases.emplace("exhaust", thermo.mixture(std::vector{0.4, 0.0, 0.0, 0.35, 0.25}));
  for (const auto& [name, gas] : gases) {
    for (const double t :
         {200.0, 200.001, 300.0, 800.0, 999.5, 1000.0, 1000.5, 1001.5, 3000.0, 5999.0, 6000.0}) {
      const double u = gas.internal_energy(t);
      // Rounding of u over cv; across the joint the lower root differs by |jump|/cv.
      const double scale = std::abs(u) + gas.cp(t) * t;
      const double tolerance = 100.0 * kEpsilon * scale / gas.cv(t) +
                               (std::abs(t - 1000.0) < 2.0 ? std::abs(jump(gas)) / gas.cv(t) : 0.0);
      for (const double guess : {200.0, 999.0, 1000.0, 1001.0, 1003.0, 6000.0, -5.0, 1e9})
        EXPECT_NEAR(gas.temperature(u, guess), t, tolerance) << name << " from " << guess;
    }
  }
}

/// The jumps of TM-4513's fits, computed from the published coefficients; two digits.
TEST(temperature, jumps_at_the_joint_are_those_of_the_fits) {
  const std::map<std::string, double> published{
      {"N2", -7.8e-4}, {"H2O", -0.03}, {"CH4", -0.06}, {"CO2", 0.006}};
  for (const auto& [name, value] : published)
    // Half a unit of the last digit quoted.
    EXPECT_NEAR(jump(one_kilogram(name)), value, value == -7.8e-4 ? 0.05e-4 : 0.0051) << name;
}

TEST(temperature, gap_at_the_joint_gives_1000_K) {
  const gas::Mixture gas = one_kilogram("CO2");  // u jumps up
  ASSERT_GT(jump(gas), 0.0);
  for (const double part : {0.1, 0.5, 0.9})
    EXPECT_EQ(gas.temperature(gas.internal_energy(1000.0) + part * jump(gas), 1000.0), 1000.0);
}

TEST(temperature, overlap_at_the_joint_gives_the_lower_root) {
  const gas::Mixture gas = one_kilogram("CH4");  // u jumps down
  ASSERT_LT(jump(gas), 0.0);
  const double u = gas.internal_energy(1000.0) + 0.5 * jump(gas);
  for (const double guess : {300.0, 999.9999, 1000.0, 1000.00001, 1500.0}) {
    const double t = gas.temperature(u, guess);
    EXPECT_LT(t, 1000.0);
    // Rounding of u over cv, as above.
    EXPECT_NEAR(gas.internal_energy(t), u, 100.0 * kEpsilon * (std::abs(u) + gas.cp(t) * t));
  }
}

/// How far T(u) leaps where two temperatures fit, and how much u it is 1000 K for where none does.
TEST(temperature, leap_and_gap_at_the_joint_eq_the_jump_of_the_fits) {
  const auto highest = [](const gas::Mixture& gas, auto&& passes) {  // u [J/kg], |u| well above the jump
    const double u = gas.internal_energy(1000.0), low = gas.internal_energy(999.0),
                 high = gas.internal_energy(1001.0);
    EXPECT_GT(std::abs(u), 1e5);
    return low - 1.0 + claim::largest_passing(1.0, high - low + 1.0, 1e-9, [&](double more) {
             return passes(gas.temperature(low - 1.0 + more, 1000.0));
           });
  };
  // Bisection to 1e-9 of some 1 kJ/kg, and rounding of u, 1e5 to 1e7 J/kg: 1e-6 to 1e-8 J/kg, of jumps of
  // 6e-3 and 0.06.
  const gas::Mixture carbon_dioxide = one_kilogram("CO2"), methane = one_kilogram("CH4");
  const double gap = highest(carbon_dioxide, [](double t) { return t <= 1000.0; }) -
                     highest(carbon_dioxide, [](double t) { return t < 1000.0; });
  const char* past =
      "T = 1000 K in a gap, the lower root in an overlap; the search is bracketed and cannot cycle";
  claim::expect_threshold(
      {"G.4", "CO2, u at 1000 K jumps up: gap", "rounding of u over the jump, and its bisection"},
      {"cp joint", "jump Δu of the fits at 1000 K", jump(carbon_dioxide), gap, "J/kg", past}, 0.999, 1.001);
  const double top = highest(methane, [](double t) { return t < 1000.0; });
  const double leap = methane.temperature(top + 1e-5, 1000.0) - methane.temperature(top - 1e-5, 1000.0);
  claim::expect_threshold(
      {"G.4", "CH4, u at 1000 K jumps down: leap of T", "the two sides are 2e-5 J/kg apart"},
      {"cp joint", "|Δu|/c_v", -jump(methane) / methane.cv(1000.0), leap, "K", past}, 0.998, 1.002);
}

TEST(temperature, outside_the_range_is_an_error) {
  for (const std::string& name : gas::species_names()) {
    const gas::Mixture gas = one_kilogram(name);
    for (const double guess : {200.0, 1000.0, 6000.0}) {
      EXPECT_THROW(gas.temperature(gas.internal_energy(200.0) - 1.0, guess), gas::DomainError) << name;
      EXPECT_THROW(gas.temperature(gas.internal_energy(6000.0) + 1.0, guess), gas::DomainError) << name;
    }
    EXPECT_THROW(gas.temperature(std::nan(""), 300.0), gas::DomainError);
  }
  const gas::Thermo constant = nitrogen();
  EXPECT_THROW(constant.temperature_from_internal_energy(kPure, -1.0, 300.0), gas::DomainError);
  EXPECT_LT(relative(constant.temperature_from_internal_energy(kPure, 742e6, 300.0), 1e6), 8.0 * kEpsilon);
}

}  // namespace
