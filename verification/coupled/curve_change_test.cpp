// SPDX-License-Identifier: Apache-2.0
// Curves in other units, scaled, shifted and given by their integral.
#include <gtest/gtest.h>

#include <limits>

#include "case_folder.hpp"
#include "claim.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;
using coupled::scene_of;
using Knots = std::vector<std::pair<double, double>>;

constexpr double eps = std::numeric_limits<double>::epsilon();
const std::string mass_flow_key = "inflator.0.mass_flow";

Knots knots_of(const gas::Curve& curve) {
  Knots knots;
  for (const auto& [time, value] : curve.knots()) knots.emplace_back(time, value);
  return knots;
}

// The inflator's curve in the rigid tank with these overrides of it.
Knots flow_of(const std::vector<std::string>& overrides) {
  std::vector<std::string> all;
  for (const auto& text : overrides) all.push_back(text.starts_with("unset") ? text : mass_flow_key + text);
  return knots_of(scene_of("rigid_tank", all).gas->model.inflows[0].mass_flow);
}

std::string refusal_of(const std::vector<std::string>& overrides) {
  std::vector<std::string> all;
  for (const auto& text : overrides) all.push_back(mass_flow_key + text);
  const std::string message = coupled::message_of(coupled::case_file("rigid_tank"), all);
  const auto at = message.find(mass_flow_key);  // of the option
  const auto key = message.find(": " + mass_flow_key, at);
  return key == message.npos ? message : message.substr(key + 2 + mass_flow_key.size());
}

TEST(curve_change, scales_a_number_and_a_curve) {
  EXPECT_EQ(flow_of({".scale=0.9"}), (Knots{{0.0, 0.9}}));
  EXPECT_EQ(flow_of({".scale=0.9", ".offset=0.25", ".scale=3"}), (Knots{{0.0, 3.25}}));
  EXPECT_EQ(flow_of({"=0.5", ".scale=0.9"}), (Knots{{0.0, 0.45}}));
  EXPECT_EQ(flow_of({".scale=0.9", "=0.5"}), (Knots{{0.0, 0.5}}));
  EXPECT_EQ(flow_of({".units={ value = \"g/s\" }"}), (Knots{{0.0, 1e-3}}));
  const std::string pulse = "={ time = [0, 0.5, 1.5], value = [0, 4, 1] }";
  EXPECT_EQ(flow_of({pulse}), (Knots{{0.0, 0.0}, {0.5, 4.0}, {1.5, 1.0}}));
  EXPECT_EQ(flow_of({pulse, ".scale=0.25", ".offset=2", ".time_scale=4", ".shift=1"}),
            (Knots{{1.0, 2.0}, {3.0, 3.0}, {7.0, 2.25}}));
  // Units first: 500 g/s after half a millisecond.
  EXPECT_EQ(flow_of({"={ time = [0.5, 1], value = [500, 0] }", ".units={ time = \"ms\", value = \"g/s\" }",
                     ".scale=2", ".shift=0.25"}),
            (Knots{{0.2505, 1.0}, {0.251, 0.0}}));
  // Other quantities have the same keys.
  EXPECT_EQ(*scene_of("rigid_tank", {"tank.volume.scale=1.5"}).gas->rigid_volume, 0.06 * 1.5);
  EXPECT_EQ(scene_of("tank_blowdown", {"vent.0.area.scale=0.5"}).gas->model.vents[0].area,
            0.5 * scene_of("tank_blowdown").gas->model.vents[0].area);
  const auto temperature = knots_of(
      scene_of("rigid_tank", {"inflator.0.temperature={ time = [0, 1], value = [0, 100], units = { value = "
                              "\"°C\" } }"})
          .gas->model.inflows[0]
          .temperature);
  EXPECT_EQ(temperature, (Knots{{0.0, 273.15}, {1.0, 373.15}}));
}

TEST(curve_change, scaled_inflow_is_that_of_scaled_numbers) {
  const auto scaled = run_case("sphere_inflation", {mass_flow_key + ".scale=0.5", "scene.end_time=0.01"});
  const auto numbers =
      run_case("sphere_inflation", {mass_flow_key + ".value=[0.0, 0.5, 0.0]", "scene.end_time=0.01"});
  EXPECT_EQ(scaled.history.back(), numbers.history.back());
}

