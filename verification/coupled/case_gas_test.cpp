// SPDX-License-Identifier: Apache-2.0
// What a case says of its gas beyond numbers and smooth curves, against the same said otherwise.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "forecast/forecast.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

/// Largest relative difference of the pressures, temperatures and masses of two histories.
double difference(const coupled::CaseRun& a, const coupled::CaseRun& b) {
  EXPECT_EQ(a.history.size(), b.history.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.history.size(), b.history.size()); ++i) {
    const auto &one = a.history[i], &other = b.history[i];
    for (const auto& [x, y] : {std::pair{one.at("pressure_Pa"), other.at("pressure_Pa")},
                               {one.at("temperature_K"), other.at("temperature_K")},
                               {one.at("gas_mass_kg"), other.at("gas_mass_kg")}})
      largest = std::max(largest, std::abs(x / y - 1.0));
  }
  return largest;
}

constexpr double kRounding = 1e-12;  // of 50 calls of the integrator, each of some hundred operations

TEST(case_gas, jumps_eq_inflators_of_their_own_and_a_trigger) {
  const auto run = run_case("tank_steps");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done);
  const auto apart = run_case(
      "tank_steps",
      {"inflator=[{composition={Ar=0.9,krypton=0.1}, temperature=450.0, mass_flow={time=[0,0.01], "
       "value=[3.0,3.0]}},"
       "{composition={Ar=0.9,krypton=0.1}, temperature=400.0, start_time=0.01, mass_flow={time=[0,0.02], "
       "value=[1.0,1.0]}}]",
       "sensor=[{name=\"torn\", time=0.02}]", "vent.0.area=1e-3", "vent.0.trigger=\"torn\""});
  ASSERT_EQ(apart.outcome.status, driver::RunStatus::done) << apart.outcome.message;
  EXPECT_LT(difference(run, apart), kRounding);
  // 3 kg/s for 10 ms and 1 kg/s for 20 ms.
  EXPECT_NEAR(run.state.flows.mass_in, 0.05, 1e-15);
  EXPECT_GT(run.state.flows.vent_mass_out, 0.005);
}

/// A row that stands on a jump shows the flow from then on.
TEST(case_gas, history_shows_the_value_after_a_jump) {
  const auto run = run_case("tank_steps");
  for (const auto& row : run.history) {
    const double flow = row.at("time_s") < 0.01 - 1e-9 ? 3.0 : row.at("time_s") < 0.03 - 1e-9 ? 1.0 : 0.0;
    EXPECT_EQ(row.at("vent_outflow_kg_s") > 0.0, row.at("time_s") > 0.02 - 1e-9) << row.at("time_s");
    if (std::abs(row.at("time_s") - 0.03) < 1e-9) continue;  // the curve's end is no jump
    EXPECT_EQ(row.at("inflow_kg_s"), flow) << row.at("time_s");
  }
}

TEST(case_gas, forecast_sees_the_flow_on_both_sides_of_a_jump) {
  const auto peak = [](const char* flow) {
    const auto scene = coupled::scene_of("tank_steps", {std::string("inflator.0.mass_flow=") + flow});
    return driver::forecast(scene, driver::state_at_start(scene)).supply.peak_flow;
  };
  EXPECT_EQ(peak("{time=[0,0.01,0.01,0.02], value=[0,4.0,1.0,0]}"), 4.0);
  EXPECT_EQ(peak("{time=[0,0.01,0.01,0.02], value=[0,1.0,4.0,0]}"), 4.0);
  EXPECT_EQ(peak("{time=[0,0,0.02], value=[9.0,4.0,0]}"), 4.0);              // before it fires nothing flows
  EXPECT_EQ(peak("{time=[0,0.05,0.05,0.06], value=[2.0,3.0,9.0,0]}"), 3.0);  // nor after the end
}

/// The CO2 of NASA TM-4513 as a case may give it.
const std::string kOwnCo2 =
    "gas.species=[{name=\"own\", molar_mass=0.044009, nasa7={range=[200.0, 6000.0], middle=1000.0, "
    "low=[2.35677352, 0.00898459677, -7.12356269e-06, 2.45919022e-09, -1.43699548e-13, -48371.9697, "
    "9.90105222], "
    "high=[4.63659493, 0.00274131991, -9.95828531e-07, 1.60373011e-10, -9.16103468e-15, -49024.9341, "
    "-1.93534855]}}]";

