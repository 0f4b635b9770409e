// SPDX-License-Identifier: Apache-2.0
// Whole runs of the gas scenes: what each option contributes, and the books of every stream.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "claim.hpp"
#include "closed_form/exchange.hpp"
#include "closed_form/gas.hpp"
#include "real_axis_limit.hpp"
#include "run_case.hpp"

namespace {

using coupled::CaseRun;
using coupled::run_case;

double pressure_at(const CaseRun& run, double time) {
  for (const auto& row : run.history)
    if (row.at("time_s") >= time - 1e-9) return row.at("pressure_Pa");
  return run.history.back().at("pressure_Pa");
}

double sum_of_masses(const std::vector<gas::StreamFlux>& streams) {
  double sum = 0.0;
  for (const auto& stream : streams) sum += stream.mass;
  return sum;
}

double sum_of_enthalpies(const std::vector<gas::StreamFlux>& streams) {
  double sum = 0.0;
  for (const auto& stream : streams) sum += stream.enthalpy;
  return sum;
}

TEST(gas_scene, mass_and_energy_of_each_stream_close) {
  for (const char* name : {"tank_triggers", "tank_backflow", "piston_leak", "tank_stiff", "bag_volume"}) {
    const CaseRun run = run_case(name);
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << name << run.outcome.message;
    EXPECT_LT(run.state.peaks.mass_residual, 1e-12) << name;
    double scale = 0.0;
    for (const auto& row : run.energy)
      scale = std::max({scale, std::abs(row.at("gas_internal_J")), std::abs(row.at("inflow_enthalpy_J"))});
    for (const auto& row : run.energy)
      EXPECT_LT(std::abs(row.at("residual_J")), 1e-12 * scale) << name << row.at("time_s");
    // The streams' sums are the totals' terms in another order: eps x steps.
    const auto& flows = run.state.flows;
    EXPECT_NEAR(sum_of_masses(run.state.streams.inflows), flows.mass_in, 1e-12 * flows.mass_in);
    EXPECT_NEAR(sum_of_masses(run.state.streams.outflows), flows.vent_mass_out + flows.fabric_mass_out,
                1e-12 * (flows.vent_mass_out + flows.fabric_mass_out));
    EXPECT_NEAR(sum_of_masses(run.state.streams.backflows), flows.backflow_mass, 1e-12 * flows.backflow_mass);
    EXPECT_NEAR(sum_of_enthalpies(run.state.streams.outflows), flows.enthalpy_out,
                1e-12 * std::max(scale, std::abs(flows.enthalpy_out)));
  }
}

TEST(gas_scene, triggers_fire_in_their_order) {
  const CaseRun run = run_case("tank_triggers");
  const auto& model = run.state.gas.triggers;
  const driver::Scene scene = coupled::scene_of("tank_triggers");
  const auto& inflows = scene.gas->model.inflows;
  // The signal passes 10 g at 8 ms, the safing switch at 9 ms; the second stage follows after 5 ms.
  EXPECT_EQ(gas::firing_time(inflows[0], model), 0.009);
  EXPECT_NEAR(gas::firing_time(inflows[1], model), 0.014, 1e-17);
  const auto& streams = run.state.streams;
  EXPECT_NEAR(streams.inflows[0].mass, 0.025, 1e-12 * 0.025);
  EXPECT_NEAR(streams.inflows[1].mass, 0.015, 1e-12 * 0.015);
  EXPECT_GT(streams.outflows[0].mass, 0.005);
  EXPECT_GT(streams.outflows[1].mass, 0.005);
  // A signal that never passes its threshold fires nothing; a pressure that forbids it keeps the second stage
  // back.
  EXPECT_EQ(run_case("tank_triggers", {"sensor.0.above=99.0"}).state.flows.mass_in, 0.0);
  const CaseRun held = run_case("tank_triggers", {"sensor.2.overpressure=50.0e3"});
  EXPECT_EQ(held.state.streams.inflows[1].mass, 0.0);
  EXPECT_GT(held.state.streams.inflows[0].mass, 0.0);
}

TEST(gas_scene, backflow_and_heat_loss_contribute) {
  const CaseRun with = run_case("tank_backflow"),
                without = run_case("tank_backflow", {"vent.0.backflow=false"});
  // The vent throttles what the walls take: 5.6 kPa below ambient, against 33 kPa or more without backflow.
  EXPECT_GT(with.history.back().at("pressure_Pa"), 95000.0);
  EXPECT_LT(without.history.back().at("pressure_Pa"), 70000.0);
  EXPECT_GT(with.state.streams.backflows[0].mass, 0.02);
  // Walls at the gas's own temperature, and no vent to speak of: nothing happens.
  const CaseRun even =
      run_case("tank_backflow", {"gas.heat_loss.outside_temperature=900.0", "vent.0.area=1e-12"});
  EXPECT_NEAR(even.history.back().at("temperature_K"), 900.0, 1e-4);
}

TEST(gas_scene, sealed_piston_eq_closed_form) {
  const CaseRun run = run_case(
      "piston_leak", {"tank.fabric.area=1e-30", "vent.0.area=1e-30", "gas.reference_temperature=300.0"});
  const auto start = run.history.front();
  const auto gamma = run.state.gas_point.gamma;
  const double r = run.state.gas_point.gas_constant;
  for (const auto& row : run.history) {
    const double volume = 1e-3 + 0.3e-3 * std::sin(2.0 * std::numbers::pi * 50.0 * row.at("time_s"));
    EXPECT_NEAR(row.at("volume_m3"), volume, 1e-15);
    const auto exact = closed_form::adiabatic_piston(
        {{r, gamma}, start.at("pressure_Pa"), start.at("temperature_K"), 1e-3}, volume);
    claim::expect_relative({"G.10", "case piston_leak, sealed, every row: pressure [Pa]",
                            "3000 pieces of the path, 1e-10 each, partly cancelling over a period"},
                           row.at("pressure_Pa"), exact.state.pressure, 1e-7);
  }
}

TEST(gas_scene, sealed_bag_behind_a_spring_eq_closed_form) {
  const CaseRun run =
      run_case("bag_volume", {"unset tank.fabric", "vent.0.area=1e-30", "gas.initial.composition={N2=1.0}",
                              "inflator.0.mass_flow=1.0", "gas.reference_temperature=300.0",
                              "tank.volume={overpressure=[0.0, 1e6], value=[0.06, 0.56]}"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto start = run.history.front();
  const closed_form::SpringBag bag{{run.state.gas_point.gas_constant, run.state.gas_point.gamma},
                                   start.at("pressure_Pa"),
                                   start.at("temperature_K"),
                                   0.06,
                                   5e-7};
  const char* why = "linear in the state: the sum over 100 steps rounds";
  for (const auto& row : run.history) {
    const auto exact = closed_form::spring_bag_fill(bag, row.at("time_s"), 406.0);
    claim::expect_relative(
        {"G.18", "case bag_volume, sealed, a curve of two knots, every row: pressure [Pa]", why},
        row.at("pressure_Pa"), exact.pressure, 1e-12);
    claim::expect_relative(
        {"G.18", "case bag_volume, sealed, a curve of two knots, every row: volume [m3]", why},
        row.at("volume_m3"), exact.volume, 1e-12);
  }
}

/// With a leak, the pieces of the volume's path show, which the times of the output cut: not any more.
TEST(gas_scene, leaking_piston_does_not_depend_on_the_output) {
  const CaseRun coarse = run_case("piston_leak"),
                fine = run_case("piston_leak", {"output.history_every=2e-5"});
  ASSERT_EQ(fine.history.size(), 5 * (coarse.history.size() - 1) + 1);
  for (std::size_t i = 0; i < coarse.history.size(); ++i) {
    // Some 3000 and 7500 sub-steps within 1e-10 each, as far as the gas has not forgotten them; chords of the
    // path: 3e-6.
    EXPECT_NEAR(fine.history[5 * i].at("pressure_Pa") / coarse.history[i].at("pressure_Pa"), 1.0, 1e-9) << i;
  }
}

TEST(gas_scene, leak_and_flap_of_the_piston_contribute) {
  const CaseRun all = run_case("piston_leak"), no_flap = run_case("piston_leak", {"vent.0.area=1e-30"});
  EXPECT_GT(all.state.streams.outflows[0].mass, 1e-5);
  EXPECT_GT(all.state.streams.outflows[1].mass, 1e-4);
  EXPECT_LT(all.state.peaks.pressure, no_flap.state.peaks.pressure);
}

// Nitrogen leaves and no air comes in: none of the species of air runs out.
TEST(gas_scene, warmed_gas_comes_to_rest_without_what_is_outside) {
  const CaseRun run =
      run_case("tank_backflow", {"time.gas_method=rosenbrock", "tank.volume=1e-3",
                                 "gas.initial.pressure=101325.0", "gas.initial.temperature=250.0"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_NEAR(run.history.back().at("temperature_K"), 293.15, 1e-6 * 293.15);  // a sub-step's tolerance
}

TEST(gas_scene, implicit_method_of_the_stiff_tank_contributes) {
  const CaseRun implicit = run_case("tank_stiff");
  const CaseRun explicit_run = run_case("tank_stiff", {"time.gas_method=runge_kutta"});
  EXPECT_LT(8 * implicit.state.flows.gas_substeps, explicit_run.state.flows.gas_substeps);
  // Both within 1e-6 a sub-step of a balance that forgets.
  EXPECT_NEAR(implicit.history.back().at("pressure_Pa") / explicit_run.history.back().at("pressure_Pa"), 1.0,
              1e-5);
  const auto warned = coupled::scene_of("tank_stiff", {"tank.fabric.leak_law=screen"}).warnings;
  EXPECT_EQ(std::ranges::count_if(warned, [](auto& w) { return w.find("tank.fabric.leak_law") == 0; }), 1);
  const CaseRun screen = run_case("tank_stiff", {"tank.fabric.leak_law=screen"});
  // 20 times the leak area: a 400th of the overpressure.
  const auto over = [](const CaseRun& run) { return run.history.back().at("pressure_Pa") - 101325.0; };
  EXPECT_NEAR(over(screen) / over(implicit), 1.0 / 400.0, 0.2 / 400.0);
}

/// Fixed sub-steps by each explicit method, on both sides of its limit: the balance of the closed form, or an
/// error.
TEST(gas_scene, fixed_steps_of_each_method_have_their_limit) {
  const auto steady = closed_form::vented_fill_steady({{296.8, 1.4}, 1e-3, 0.5, 700.0, 1e-3});
  for (const auto& [method, limit] : std::vector<std::pair<std::string, double>>{
           {"euler", support::real_axis_limit(support::kEulerPolynomial)},
           {"runge_kutta", support::real_axis_limit(support::kRungeKutta4Polynomial)},
           {"dormand_prince", support::real_axis_limit(support::kDormandPrince5Polynomial)}}) {
    const auto run = [&](double share) {
      const double step = share * limit / -steady.fast_eigenvalue;
      return run_case("tank_fixed_steps",
                      {"time.gas_method=" + method, "time.gas_step=" + std::to_string(1e3 * step) + "e-3",
                       "output.history_every=0.15"});
    };
    const CaseRun below = run(0.9), above = run(1.1);
    ASSERT_EQ(below.outcome.status, driver::RunStatus::done) << below.outcome.message;
    // It starts 0.25 % off and shrinks by 0.8 a step (Euler), more than thirty times.
    EXPECT_NEAR(below.history.back().at("pressure_Pa") / steady.state.pressure, 1.0, 1e-5) << method;
    EXPECT_EQ(above.outcome.status, driver::RunStatus::failed) << method;
    EXPECT_NE(above.outcome.message.find("stability limit"), std::string::npos) << above.outcome.message;
  }
  const CaseRun implicit =
      run_case("tank_fixed_steps", {"time.gas_method=rosenbrock", "time.gas_step=0.015"});
  EXPECT_NEAR(implicit.history.back().at("pressure_Pa") / steady.state.pressure, 1.0, 1e-5);
}

TEST(gas_scene, volume_table_is_met_at_its_knots) {
  const CaseRun run = run_case("tank_stiff", {"output.history_every=0.0007"});
  EXPECT_NEAR(run.history.back().at("volume_m3"), 2e-4, 1e-18);
  // 0.0005 s behind the knot at 5 ms: linear between the knots.
  for (const auto& row : run.history) {
    const double share = std::clamp((row.at("time_s") - 0.005) / 0.01, 0.0, 1.0);
    EXPECT_NEAR(row.at("volume_m3"), 1e-4 * (1.0 + share), 1e-18) << row.at("time_s");
  }
  EXPECT_GT(pressure_at(run, 0.002), 101325.0);
}

/// The bag's fabric as a table: its outflow is area times density times the velocity at each level.
TEST(gas_scene, table_of_the_bags_fabric_is_its_outflow) {
  const CaseRun run = run_case("bag_leak_table"), half = run_case("bag_leak_table", {"fabric.porosity=0.5"}),
                tight = run_case("bag_leak_table", {"fabric.porosity=0"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const gas::Curve velocity({{0.0, 0.0}, {500.0, 0.017}, {5000.0, 0.12}, {20000.0, 0.4}, {50000.0, 0.8}},
                            gas::Outside::held);
  for (const auto& [one, share] : {std::pair{&run, 1.0}, {&half, 0.5}, {&tight, 0.0}}) {
    for (const auto& row : one->history) {
      const double excess = row.at("pressure_Pa") - 101325.0;
      const double expected = excess > 0.0 ? share * row.at("skin_area_m2") * row.at("gas_mass_kg") /
                                                 row.at("volume_m3") * velocity.value(excess)
                                           : 0.0;
      // The same product from the row's rounded numbers; p - p_a loses the digits of p.
      EXPECT_NEAR(row.at("fabric_outflow_kg_s"), expected, 1e-12 * expected + 1e-12) << row.at("time_s");
    }
  }
  // What it contributes: a third of the gas has left, half the overpressure at the end.
  EXPECT_GT(run.state.flows.fabric_mass_out, half.state.flows.fabric_mass_out);
  EXPECT_EQ(tight.state.flows.fabric_mass_out, 0.0);
  EXPECT_LT(run.state.peaks.pressure, tight.state.peaks.pressure);
  EXPECT_LT(run.state.peaks.mass_residual, 1e-12);
}

TEST(gas_scene, contact_opens_the_vent_from_the_next_step) {
  const CaseRun run = run_case("contact_vent");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const double touched = run.state.peaks.first_contact, opened = run.state.gas.triggers[1].first_on;
  ASSERT_GT(touched, 0.0);
  // The level with the first contact starts the step over which the sensor is on.
  EXPECT_EQ(opened, touched);
  for (const auto& row : run.history)
    EXPECT_TRUE(row.at("time_s") > touched || row.at("vent_outflow_kg_s") == 0.0) << row.at("time_s");
  EXPECT_GT(run.state.streams.outflows[0].mass, 1e-4);
}

}  // namespace