TEST(curve_change, cumulative_curve_keeps_its_mass) {
  // Grams over milliseconds, with uneven times; a plateau is no flow.
  const std::string curve =
      "={ time = [3, 4, 7.5, 9, 30], value = [0, 3.3, 17.1, 17.1, 81.7], cumulative = true, units = { time = "
      "\"ms\", value = \"g\" } }";
  const auto mass = [](const std::vector<std::string>& overrides) {
    const auto scene = scene_of("rigid_tank", overrides);
    return scene.gas->model.inflows[0].mass_flow.integral(0.0, 1.0);
  };
  // Four products and their sum.
  EXPECT_NEAR(mass({mass_flow_key + curve}), 0.0817, 8.0 * eps * 0.0817);
  const auto knots = flow_of({curve});
  ASSERT_EQ(knots.size(), 8u);  // each piece is constant
  for (std::size_t i = 0; i < 8; i += 2) {
    EXPECT_EQ(knots[i].second, knots[i + 1].second);
    EXPECT_EQ(knots[i + 1].first, knots[std::min<std::size_t>(i + 2, 7)].first);
  }
  EXPECT_NEAR(knots[0].second, 3.3, 8.0 * eps);
  EXPECT_EQ(knots[4].second, 0.0);
  // The mass is that of the table however long it takes; scale is its factor.
  EXPECT_NEAR(mass({mass_flow_key + curve, mass_flow_key + ".time_scale=2.5", mass_flow_key + ".shift=0.01"}),
              0.0817, 8.0 * eps * 0.0817);
  EXPECT_NEAR(mass({mass_flow_key + curve, mass_flow_key + ".scale=0.9"}), 0.9 * 0.0817, 8.0 * eps * 0.0817);
  // Half a gram before the first knot is lost: an offset of that makes it 0.
  const std::string late =
      "={ time = [1, 2], value = [0.5, 2.5], cumulative = true, units = { value = \"g\" } }";
  EXPECT_EQ(refusal_of({late}),
            ": begins at 0.0005 kg, allowed: 0 where the curve is cumulative; offset "
            "shifts it");
  EXPECT_NEAR(
      mass({mass_flow_key + late, mass_flow_key + ".offset=-0.0005", mass_flow_key + ".units.time=ms"}),
      0.002, 8.0 * eps * 0.002);
  EXPECT_EQ(refusal_of({"={ time = [0, 1], value = [1e-8, 1], cumulative = true }"}).substr(0, 17),
            ": begins at 1e-08");
  // 3 x 0.1 is not quite 0.3.
  EXPECT_EQ(refusal_of({"={ time = [0, 1], value = [0.1, 1], scale = 3, offset = -0.3, cumulative = true }"}),
            "accepted");
  // The tank has it all at the end.
  const auto run = run_case("rigid_tank", {mass_flow_key + curve});
  claim::expect_near({"G.9", "cumulative curve in g over ms: mass that the tank gains [kg]",
                      "rounding of a hundred rows' sums"},
                     run.history.back().at("gas_mass_kg") - run.history.front().at("gas_mass_kg"), 0.0817,
                     100.0 * eps * 0.16);
}

TEST(curve_change, knots_before_firing_count_if_nothing_flows) {
  EXPECT_EQ(flow_of({"={ time = [-2, -1, 0.5, 1], value = [0, 0, 0, 3] }"}),
            (Knots{{0.0, 0.0}, {0.5, 0.0}, {1.0, 3.0}}));
  EXPECT_EQ(flow_of({"={ time = [-1, 0, 0, 1], value = [0, 0, 2, 3] }"}),
            (Knots{{0.0, 0.0}, {0.0, 2.0}, {1.0, 3.0}}));
  EXPECT_EQ(flow_of({"={ time = [0, 1, 2], value = [0, 0, 3] }", ".shift=-1"}),
            (Knots{{0.0, 0.0}, {1.0, 3.0}}));
  for (const char* curve :
       {"={ time = [-1, 0, 1], value = [0, 2, 3] }", "={ time = [-1, 1], value = [0, 2] }",
        "={ time = [-2, -1], value = [0, 0] }", "={ time = [-1, 0, 1], value = [1, 0, 2] }"})
    EXPECT_NE(refusal_of({curve}).find("its first knot is at -"), std::string::npos) << curve;
}

