// SPDX-License-Identifier: Apache-2.0
#include "gas/species.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "cases.hpp"

// Gases of one's own by NASA-7 polynomials.
namespace {

using gas::Nasa7;

/// What a table of coefficients says.
struct Table {
  double molar_mass = 0.04, lowest = 200.0, highest = 6000.0;
  Nasa7 low{}, high{};
  gas::Species species() const { return gas::nasa7_species("own", molar_mass, lowest, highest, low, high); }
};

/// cp/R = least + k (T - 600 K)^2 up to 1000 K, constant above; h continuous.
Table dip(double least, double k = 2.5e-5) {
  Table table;
  table.low = {least + k * 360000.0, -1200.0 * k, k, 0.0, 0.0, 0.0, 4.0};
  const double t = 1000.0, cp = least + k * 160000.0,
               h = table.low[0] + t * (table.low[1] / 2.0 + t * k / 3.0);
  table.high = {cp, 0.0, 0.0, 0.0, 0.0, (h - cp) * t, 4.0};
  return table;
}

std::string message_of(const Table& table) {
  try {
    table.species();
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(own_species, restated_species_is_the_built_in_one) {
  for (const std::string& name : gas::species_names()) {
    const gas::Species s = gas::nasa7_species(name);
    const gas::Species own = gas::nasa7_species(name, s.molar_mass, 200.0, 6000.0, s.low, s.high);
    EXPECT_EQ(own.name, name);
    EXPECT_EQ(own.molar_mass, s.molar_mass);
    EXPECT_EQ(own.minimum_temperature, s.minimum_temperature);
    EXPECT_EQ(own.maximum_temperature, s.maximum_temperature);
    EXPECT_EQ(own.low, s.low);
    EXPECT_EQ(own.high, s.high);
    EXPECT_FALSE(own.constant_cp);
    EXPECT_EQ(gas::constant_cp_species(own, 400.0).low, gas::constant_cp_species(name, 400.0).low) << name;
  }
}

TEST(own_species, constant_cp_is_that_of_the_polynomial) {
  const gas::Species own = dip(2.0).species();
  EXPECT_NEAR(gas::constant_cp_species(own, 600.0).low[0], 2.0, 1e-14);
  EXPECT_NEAR(gas::constant_cp_species(own, 500.0).high[0], 2.25, 1e-14);
  EXPECT_THROW(gas::constant_cp_species(own, 199.0), std::invalid_argument);
  const gas::Species constant = gas::constant_cp_species("own", 300.0, 900.0);
  EXPECT_EQ(gas::constant_cp_species(constant, 1e5).low, constant.low);
}

/// The heat capacity is least inside of the range, at an end, or where a polynomial of degree 4 turns twice.
TEST(own_species, cp_is_above_R_in_the_whole_range) {
  EXPECT_EQ(message_of(dip(1.0001)), "accepted");
  EXPECT_EQ(message_of(dip(0.9999)).find("cp/R of low at "), 0u) << message_of(dip(0.9999));
  EXPECT_NE(message_of(dip(-3.0)).find("must be finite and above 1"), std::string::npos);
  Table falls = dip(2.0);  // 6 at 1000 K, by 0.001/K less above
  falls.high[0] += 1.0, falls.high[1] = -1e-3;
  falls.high[5] -= 500.0;  // what h/(R T) is off by, 1 - 1/2, times T
  EXPECT_EQ(message_of(falls).find("cp/R of high at 6000 K"), 0u) << message_of(falls);
  falls.highest = 5900.0;
  EXPECT_EQ(message_of(falls), "accepted");
  Table wave = dip(2.0);  // cp/R = 5 + 6 (x^4 - x^2), x = (T - 600)/400: the least 3.5, and twice
  const auto power = [](double a, int n) { return std::pow(a / 400.0, n); };
  for (const double depth : {6.0, 15.9, 16.1}) {
    wave.low = {5.0 + depth * (power(600.0, 4) - power(600.0, 2)),
                depth * (-4.0 * power(600.0, 3) + 2.0 * power(600.0, 1)) / 400.0,
                depth * (6.0 * power(600.0, 2) - 1.0) / 160000.0,
                depth * -4.0 * power(600.0, 1) / 6.4e7,
                depth / 2.56e10,
                0.0,
                0.0};
    double h = 0.0;
    for (int i = 5; i-- > 0;) h = wave.low[static_cast<std::size_t>(i)] / (i + 1.0) + 1000.0 * h;
    wave.high = {5.0, 0.0, 0.0, 0.0, 0.0, 1000.0 * (h - 5.0), 0.0};
    EXPECT_EQ(message_of(wave) == "accepted", depth < 16.0) << depth << message_of(wave);
  }
}

TEST(own_species, ranges_that_do_not_meet_are_refused) {
  Table cp = dip(2.0), h = dip(2.0);
  for (const double share : {0.9e-5, 1.1e-5}) {
    cp.high[0] = 6.0 * (1.0 + share);
    cp.high[5] = dip(2.0).high[5] - 6.0 * share * 1000.0;
    h.high[5] = dip(2.0).high[5] + 6.0 * share * 1000.0;
    EXPECT_EQ(message_of(cp) == "accepted", share < 1e-5) << message_of(cp);
    EXPECT_EQ(message_of(h) == "accepted", share < 1e-5) << message_of(h);
  }
  EXPECT_EQ(message_of(cp).find("jump of cp/R at 1000 K"), 0u) << message_of(cp);
  EXPECT_EQ(message_of(h).find("jump of h/(R T) at 1000 K"), 0u) << message_of(h);
}

TEST(own_species, numbers_out_of_range_are_refused) {
  const auto refused = [](const std::function<void(Table&)>& change) {
    Table table = dip(2.0);
    change(table);
    return message_of(table);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -0.04, nan})
    EXPECT_EQ(refused([&](Table& t) { t.molar_mass = bad; }).find("molar_mass"), 0u) << bad;
  for (const double bad : {0.0, 1000.0, nan})
    EXPECT_EQ(refused([&](Table& t) { t.lowest = bad; }).find("minimum temperature"), 0u) << bad;
  for (const double bad : {1000.0, std::numeric_limits<double>::infinity(), nan})
    EXPECT_EQ(refused([&](Table& t) { t.highest = bad; }).find("maximum temperature"), 0u) << bad;
  EXPECT_EQ(refused([&](Table& t) { t.high[6] = nan; }).find("NASA-7 coefficient"), 0u);
  EXPECT_EQ(refused([&](Table& t) { t.low[4] = 1e300; }).find("cp/R of low"), 0u);
}

}  // namespace
