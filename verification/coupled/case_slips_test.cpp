// SPDX-License-Identifier: Apache-2.0
// Parts that miss what they are there for: warned of before the run, or told at its end.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/scene.hpp"
#include "forecast/jet_peak.hpp"
#include "run_case.hpp"

namespace slips {
namespace {

using Texts = std::vector<std::string>;

Texts warnings_of(const std::string& name, const Texts& overrides = {}) {
  driver::Scene scene = coupled::scene_of(name, overrides);
  driver::add_jet_warnings(scene);
  return scene.warnings;
}

// Exactly one warning, which begins so and says so.
void expect_one(const Texts& warnings, const std::string& begin, const std::string& says) {
  ASSERT_EQ(warnings.size(), 1u) << begin;
  EXPECT_EQ(warnings[0].find(begin), 0u) << warnings[0];
  EXPECT_NE(warnings[0].find(says), std::string::npos) << warnings[0];
}

TEST(slips, are_in_no_shipped_case) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GASJET_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(warnings_of(entry.path().stem()), Texts{}) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20);
}

// The circle of 1.31 m about the pivot, from the middle of the bag.
TEST(slips, a_pendulum_that_cannot_touch) {
  const std::string ahead = "contact_vent";
  EXPECT_EQ(warnings_of(ahead, {"pendulum.pivot=[0.345,0,1.4]"}), Texts{});
  EXPECT_EQ(warnings_of(ahead, {"pendulum.pivot=[0.6,0,1.31]"}), Texts{});  // by its swing
  expect_one(warnings_of(ahead, {"pendulum.pivot=[0,40,1.31]"}), "pendulum.pivot = [0, 40, 1.31] m",
             "at least 40 m");
  expect_one(warnings_of(ahead, {"pendulum.pivot=[400,0,0]"}), "pendulum.pivot = [400, 0, 0] m",
             "at least 399 m");
}

TEST(slips, a_pendulum_that_stands_on_its_head) {
  EXPECT_EQ(warnings_of("pendulum_swing", {"scene.gravity=[9.8,0,0]"}), Texts{});
  expect_one(warnings_of("pendulum_swing", {"scene.gravity=[0,0,9.8]"}), "scene.gravity = [0, 0, 9.8] m/s2",
             "upside down");
  expect_one(warnings_of("pendulum_swing", {"pendulum.rest_direction=[0,0,5]"}), "scene.gravity",
             "upside down");
  EXPECT_EQ(warnings_of("pendulum_swing", {"scene.gravity=[0,0,0]"}), Texts{});
}

TEST(slips, a_plate_and_a_target_far_away) {
  EXPECT_EQ(warnings_of("passenger_pendulum", {"membrane.plate.point=[-9,0,0]"}), Texts{});
  expect_one(warnings_of("passenger_pendulum", {"membrane.plate.point=[-250,0,0]"}),
             "membrane.plate is 250 m", "unit");
  EXPECT_EQ(warnings_of("plate_jet", {"target.centre=[9,0,0]"}), Texts{});
  expect_one(warnings_of("plate_jet", {"target.centre=[250,0,0]"}), "target is 250 m from the outlet",
             "inflator.0.jet");
}

TEST(slips, a_hole_without_a_vent) {
  const Texts both = warnings_of("driver_bag", {"unset vent"});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NE(both[0].find("hole \"vent_left\" of 0.00131 m2"), std::string::npos) << both[0];
  EXPECT_EQ(warnings_of("driver_bag", {"unset vent", "unset membrane.null_panels"}), Texts{});
  // Rims that are held: the module closes the hole.
  EXPECT_EQ(
      warnings_of("driver_bag",
                  {"unset vent", "membrane.fixed_panels=[\"attachment\",\"vent_left\",\"vent_right\"]"}),
      Texts{});
}

TEST(slips, a_history_of_few_rows) {
  expect_one(warnings_of("driver_bag", {"output.history_every=0.1"}), "output.history_every is 0.1 s",
             "the history has 2 rows");
  expect_one(warnings_of("driver_bag", {"output.history_every=0.025"}), "output.history_every", "has 4 rows");
  EXPECT_EQ(warnings_of("driver_bag", {"output.history_every=0.06"}), Texts{});  // the end alone
  EXPECT_EQ(warnings_of("driver_bag", {"output.history_every=0.015"}), Texts{});
}

// (width / R)^2 of a round jet with R by (J.3) and (J.5), at the target: there it is largest.
TEST(slips, a_cone_that_makes_momentum) {
  const auto cone = [](const char* angle) {
    return warnings_of("plate_jet", {"inflator.0.jet.spread=cone", "inflator.0.jet.cone_initial_width=0.03",
                                     std::string("inflator.0.jet.cone_half_angle=") + angle});
  };
  EXPECT_EQ(cone("0.1"), Texts{});
  const double z = 0.5, radius = 0.0398942280401432678, a = 0.08;  // of the case
  const double width = std::sqrt(2.0) * radius * (a * z / radius + 0.29) / 0.96;
  const std::string times = fmt::format("{:.2g} times", std::pow((0.03 + z * std::tan(0.21)) / width, 2));
  expect_one(cone("0.21"), "jet of inflator 0: spread = \"cone\" has " + times, "at 0.5 m");
}

TEST(slips, are_told_at_the_end_of_a_run) {
  const Texts off{"pendulum.pivot=[0.5,0,1.31]", "unset sensor", "unset trigger", "unset vent"};
  const auto pendulum = coupled::run_case("contact_vent", off).outcome;
  expect_one(pendulum.notes,
             "pendulum: the impactor never touched the bag: its distance was 0.159 m at the start",
             "m at the end");
  // Cut short: the bag may have come to the impactor later.
  EXPECT_EQ(coupled::run_case("passenger_pendulum_no_jet", {"scene.end_time=0.002"}).outcome.notes, Texts{});
  const auto target = coupled::run_case("plate_jet", {"target.centre=[0.3,9,0]"}).outcome;
  expect_one(target.notes, "target: no jet ever met it", "");
  EXPECT_EQ(coupled::run_case("plate_jet").outcome.notes, Texts{});
}

// Discs of cloth without straps or inflow fall through the module.
TEST(slips, a_bag_that_turns_inside_out_says_why) {
  const auto run = coupled::run_case(
      "driver_bag", {"vent.0.area=20", "scene.gravity=[-500,0,0]", "unset inflator", "unset membrane.strap"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_EQ(run.outcome.message.find("stage S10_gas"), 0u) << run.outcome.message;
  EXPECT_NE(
      run.outcome.message.find("m3: must be positive and finite. The skin has collapsed or turned inside "
                               "out"),
      std::string::npos)
      << run.outcome.message;
}

// A bag without gas collapses: what is told is the pressure, as with a bag that empties.
TEST(slips, evacuated_bag_is_told_as_a_collapse) {
  const auto run = coupled::run_case("sphere_inflation", {"gas.initial.pressure=0"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::failed);
  for (const char* part : {"the skin collapses, as 0 Pa of gas do not bear the 1.01e+05 Pa outside",
                           "look at gas.initial.pressure", "for the energy to drift little (M.22)"})
    EXPECT_NE(run.outcome.message.find(part), std::string::npos) << run.outcome.message;
}

}  // namespace
}  // namespace slips