TEST(curve_change, what_makes_no_sense_is_refused) {
  const std::string pulse = "={ time = [0, 1, 2], value = [0, 2, 1] }";
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{".scale=-1"}, ": is -1 after units, scale and offset, allowed: a number of 0 or more [kg/s]"},
      {{".scale=nan"}, ".scale: is nan, allowed: a finite number"},
      {{".scale=\"a\""}, ".scale: is a string, allowed: a finite number"},
      {{".shift=1"}, ".shift: unknown key, allowed here: offset, scale, units, value"},
      {{".cumulative=true"}, ".cumulative: unknown key, allowed here: offset, scale, units, value"},
      {{".units={ time = \"ms\" }"}, ".units.time: unknown key, allowed here: value"},
      {{pulse, ".time_scale=0"}, ".time_scale: is 0, allowed: a number above 0"},
      {{pulse, ".time_scale=1e-320"},
       ": knots 1 and 2 are so close that their slope overflows: for a jump use two knots at one time"},
      {{pulse, ".time_scale=5e-324", ".units={ time = \"ms\" }"},
       ": knot 3 at 0 is the third there, allowed: a jump, two knots at one time"},
      {{pulse, ".time_scale=1e308"}, ": knot 3 is not finite after units, scale and offset"},
      {{pulse, ".scale=1e308"}, ": knot 2 is not finite after units, scale and offset"},
      {{pulse, ".offset=-1"},
       ": has -1 after units, scale and offset, allowed: a number of 0 or more [kg/s]"},
      {{pulse, ".cumulative=1"}, ".cumulative: is a number, allowed: true or false"},
      {{pulse, ".cumulative=true"}, ": falls from 2 to 1 kg at knot 3, but a cumulative curve does not"},
      {{"={ time = [0, 1, 1], value = [0, 2, 3], cumulative = true }"},
       ": knot 3 at 1 follows 1, allowed: knots in strictly rising order"},
      {{pulse, ".units={ time = \"min\" }"}, ".units.time: is \"min\", allowed: s, ms, us"},
      {{pulse, ".units={ value = \"kg\" }"},
       ".units.value: is \"kg\", allowed: kg/s, g/s, g/ms, kg/ms, t/s, lb/s"},
      {{pulse, ".units={ valu = \"g/s\" }"},
       ".units.valu: unknown key, allowed here: time, value; is 'value' meant?"},
  };
  for (const auto& [overrides, message] : wrong)
    EXPECT_EQ(refusal_of(overrides), message) << overrides.back();
  const auto message = [](const char* name, const char* override_text) {
    return coupled::message_of(coupled::case_file(name), {override_text});
  };
  EXPECT_NE(
      message("rigid_tank", "inflator.0.temperature={ time = [0, 1], value = [500, 600], cumulative = true }")
          .find("temperature.cumulative: unknown key"),
      std::string::npos);
  EXPECT_NE(message("bag_volume", "tank.volume.time_scale=2").find("volume.time_scale: unknown key"),
            std::string::npos);
  EXPECT_NE(message("rigid_tank", "scene.end_time.scale=2")
                .find("scene.end_time: is not a curve, so it cannot have scale, offset or units, allowed: "),
            std::string::npos);
}

TEST(curve_change, absolute_pressures_of_a_curve_lose_the_ambient_one) {
  const auto knots = [](const std::vector<std::string>& overrides) {
    return knots_of(*scene_of("tank_blowdown", overrides).gas->model.vents[0].area_of_overpressure);
  };
  const Knots known{{0.0, 1e-4}, {2e4, 3e-4}};
  EXPECT_EQ(
      knots({"vent.0.area={ overpressure = [100, 120], value = [100, 300], units = { overpressure = \"kPa "
             "absolute\", value = \"mm2\" } }",
             "ambient.pressure=100e3"}),
      known);
  EXPECT_EQ(knots({"vent.0.area={ overpressure = [0, 20], value = [1, 3], units = { overpressure = \"kPa "
                   "gauge\", value = \"cm2\" } }"}),
            known);
}

