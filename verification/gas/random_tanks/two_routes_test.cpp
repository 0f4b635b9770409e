// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "comparison.hpp"

// libgas against a second route that shares no code with it, on tanks of any kind.
namespace {

using namespace random_tanks;

const char* const kSpecies = GASJET_NASA7;
constexpr int kTanks = 300;

TEST(two_routes, agree_on_random_tanks) {
  const Tally tally = compare_seeds(1, kTanks, kSpecies);
  claim::expect_near({"G.10", "300 random tanks: largest error of p, T and m [100 tolerances of the tank]",
                      "errors of sub-steps add up"},
                     tally.worst_error, 0.0, 1.0);
  claim::expect_near(
      {"G.9", "300 random tanks: largest residual of mass or energy [-]", "some thousand roundings"},
      tally.worst_balance, 0.0, 1e-12);
  EXPECT_TRUE(tally.disagreeing.empty());
  EXPECT_EQ(tally.count(Verdict::too_stiff), 0);
  EXPECT_LE(tally.count(Verdict::undecided) + tally.count(Verdict::sensitive), 0.02 * kTanks);
  EXPECT_GE(tally.count(Verdict::refused_rightly), 1);
}

/// A plain tank with every kind of flow.
Tank vented_tank() {
  Tank tank;
  tank.tolerance = 1e-10;
  tank.gases = {{"N2"}, {"CO2"}};
  tank.start = tank.ambient = {1.0, 0.0};
  tank.pressure = tank.ambient_pressure = 101325.0;
  tank.temperature = tank.ambient_temperature = 300.0;
  tank.pulses.push_back({{0.4, 0.6}, {{0.0, 0.01, 0.03}, {0.0, 2.0, 0.0}}, {{0.0}, {900.0}}});
  tank.holes.push_back({0.8, 1e-3});
  tank.holes.back().backflow = true;
  tank.conductance = 20.0;
  tank.times = {0.0, 0.02, 0.05};
  tank.volumes = {0.03, 0.031, 0.05};
  tank.leak_areas = {1e-4, 1e-4, 2e-4};
  tank.bulges = {0.0, 1e-3};
  return tank;
}

TEST(two_routes, notice_any_other_number) {
  const Tank tank = vented_tank();
  const Comparison same = compare(tank, tank, kSpecies);
  EXPECT_EQ(same.verdict, Verdict::agrees) << same.error;
  const auto expect_noticed = [&](auto change) {
    Tank other = tank;
    change(other);
    const Comparison c = compare(tank, other, kSpecies);
    EXPECT_EQ(c.verdict, Verdict::disagrees) << c.error;
  };
  constexpr double kLarger = 1.0001;
  expect_noticed([](Tank& t) { t.holes[0].area *= kLarger; });
  expect_noticed([](Tank& t) { t.leak_areas[1] *= kLarger; });
  expect_noticed([](Tank& t) { t.conductance *= kLarger; });
  expect_noticed([](Tank& t) { t.bulges[1] *= kLarger; });
  expect_noticed([](Tank& t) { t.pulses[0].temperature.y[0] *= kLarger; });
  expect_noticed([](Tank& t) { t.pulses[0].mass_flow.y[1] *= kLarger; });
  expect_noticed([](Tank& t) { t.pulses[0].fractions = {0.4001, 0.5999}; });
}

// Two routes of which one steps in tolerances 1e-11 and 1e-12: both close to the law m = m_0/(1 + a t)^(2/(g
// - 1)) of a sonic blow-down at constant cp.
TEST(two_routes, second_one_meets_the_closed_form_of_a_blow_down) {
  Tank tank;
  tank.gases = {{"gas", 296.8, 1038.8}};
  tank.start = tank.ambient = {1.0};
  tank.pressure = 1e6;
  tank.temperature = 400.0;
  tank.ambient_pressure = 1e4;
  tank.ambient_temperature = 300.0;
  tank.holes.push_back({0.9, 1e-4});
  tank.times = {0.0, 0.1};
  tank.volumes = {0.01, 0.01};
  tank.leak_areas = {0.0, 0.0};
  tank.bulges = {0.0};
  const double g = 1.4, rt = 296.8 * 400.0, mass = 1e6 * 0.01 / rt;
  const double flow =
      0.9e-4 * 1e6 / std::sqrt(rt) * std::sqrt(g) * std::pow(2.0 / (g + 1.0), (g + 1.0) / (2.0 * g - 2.0));
  const double expected = mass * std::pow(1.0 + 0.5 * (g - 1.0) * flow / mass * 0.1, -2.0 / (g - 1.0));
  for (const double tolerance : {1e-11, 1e-12}) {
    const Outcome outcome = plain_route(tank, kSpecies, {tolerance});
    EXPECT_NEAR(outcome.samples.back().mass, expected, 100.0 * tolerance * expected);
  }
}

}  // namespace