/// A built-in species restated is that species, with cp(T) and at a constant cp of any temperature; into hot
/// gas, so that both ranges are used.
TEST(case_gas, restated_species_eq_the_built_in_one) {
  for (const std::vector<std::string>& law :
       {std::vector<std::string>{"gas.thermodynamics=nasa7"}, {"gas.reference_temperature=900.0"}}) {
    auto own = law, built_in = law;
    const std::string into = "gas.initial.composition={N2=0.5,CO2=0.5}";
    for (auto* set : {&own, &built_in}) {
      set->push_back("gas.initial.composition_by=mole");
      set->push_back("gas.initial.temperature=1100.0");
    }
    own.push_back(kOwnCo2);
    own.push_back("gas.initial.composition={N2=0.5,own=0.5}");
    own.push_back("inflator.0.composition={own=1.0}");
    built_in.push_back(into);
    built_in.push_back("inflator.0.composition={CO2=1.0}");
    const auto one = run_case("tank_steps", own), other = run_case("tank_steps", built_in);
    ASSERT_EQ(one.outcome.status, driver::RunStatus::done) << one.outcome.message;
    EXPECT_LT(difference(one, other), kRounding);
    EXPECT_NEAR(one.history.front().at("temperature_K"), 1100.0, 1e-9);
    EXPECT_LT(one.history.back().at("temperature_K"), 1000.0);
  }
}

/// Argon by its molar mass and cp = 5/2 R into a tank of it: p rises by gamma R T m/V, gamma = 5/3; from an
/// evacuated one the gas is gamma times as hot as what comes in.
TEST(case_gas, argon_of_constant_cp_eq_closed_form) {
  const double r = 8.31446261815324 / 0.03995;
  const std::vector<std::string> argon{
      "gas.species=[{name=\"argon\", molar_mass=0.03995, cp=" + fmt::format("{}", 2.5 * r) + "}]",
      "gas.initial.composition={argon=1.0}",
      "inflator.0.composition={argon=1.0}",
      "inflator.0.temperature=400.0",
      "unset vent",
      "unset tank.fabric"};
  const auto run = run_case("tank_steps", argon);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  claim::expect_relative(
      {"G.34", "argon by molar mass and cp, a pulse of two steps into a tank: pressure [Pa]",
       "some ten operations in each of 50 steps"},
      run.history.back().at("pressure_Pa"), 101325.0 + 5.0 / 3.0 * r * 400.0 * 0.05 / 0.06, 1e-13);
  auto evacuated = argon;
  evacuated.push_back("gas.initial.pressure=0.0");
  const auto filled = run_case("tank_steps", evacuated);
  claim::expect_relative({"G.10", "argon by molar mass and cp into an evacuated tank: temperature [K]",
                          "some ten operations in each of 50 steps"},
                         filled.history.back().at("temperature_K"), 5.0 / 3.0 * 400.0, 1e-13);
}

/// Of two fabrics each has its mass; two of half the area are one of the whole.
TEST(case_gas, fabrics_leak_side_by_side) {
  const auto run = run_case("tank_steps");
  const auto& out = run.state.streams.outflows;
  ASSERT_EQ(out.size(), 3u);
  EXPECT_GT(out[1].mass, 1e-4);
  EXPECT_GT(out[2].mass, 1e-4);
  EXPECT_NEAR(out[1].mass + out[2].mass, run.state.flows.fabric_mass_out, 1e-15);
  const auto shown = run_case("tank_steps", {"output.streams=true"});
  EXPECT_EQ(shown.history.back().at("fabric_0_out_kg"), out[1].mass);
  EXPECT_EQ(shown.history.back().at("fabric_1_out_kg"), out[2].mass);
  const std::string velocity =
      "leak_law=\"table\", velocity={overpressure=[0.0,1e3,1e5], value=[0.0,0.1,1.0]}";
  for (const std::string& law :
       {std::string("porosity=0.05"), std::string("porosity=0.05, leak_law=\"screen\""), velocity}) {
    const auto one = run_case("tank_steps", {"tank.fabric={area=0.5, " + law + "}"});
    const auto two =
        run_case("tank_steps", {"tank.fabric=[{area=0.25, " + law + "}, {area=0.25, " + law + "}]"});
    ASSERT_EQ(two.outcome.status, driver::RunStatus::done) << two.outcome.message;
    EXPECT_GT(one.state.flows.fabric_mass_out, 1e-4);
    EXPECT_LT(difference(one, two), kRounding);
    EXPECT_EQ(two.state.streams.outflows[1].mass, two.state.streams.outflows[2].mass);
  }
}

}  // namespace