TEST(curve_file, in_other_units_and_marks_is_the_curve_of_the_case) {
  const coupled::Folder folder;
  std::string text = coupled::read(coupled::case_file("rigid_tank"));
  const std::string number = "mass_flow = 1.0 ";
  text.replace(
      text.find(number), number.size(),
      "mass_flow = { file = \"flow.csv\", time_column = \"t [ms]\", column = \"m [g]\", cumulative = true, "
      "units = { time = \"ms\", value = \"g\" } } ");
  const auto knots = [&](const char* csv, const std::vector<std::string>& overrides = {}) {
    std::ofstream(folder.path / "flow.csv") << csv;
    return knots_of(coupled::scene_of_text(folder, text, overrides).gas->model.inflows[0].mass_flow);
  };
  const Knots known{{0.0, 0.6}, {2.5e-3, 0.6}, {2.5e-3, 3.0}, {4.5e-3, 3.0}};
  const auto same = [&](const Knots& mine) {
    ASSERT_EQ(mine.size(), known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      EXPECT_EQ(mine[i].first, known[i].first);
      EXPECT_NEAR(mine[i].second, known[i].second, 4.0 * eps * known[i].second);
    }
  };
  same(knots("t [ms];m [g]\n0;0\n2,5;1,5\n4,5;7,5\n"));
  same(knots("m [g],t [ms]\n0,0\n1.5,2.5\n7.5,4.5\n"));
  const auto fault = [&](const char* csv, const std::vector<std::string>& overrides = {}) {
    try {
      knots(csv, overrides);
    } catch (const driver::CaseError& error) {
      return std::string(error.what()).substr(folder.path.string().size() + 1);
    }
    return std::string();
  };
  EXPECT_EQ(fault("t [ms],m [g]\n0,0\n1,2\n2,1\n"),
            "flow.csv:4:1: m [g]: falls from 0.002 to 0.001 kg at knot 3, but a cumulative curve does not");
  EXPECT_EQ(
      fault("t [ms],m [g]\n0,0\n1,-2\n",
            {mass_flow_key + ".cumulative=false", mass_flow_key + ".units.value=g/s"}),
      "flow.csv:3:1: m [g]: has -0.002 after units, scale and offset, allowed: a number of 0 or more [kg/s]");
}

// Their table has the same forms as that of an inflator.
TEST(curve_file, of_a_volume_and_of_a_vent_over_overpressure) {
  const coupled::Folder folder;
  std::ofstream(folder.path / "curve.csv") << "t;p;V;A\n0;0;60;0\n0,05;10;60;5\n0,1;20;90;7,5\n";
  const auto scene = [&](const char* name, const std::vector<std::string>& overrides) {
    return coupled::scene_of_text(folder, coupled::read(coupled::case_file(name)), overrides);
  };
  const auto tank =
      scene("rigid_tank", {"tank.volume={ file = \"curve.csv\", time_column = \"t\", column = \"V\", "
                           "units = { value = \"l\" } }"});
  EXPECT_EQ(knots_of(*tank.gas->tank_volume->table), (Knots{{0.0, 0.06}, {0.05, 0.06}, {0.1, 0.09}}));
  const auto vent =
      scene("tank_blowdown", {"vent.0.area={ file = \"curve.csv\", overpressure_column = \"p\", column "
                              "= \"A\", units = { overpressure = \"kPa\", value = \"cm2\" } }"});
  EXPECT_EQ(knots_of(*vent.gas->model.vents[0].area_of_overpressure),
            (Knots{{0.0, 0.0}, {1e4, 5e-4}, {2e4, 7.5e-4}}));
}

TEST(case_text, of_a_scaled_number_reads_the_same) {
  const coupled::Folder folder;
  driver::CaseDocument document(coupled::case_file("rigid_tank"),
                                {mass_flow_key + ".scale=0.75", "tank.volume.units.value=l"});
  std::ofstream(folder.path / "copy.toml") << document.text(folder.path);
  driver::CaseDocument copy(folder.path / "copy.toml", {});
  const auto scene = driver::load_scene(copy);
  EXPECT_EQ(scene.gas->model.inflows[0].mass_flow.value(0.0), 0.75);
  EXPECT_EQ(*scene.gas->rigid_volume, 0.06 / 1e3);
}

}  // namespace
