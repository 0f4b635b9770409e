// SPDX-License-Identifier: Apache-2.0
// Times in summary.json: switch of the vents, equalisation, opening of each vent, firing of each inflator.
#include <gtest/gtest.h>

#include <cmath>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"
#include "results/run_to_folder.hpp"
#include "run_case.hpp"

namespace {

using coupled::CaseRun;
using coupled::run_case;
using Texts = std::vector<std::string>;

/// At the case's steps, and with a step that ends next to the switch.
TEST(gas_events, blowdown_switches_and_ends_as_the_closed_form) {
  const closed_form::BlowdownTimes exact =
      closed_form::blowdown_times({{296.8, 1.4}, 0.06, 1e-3, 1.0, 5e5, 600.0, 101325.0});
  for (const double every : {1e-3, exact.unchoke_time / 20.0, exact.unchoke_time / 20.0 * (1.0 + 1e-5)}) {
    const CaseRun run = run_case("tank_blowdown", {"output.history_every=" + std::to_string(every)});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const gas::StepMoments& last = run.state.gas_events.last;
    claim::expect_relative(
        {"G.6", "case tank_blowdown: time at which the vent unchokes [s]", "located to 5e-5 of the pressure"},
        last.sonic_switch, exact.unchoke_time, 1e-4);
    claim::expect_near({"G.6", "case tank_blowdown: time at which p comes to p_a [s]",
                        "to 1e-7 of it, which dp ~ (t_end - t)^2 is 6e-5 s early"},
                       last.equalisation, exact.end_time, 1e-4);
  }
}

TEST(gas_events, closed_tank_has_none) {
  const CaseRun run = run_case("rigid_tank");
  EXPECT_TRUE(std::isnan(run.state.gas_events.last.sonic_switch));
  EXPECT_TRUE(std::isnan(run.state.gas_events.last.equalisation));
  EXPECT_TRUE(run.state.gas_events.opened.empty());
}

/// Openings of the vents of a tank that fills, dp/dt = (gamma - 1) mdot cp T / V, until they open.
std::vector<double> openings(const Texts& overrides) {
  const CaseRun run = run_case("rigid_tank", overrides);
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  return run.state.gas_events.opened;
}

TEST(gas_events, straps_that_stay_slack_are_told) {
  EXPECT_EQ(run_case("strapped_sphere").outcome.notes, std::vector<std::string>{});
  const CaseRun run = run_case("strapped_sphere", {"membrane.strap.0.free_length=500"});
  ASSERT_EQ(run.outcome.notes.size(), 1u);
  EXPECT_EQ(run.outcome.notes[0], "membrane.strap.0 was never taut: its free_length is 500 m");
}

TEST(gas_events, vents_that_stay_shut_are_told) {
  const CaseRun run = run_case(
      "rigid_tank",
      {"sensor=[{name=\"high\",overpressure=1e9},{name=\"low\",overpressure=1e3},{name=\"late\",time=9}]",
       "vent=[{area=1e-5,trigger=\"high\"},{area=1e-5,trigger=\"low\"},{area=1e-5,trigger=\"late\"},"
       "{area=1e-5}]"});
  ASSERT_EQ(run.outcome.notes.size(), 2u);
  EXPECT_EQ(
      run.outcome.notes[0].find("vent.0 never opened: its sensor comes on at 1e+09 Pa, but the largest"), 0u);
  EXPECT_EQ(run.outcome.notes[1], "vent.2 never opened: its trigger was never on");
}

/// Into a vacuum a vent stays choked: p = p0 f^-7, f = 1 + (gamma - 1) t/(2 tau).
TEST(gas_events, blowdown_into_vacuum_stays_choked) {
  const CaseRun run =
      run_case("tank_blowdown", {"ambient.pressure=0", "scene.end_time=2", "output.history_every=2"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const double f = 1.0 + 0.2 * 2.0 / 0.20764591762951125;
  EXPECT_NEAR(run.history.back().at("pressure_Pa") / (5e5 * std::pow(f, -7.0)), 1.0, 1e-8);
  EXPECT_TRUE(std::isnan(run.state.gas_events.last.sonic_switch));
}

TEST(gas_events, inflators_that_never_fire_are_told) {
  const CaseRun run =
      run_case("rigid_tank", {"sensor=[{name=\"high\",overpressure=1e9}]", "inflator.0.trigger=high"});
  ASSERT_EQ(run.outcome.notes.size(), 1u);
  EXPECT_EQ(
      run.outcome.notes[0].find("inflator.0 never fired: its sensor comes on at 1e+09 Pa, but the largest"),
      0u);
}

TEST(gas_events, fabric_beyond_its_table_is_told) {
  const Texts short_table{"fabric.velocity.overpressure=[0,100]", "fabric.velocity.value=[0,0.05]"};
  EXPECT_EQ(run_case("bag_leak_table").outcome.notes, std::vector<std::string>{});
  const CaseRun run = run_case("bag_leak_table", short_table);
  ASSERT_EQ(run.outcome.notes.size(), 1u);
  EXPECT_EQ(run.outcome.notes[0].find("fabric.velocity ends at 100 Pa and was held above"), 0u);
}

TEST(gas_events, outlets_that_the_bag_has_left_are_told) {
  const Texts short_run{"scene.end_time=0.02"};
  EXPECT_EQ(run_case("passenger_pendulum", short_run).outcome.notes, std::vector<std::string>{});
  const CaseRun free = run_case("passenger_pendulum", {"scene.end_time=0.02", "membrane.fixed_panels=[]"});
  ASSERT_EQ(free.outcome.notes.size(), 1u);
  EXPECT_EQ(free.outcome.notes[0].find("inflator.0.jet: the outlet is outside the bag at the end"), 0u);
}

TEST(gas_events, vents_open_as_their_curves_and_triggers_say) {
  const std::string clock = "sensor=[{name=\"clock\",time=0.0123}]";
  const std::string growing = "area={time=[0.0,0.002,0.004],value=[0.0,0.0,1e-5]}";
  const auto opened =
      openings({clock, "vent=[{area=1e-5},{area=1e-5,trigger=\"clock\"},{" + growing + "},{" + growing +
                           ",trigger=\"clock\"},{area={time=[0.0,0.01],"
                           "value=[0.0,0.0]}}]"});
  EXPECT_EQ(opened.at(0), 0.0);
  EXPECT_EQ(opened.at(1), 0.0123);
  EXPECT_EQ(opened.at(2), 0.002);
  EXPECT_EQ(opened.at(3), 0.0123 + 0.002);
  EXPECT_TRUE(std::isnan(opened.at(4)));  // it has no area
}

/// 20 kPa above ambient pressure come at a known time; the vent that opens then shuts and opens again and
/// again.
TEST(gas_events, pressure_opens_at_its_time) {
  const double rate = 0.4 * 1.0 * 1038.8 * 700.0 / 0.06, exact = 20e3 / rate;
  const Texts relief{
      "sensor=[{name=\"high\",overpressure=20e3,reset=19e3},{name=\"never\",overpressure=9e9}]",
      "vent=[{area=3e-2,trigger=\"high\"},{area=1e-5,trigger=\"never\"},"
      "{area={overpressure=[21e3,30e3],value=[0.0,1e-5]}}]",
      "scene.end_time=0.02"};
  const CaseRun run = run_case("rigid_tank", relief);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto& opened = run.state.gas_events.opened;
  EXPECT_GT(run.state.gas.triggers[0].since, 1.5 * exact);  // it has opened again
  claim::expect_near({"G.8", "case rigid_tank: time at which a vent opens by pressure [s]",
                      "the threshold is located to 1e-12 of p"},
                     opened.at(0), exact, 1e-11 * exact + 2e-12 * 121325.0 / rate);
  EXPECT_TRUE(std::isnan(opened.at(1)));
  EXPECT_TRUE(std::isnan(opened.at(2)));  // the relief keeps p from it between the rows
}

/// Against overpressure: the first step that finds an area.
TEST(gas_events, area_against_overpressure_opens_at_a_step) {
  const double exact = 20e3 / (0.4 * 1.0 * 1038.8 * 700.0 / 0.06);
  const auto opened = openings({"vent=[{area={overpressure=[20e3,30e3],value=[0.0,1e-5]}}]"});
  EXPECT_GE(opened.at(0), exact);
  EXPECT_LT(opened.at(0), exact + 1e-3);  // a step
}

/// A vent that opens and shuts within one step, after a dead time, has opened.
TEST(gas_events, opening_within_a_step_is_not_missed) {
  const auto opened = openings(
      {"sensor=[{name=\"pulse\",signal={time=[0.0,0.0101,0.0102,0.0108,0.0109],value=[0.0,0.0,2.0,2.0,0.0]},"
       "above=1.0}]",
       "vent=[{area={time=[0.0,1e-4,2e-4],value=[0.0,0.0,1e-4]},trigger=\"pulse\"}]"});
  EXPECT_NEAR(opened.at(0), 0.011, 1e-16);  // the end of its step
}

/// What has not happened by the end is null, also the firing of an inflator that waits.
TEST(gas_events, summary_says_null_for_what_never_happened) {
  const coupled::Folder folder;
  const auto scene = coupled::scene_of(
      "rigid_tank", {"inflator.0.start_time=0.04", "scene.end_time=0.03", "vent=[{area=1e-5}]"});
  driver::run_to_folder(scene, folder.path, {}, {.quiet = true});
  const std::string text = coupled::read(folder.path / "summary.json");
  for (const char* line :
       {"\"fired_s\": null", "\"opened_s\": 0.0", "\"sonic_switch_s\": null", "\"equalisation_s\": null"})
    EXPECT_NE(text.find(line), std::string::npos) << line << '\n' << text;
}

}  // namespace
