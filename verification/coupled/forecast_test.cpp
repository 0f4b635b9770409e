// SPDX-License-Identifier: Apache-2.0
// The forecast's groups by hand, and the paths and strings of settings that `check --format json` is made of.
#include "forecast/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/membrane.hpp"
#include "results/load_scene.hpp"
#include "run_case.hpp"

namespace {

struct Forecasted {
  driver::Forecast forecast;
  std::map<std::string, double> group;
};

Forecasted forecasted(const char* name, const std::vector<std::string>& overrides = {}) {
  const auto scene = coupled::scene_of(name, overrides);
  Forecasted r{driver::forecast(scene, driver::state_at_start(scene)), {}};
  for (const auto& g : r.forecast.groups) r.group[g.name] = g.value;
  return r;
}

// The built-in nitrogen: 0.028014 kg/mol, and its cp at 298.15 K by TM-4513's coefficients, eight digits.
constexpr double kR = 8.31446261815324 / 0.028014, kCp = 1039.6296, kGamma = kCp / (kCp - kR), kDigits = 1e-7;

TEST(forecast, pressure_of_the_full_volume_by_hand) {
  // p0 + gamma R T mdot t / V of the model nitrogen; no opening, no leak.
  const Forecasted tank = forecasted("rigid_tank");
  claim::expect_relative(
      {"K.30", "case rigid_tank: pressure of the full volume over ambient [-]", "ten roundings"},
      tank.group.at("full_pressure"), 1.0 + 1.4 * 296.8 * 700.0 * 0.1 / 0.06 / 101325.0, 1e-14);
  EXPECT_FALSE(tank.group.contains("vent_leak"));
  // The bag's volume stays: 0.0075 + 0.002 kg at 600 K into the icosphere's 0.99139384262975479 of a sphere
  // of 0.2 m.
  const Forecasted bag = forecasted("jet_bag");
  const double volume = 0.99139384262975479 * 4.0 / 3.0 * M_PI * 0.008;
  claim::expect_relative(
      {"K.30", "case jet_bag: pressure of the full volume over ambient [-]", "eight digits of cp"},
      bag.group.at("full_pressure"), 1.0 + kGamma * kR * 600.0 * 0.0095 / volume / 101325.0, kDigits);
  // E h / (1 - nu) = 42857 N/m.
  claim::expect_relative(
      {"K.36", "case jet_bag: stiffness of the gas over the fabric's [-]", "eight digits of cp"},
      bag.group.at("fabric_stretch"),
      1.5 * kGamma * bag.forecast.full->pressure * std::cbrt(0.75 * volume / M_PI) / (60e6 * 0.5e-3 / 0.7),
      kDigits);
}

TEST(forecast, full_volume_of_a_flat_design_is_that_of_its_balloon) {
  // Discs of 0.35 m, cut as polygons of 84 corners.
  const double discs = 42.0 / M_PI * std::sin(M_PI / 42.0);
  claim::expect_relative({"K.30", "case driver_bag, flat: full volume [m3]", "eight digits of the constant"},
                         forecasted("driver_bag").forecast.full->volume,
                         closed_form::mylar_balloon(0.35).volume * std::pow(discs, 1.5), 2e-8);
}

TEST(forecast, full_volume_that_follows_its_pressure_eq_closed_form) {
  const Forecasted bag = forecasted(
      "bag_volume",
      {"gas.initial.composition={N2=1.0}", "tank.volume={overpressure=[0.0, 1e6], value=[0.06, 0.56]}"});
  const closed_form::SpringBag spring{{kR, kGamma}, 101325.0, 293.15, 0.06, 5e-7};
  const auto exact = closed_form::spring_bag_fill(spring, 0.16, 406.0);  // the case's triangle of inflow
  claim::expect_relative(
      {"K.30", "case bag_volume, a curve of two knots: closed pressure [Pa]", "eight digits of cp"},
      bag.forecast.full->closed_pressure, exact.pressure, kDigits);
  EXPECT_NEAR(bag.forecast.full->volume, exact.volume, kDigits * exact.volume);
}

TEST(forecast, balance_and_choking_by_hand) {
  // The fabric takes the whole flow: C sqrt(2 rho (p - p_a)) = mdot with C = 0.05^2 x 1.5 m2.
  const Forecasted stiff = forecasted("tank_stiff");
  const double c = 0.0025 * 1.5, rho_dp = std::pow(0.02 / c, 2) / 2.0;
  const double inviscid = 0.5 * (std::sqrt(101325.0 * 101325.0 + 4.0 * rho_dp * kR * 406.0) - 101325.0);
  const double excess = inviscid * (1.0 + 1.5 * std::pow(1e-8 * 101325.0 / inviscid, 2));  // (G.22)
  claim::expect_relative(
      {"K.31", "case tank_stiff: overpressure in balance [Pa]", "ten roundings of p, 6000 times p - p_a"},
      stiff.forecast.full->pressure - 101325.0, excess, 1e-11);
  claim::expect_relative({"K.33", "case tank_stiff: outflow of the fabric over the peak inflow [-]",
                          "ten roundings of p, 6000 times p - p_a"},
                         stiff.group.at("fabric_leak"), 1.0, 1e-11);
  // lambda = mdot/m (b + sqrt(b^2 - 4 gamma n))/2, b = 1/2 + gamma (n + 1/2), over a step of 1 ms: of the
  // full volume, where n = 1/2 + p/(2 (p - p_a)); of the start where that is nearly empty, choked.
  const auto relaxations = [](double flow, double mass, double gamma, double n) {
    const double b = 0.5 + gamma * (n + 0.5);
    return 1e-3 * flow / mass * 0.5 * (b + std::sqrt(b * b - 4.0 * gamma * n));
  };
  const double pressure = 101325.0 + excess;
  claim::expect_relative(
      {"K.37", "case tank_stiff: relaxations of the gas in a step [-]",
       "eight digits of cp; ten roundings of p, 6000 times p - p_a"},
      stiff.group.at("gas_relaxation"),
      relaxations(0.02, pressure * 1e-4 / (kR * 406.0), kGamma, 0.5 + 0.5 * pressure / excess), kDigits);
  claim::expect_relative(
      {"K.37", "case tank_stiff from 10 Pa: relaxations of the gas in a step [-]", "eight digits of cp"},
      forecasted("tank_stiff", {"gas.initial.pressure=10.0"}).group.at("gas_relaxation"),
      relaxations(0.02, 10.0 * 1e-4 / (kR * 293.15), kGamma, 1.0), kDigits);
  claim::expect_relative({"K.32", "case tank_blowdown: pressure over the choking one [-]", "ten roundings"},
                         forecasted("tank_blowdown").group.at("vent_choking"),
                         5e5 / 101325.0 * 0.52828178771717411, 1e-14);
}

TEST(forecast, relaxations_of_the_scene_by_hand) {
  // A constant flow for 20 steps of 1 ms.
  const std::vector<std::string> rigid{"tank.volume=1e-4"};
  const Forecasted stiff = forecasted("tank_stiff", rigid);
  claim::expect_relative(
      {"K.39", "case tank_stiff: relaxations of the gas in the whole scene [-]", "400 roundings"},
      stiff.group.at("gas_relaxations_in_scene"), 20.0 * stiff.group.at("gas_relaxation"), 1e-13);
}

// A method that is explicit throughout takes as many sub-steps, at its limit; the gas of the start is lighter
// than that of the balance.
TEST(forecast, explicit_methods_take_their_substeps) {
  for (const char* method : {"euler", "runge_kutta"}) {
    const std::vector<std::string> set{"tank.volume=1e-4", "time.gas_method=\"" + std::string(method) + "\""};
    const auto scene = coupled::scene_of("tank_stiff", set);
    const double told = driver::gas_substeps(scene, forecasted("tank_stiff", set).forecast.full->relaxations);
    const double share =
        static_cast<double>(coupled::run_case("tank_stiff", set).state.flows.gas_substeps) / told;
    EXPECT_GT(share, 0.9) << method;
    EXPECT_LT(share, 1.1) << method;
  }
}

TEST(forecast, advises_the_implicit_gas_method) {
  const auto advice = [](const std::string& method, std::vector<std::string> set) {
    set.push_back("time.gas_method=\"" + method + "\"");
    const auto scene = coupled::scene_of("tank_stiff", set);
    return driver::gas_advice(scene, driver::forecast(scene, driver::state_at_start(scene)));
  };
  const std::string wide = "tank.fabric.area=15.0", wider = "tank.fabric.area=50.0";
  EXPECT_EQ(advice("runge_kutta", {}), "");
  EXPECT_EQ(advice("dormand_prince", {wider}), "");
  EXPECT_EQ(advice("rosenbrock", {wider}), "");
  // Fixed sub-steps are taken, or an error.
  EXPECT_EQ(advice("runge_kutta", {wider, "unset time.gas_tolerance", "time.gas_step=1e-9"}), "");
  const std::string dear = advice("runge_kutta", {wide}), ends = advice("runge_kutta", {wider});
  EXPECT_NE(dear.find("some 7e+05 sub-steps"), std::string::npos) << dear;
  EXPECT_EQ(dear.find("the run ends"), std::string::npos) << dear;
  // 4e5 in a step of 1 ms, where one call may take 1e5: so it does.
  EXPECT_NE(ends.find("the run ends"), std::string::npos) << ends;
  const auto run = coupled::run_case("tank_stiff", {"time.gas_method=\"runge_kutta\"", wider});
  EXPECT_NE(run.outcome.message.find("100001 sub-steps"), std::string::npos) << run.outcome.message;
}

TEST(forecast, jet_and_mesh_by_hand) {
  // A triangle of flow: sonic from mdot* on, a share 1 - (mdot*/mdot_p)^2 of its mass.
  const Forecasted bag = forecasted("jet_bag");
  const double t = 2.0 * 600.0 / (kGamma + 1.0), v = std::sqrt(kGamma * kR * t), area = M_PI * 4e-4;
  const double least = 101325.0 / (kR * t) * v * area;
  claim::expect_near({"K.34", "case jet_bag: gas that leaves below ambient outlet pressure [-]",
                      "half of 4000 pieces at each of two crossings"},
                     bag.group.at("below_sonic_0"), least * least, 2e-4);
  claim::expect_relative(
      {"K.35", "case jet_bag: jet over pressure on the bag [-]", "eight digits of cp"},
      bag.group.at("jet_on_bag_0"),
      2.0 * 1.0 * v /
          ((bag.forecast.full->pressure - 101325.0) * std::pow(bag.forecast.full->volume, 2.0 / 3.0)),
      kDigits);
  const Forecasted scene = forecasted("passenger_pendulum");
  // 0.54923 + 0.36138 + 0.35948 + 0.027779 + 0.0018993 m2 in 2744 elements, the impactor 82 mm wide.
  claim::expect_relative(
      {"K.38", "case passenger_pendulum: (element side / impactor)^2 [-]", "five digits of the areas"},
      scene.group.at("contact_mesh"), 4.0 * 1.2997683 / (std::sqrt(3.0) * 2744.0) / (0.082 * 0.082), 1e-5);
  EXPECT_GT(scene.group.at("jet_on_impactor_0"), 0.1);
}

TEST(forecast, verdicts_and_cases_without_groups) {
  const driver::Group size{"a", "K.33", "", 0.1, true}, number{"a", "K.31", "", 5.0, false};
  EXPECT_STREQ(driver::verdict(size), "matters");
  EXPECT_STREQ(driver::verdict({"a", "K.33", "", 0.0999, true}), "shows");
  EXPECT_STREQ(driver::verdict({"a", "K.33", "", 0.00999, true}), "negligible");
  EXPECT_STREQ(driver::verdict({"a", "K.35", "", INFINITY, true}), "matters");
  EXPECT_STREQ(driver::verdict(number), "");
  EXPECT_TRUE(forecasted("pendulum_swing").forecast.groups.empty());
  EXPECT_GT(forecasted("driver_bag").group.at("full_pressure"),
            1.0);  // its design shape is flat, without volume
}

TEST(forecast, too_little_gas_does_not_fill_the_volume) {
  const Forecasted bag = forecasted("jet_bag", {"gas.initial.pressure=1e3", "scene.end_time=1e-3"});
  EXPECT_FALSE(bag.forecast.full->fills);
  EXPECT_LT(bag.forecast.full->closed_pressure, 101325.0);
  for (const char* name : {"full_pressure", "jet_on_bag_0", "fabric_stretch"})
    EXPECT_FALSE(bag.group.contains(name)) << name;
  EXPECT_TRUE(bag.group.contains("below_sonic_0"));
  // Nothing flows in: the state of the start, be it below ambient; a flattened bag keeps its volume.
  const Forecasted empty = forecasted("tank_blowdown", {"gas.initial.pressure=5e4"});
  EXPECT_EQ(empty.group.at("full_pressure"), 5e4 / 101325.0);
  const Forecasted flat = forecasted("passenger_pendulum", {"unset inflator"});
  const auto scene = coupled::scene_of("passenger_pendulum", {"unset inflator"});
  EXPECT_EQ(flat.forecast.full->volume, driver::state_at_start(scene).bag->surface.volume);
}

TEST(forecast, peak_flow_may_stand_at_the_end) {
  // Both flows rise at 4.5 ms: 1 kg/s x 4.5/5 + 0.5 kg/s x 0.5/4; a few roundings.
  EXPECT_NEAR(forecasted("jet_bag", {"scene.end_time=4.5e-3"}).forecast.supply.peak_flow, 0.9625, 1e-14);
  // The second has not begun at 3 ms; the first is at 0.6 kg/s, sonic.
  const Forecasted bag = forecasted("jet_bag", {"scene.end_time=3e-3"});
  const double velocity = std::sqrt(kGamma * kR * 2.0 * 600.0 / (kGamma + 1.0));
  const double excess = bag.forecast.full->pressure - 101325.0;
  const double force = excess * std::pow(bag.forecast.full->volume, 2.0 / 3.0);
  EXPECT_NEAR(bag.group.at("jet_on_bag_0"), 2.0 * 0.6 * velocity / force,
              kDigits * bag.group.at("jet_on_bag_0"));
  EXPECT_FALSE(bag.group.contains("below_sonic_1"));
  // Past the peak the end changes nothing.
  EXPECT_EQ(forecasted("passenger_pendulum", {"scene.end_time=0.05"}).forecast.supply.peak_flow, 4.0);
}

TEST(setting_path, splits_and_quotes_any_key) {
  const auto parts = driver::split_path("inflator.0.composition.\"a/b.~\\\"1\"");
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[1].index, 0u);
  EXPECT_FALSE(parts[2].index);
  EXPECT_EQ(parts[3].key, "a/b.~\"1");
  EXPECT_FALSE(driver::split_path("\"7\"").front().index);  // a key, no number of an element
  for (const char* bad : {"", "a..b", "a.", "\"open", "\"a\"b", "\"\""})
    EXPECT_TRUE(driver::split_path(bad).back().key.empty() || driver::split_path(bad)[1].key.empty()) << bad;
  EXPECT_EQ(driver::quoted("a\"b\\c\n"), "\"a\\\"b\\\\c\\u000a\"");
}

