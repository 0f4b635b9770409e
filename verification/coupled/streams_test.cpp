// SPDX-License-Identifier: Apache-2.0
// Columns of the species and streams (output.streams), against the gas's mass and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "run_case.hpp"

namespace {

using coupled::CaseRun;
using coupled::Row;

CaseRun run_with_streams(const std::string& name, std::vector<std::string> overrides = {}) {
  overrides.push_back("output.streams=true");
  return coupled::run_case(name, overrides);
}

/// Sum of the columns whose names begin and end so.
double sum(const Row& row, const std::string& begin, const std::string& end) {
  double total = 0.0;
  for (const auto& [name, value] : row)
    if (name.starts_with(begin) && name.ends_with(end)) total += value;
  return total;
}

struct Scene {
  std::string name;
  std::vector<std::string> overrides;
  std::vector<std::string> columns;  // some of those it must have
};

void PrintTo(const Scene& scene, std::ostream* stream) {
  *stream << scene.name;
}

class streams : public testing::TestWithParam<Scene> {};

// Inflators, vents with triggers, backflow, fabric of tank and bag, jets.
INSTANTIATE_TEST_SUITE_P(
    scenes, streams,
    testing::Values(
        Scene{"tank_triggers", {}, {"mass_H2O_kg", "inflator_0_in_kg", "inflator_1_in_kg", "vent_1_out_kg"}},
        Scene{"tank_backflow", {}, {"mass_O2_kg", "vent_0_out_kg", "vent_0_backflow_kg"}},
        Scene{"piston_leak", {}, {"vent_0_out_kg", "fabric_out_kg"}},
        Scene{"bag_leak_table", {"scene.end_time=0.005"}, {"inflator_0_in_kg", "fabric_out_kg"}},
        Scene{"jet_bag", {"scene.end_time=0.005"}, {"inflator_0_in_kg", "inflator_1_in_kg"}}),
    [](const auto& tested) { return tested.param.name; });

/// Each step rounds the sums of at most 7 species and 4 streams once.
TEST_P(streams, come_to_the_mass_of_the_gas) {
  const CaseRun run = run_with_streams(GetParam().name, GetParam().overrides);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  ASSERT_GT(run.history.size(), 10u);
  for (const auto& name : GetParam().columns) EXPECT_GT(run.history.back().at(name), 0.0) << name;
  const double start = run.history.front().at("gas_mass_kg");
  constexpr double eps = std::numeric_limits<double>::epsilon();
  for (const Row& row : run.history) {
    const double in = sum(row, "inflator_", "_in_kg") + sum(row, "vent_", "_backflow_kg");
    const double out = sum(row, "vent_", "_out_kg") + sum(row, "fabric_", "_out_kg");
    const double gas = row.at("gas_mass_kg"), scale = start + in;
    EXPECT_NEAR(sum(row, "mass_", "_kg"), gas, 7 * eps * gas) << row.at("time_s");
    EXPECT_NEAR(start + in - out, gas, 11 * eps * static_cast<double>(run.state.steps) * scale)
        << row.at("time_s");
  }
}

TEST(streams_closed_form, two_inflators_add_what_they_deliver) {
  const CaseRun run = run_with_streams(
      "rigid_tank", {"inflator=[{composition={model_N2=1.0},mass_flow=1.0,temperature=700.0},"
                     "{composition={He=1.0},mass_flow=0.25,temperature=300.0,start_time=0.04}]"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const double start = 101325.0 * 0.06 / (296.8 * 293.15);
  const char* why = "the sum over 100 steps rounds";
  for (const Row& row : run.history) {
    const double time = row.at("time_s"), first = 1.0 * time, second = 0.25 * std::max(0.0, time - 0.04);
    claim::expect_near({"G.9", "case rigid_tank, two inflators, every row: mass in of each [kg]", why},
                       row.at("inflator_0_in_kg"), first, 1e-14);
    claim::expect_near({"G.9", "case rigid_tank, two inflators, every row: mass in of each [kg]", why},
                       row.at("inflator_1_in_kg"), second, 1e-14);
    EXPECT_NEAR(row.at("mass_model_N2_kg"), start + first, 1e-14) << time;
    EXPECT_NEAR(row.at("mass_He_kg"), second, 1e-14) << time;
  }
}

/// Two holes instead of one, three quarters and a quarter of its area: of their sum each lets out its share.
TEST(streams_closed_form, blowdown_through_two_vents) {
  const CaseRun run = run_with_streams("tank_blowdown", {"vent=[{area=0.75e-3},{area=0.25e-3}]"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const closed_form::Blowdown tank{{296.8, 1.4}, 0.06, 1e-3, 1.0, 5e5, 600.0, 101325.0};
  const double start = closed_form::blowdown(tank, 0.0).mass;
  for (const Row& row : run.history) {
    const double out = start - closed_form::blowdown(tank, row.at("time_s")).mass;
    const char* why = "350 steps of the stepper's 1e-10, amplified near the square root at p_a";
    claim::expect_near({"G.6", "case tank_blowdown, two vents, every row: mass out of each [kg]", why},
                       row.at("vent_0_out_kg"), 0.75 * out, 1e-8 * start);
    claim::expect_near({"G.6", "case tank_blowdown, two vents, every row: mass out of each [kg]", why},
                       row.at("vent_1_out_kg"), 0.25 * out, 1e-8 * start);
  }
  EXPECT_FALSE(run.history.front().contains("vent_0_backflow_kg"));
}

/// An evacuated tank holds the air that came in, each species by its share.
TEST(streams_closed_form, backflow_brings_the_ambient_gas) {
  const CaseRun run = run_with_streams(
      "tank_backflow", {"gas.initial={composition={N2=1.0},pressure=0.0}", "scene.end_time=0.1",
                        "ambient.composition={N2=0.75,O2=0.25}", "ambient.composition_by=mass"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  // Choked: a constant flow, of gas whose gamma is 1.4 to 1e-3.
  const closed_form::Orifice hole{{0.75 * 296.8 + 0.25 * 259.8, 1.4}, 5e-4, 0.8, 101325.0, 293.15, 0.0};
  const double flow = closed_form::orifice_mass_flow(hole);
  EXPECT_NEAR(run.history.back().at("vent_0_backflow_kg"), 0.1 * flow, 1e-3 * 0.1 * flow);
  for (const Row& row : run.history) {
    const double in = row.at("vent_0_backflow_kg");
    EXPECT_EQ(row.at("vent_0_out_kg"), 0.0);
    EXPECT_NEAR(row.at("mass_O2_kg"), 0.25 * in, 1e-15) << row.at("time_s");  // some 100 additions
    EXPECT_NEAR(row.at("mass_N2_kg"), 0.75 * in, 3e-15) << row.at("time_s");
  }
}

TEST(streams_closed_form, only_on_request) {
  for (const Row& row : {coupled::run_case("tank_triggers").history.front(),
                         coupled::run_case("tank_triggers", {"output.streams=false"}).history.front()})
    for (const auto& [name, value] : row)
      EXPECT_TRUE(name == "gas_mass_kg" || !name.ends_with("_kg")) << name;
}

}  // namespace
