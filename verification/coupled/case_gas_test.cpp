// SPDX-License-Identifier: Apache-2.0
// What a case says of its gas beyond numbers and smooth curves, against the same said otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "driver/forecast.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

/// Largest relative difference of the pressures, temperatures and masses of two histories.
double difference(const coupled::CaseRun& a, const coupled::CaseRun& b) {
  EXPECT_EQ(a.history.size(), b.history.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.history.size(), b.history.size()); ++i) {
    const auto &one = a.history[i], &other = b.history[i];
    for (const auto& [x, y] : {std::pair{one.pressure_Pa, other.pressure_Pa},
                               {one.temperature_K, other.temperature_K},
                               {one.gas_mass_kg, other.gas_mass_kg}})
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
      {"inflator=[{composition={Ar=1.0}, temperature=450.0, mass_flow={time=[0,0.01], value=[3.0,3.0]}},"
       "{composition={Ar=1.0}, temperature=400.0, start_time=0.01, mass_flow={time=[0,0.02], "
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
    const double flow = row.time_s < 0.01 - 1e-9 ? 3.0 : row.time_s < 0.03 - 1e-9 ? 1.0 : 0.0;
    EXPECT_EQ(row.vent_outflow_kg_s > 0.0, row.time_s > 0.02 - 1e-9) << row.time_s;
    if (std::abs(row.time_s - 0.03) < 1e-9) continue;  // the curve's end is no jump
    EXPECT_EQ(row.inflow_kg_s, flow) << row.time_s;
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

}  // namespace