// A gas with such a name is read, printed and set again by the printed path.
TEST(setting_path, odd_names_reach_their_setting) {
  const coupled::Folder folder;
  const auto file = folder.path / "odd.toml";
  std::ofstream(file)
      << "[scene]\nname = \"say \\\"no\\\"\"\nend_time = 0.1\n[gas]\nthermodynamics = \"constant\"\n"
         "initial = { composition = { \"7\" = 0.5, \"a/b.~\\\"\" = 0.5 } }\n"
         "[[gas.species]]\nname = \"7\"\ngas_constant = 300.0\ncp = 1000.0\n"
         "[[gas.species]]\nname = \"a/b.~\\\"\"\ngas_constant = 200.0\ncp = 1000.0\n"
         "[tank]\nvolume = 0.06\n[output]\nhistory_every = 0.1\n";
  std::map<std::string, std::string> settings;
  driver::CaseDocument document(
      file, {"gas.initial.composition.\"7\"=0.25", "gas.initial.composition.\"a/b.~\\\"\"=0.75"});
  driver::load_scene(document);
  for (const auto& setting : document.settings()) settings[setting.path] = setting.value;
  EXPECT_EQ(settings.at("gas.initial.composition.\"7\""), "0.25");
  EXPECT_EQ(settings.at("gas.initial.composition.\"a/b.~\\\"\""), "0.75");
  EXPECT_EQ(settings.at("scene.name"), "\"say \\\"no\\\"\"");
}

}  // namespace
