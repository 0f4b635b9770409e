// SPDX-License-Identifier: Apache-2.0
// Jets of outlets above bag pressure in cases (J.12): on a plate, over a pulse, in a bag.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "engine/step.hpp"
#include "jet/jet.hpp"
#include "run_case.hpp"

namespace {

using Overrides = std::vector<std::string>;
constexpr double kAmbient = 101325.0;  // [Pa]

// Case plate_jet with 6 kg/s and its temperature at rest.
const Overrides kChoked{"inflator.0.mass_flow=6.0", "inflator.0.jet.outlet=expanded",
                        "inflator.0.jet.temperature=stagnation"};

closed_form::ExpandedOutlet plate_outlet(double mass_flow = 6.0) {
  const auto sonic = closed_form::sonic_outlet({{}, 406.0, true, mass_flow, 5e-3});
  return {{}, 406.0, 5e-3, kAmbient, sonic.static_pressure / kAmbient};
}

Overrides with(Overrides base, const Overrides& more) {
  base.insert(base.end(), more.begin(), more.end());
  return base;
}

double plate_force(const Overrides& more) {
  const auto run = coupled::run_case("plate_jet", with(kChoked, more));
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  return run.history.back().at("jet_force_N");
}

TEST(expanded_jet, plate_force_eq_thrust_and_what_is_turned_back) {
  const double loss = jet::momentum_loss(coupled::scene_of("plate_jet").jets.front().field.model());
  EXPECT_GT(plate_outlet().pressure_ratio, 3.0);
  for (const double e : {-0.5, 0.0, 0.3, 1.0, 4.0}) {
    const double exact = closed_form::plate_load(plate_outlet(), e);
    // Elements of 10 mm against a jet 90 mm wide: spectrally accurate, as the plate's edge is.
    claim::expect_relative({"J.12", fmt::format("case plate_jet, expanded, pe/p = 3.2, e = {}: force [N]", e),
                            "the cut-off's share of the momentum, which is left out"},
                           plate_force({fmt::format("inflator.0.jet.restitution={}", e)}), exact,
                           loss + 1e-5);
  }
  const double below = closed_form::sonic_outlet({{}, 406.0, true, 1.5, 5e-3}).static_pressure;
  EXPECT_LT(below, kAmbient);
  EXPECT_EQ(plate_force({"inflator.0.mass_flow=1.5"}),
            plate_force({"inflator.0.mass_flow=1.5", "inflator.0.jet.outlet=pressure_matched"}));
}

// A plate that the jet does not fit on: the rule on its elements is of second order.
TEST(expanded_jet, force_on_a_small_plate_converges_with_second_order) {
  const auto nozzle = closed_form::expanded_outlet(plate_outlet());
  const double radius = std::sqrt(5e-3 * nozzle.area_ratio / std::acos(-1.0)), half_side = 0.06;
  const double width = closed_form::round_jet_section({radius, 0.08}, 0.5).width;
  const double exact =
      closed_form::square_fraction(half_side, width) * closed_form::plate_load(plate_outlet(), 0.3);
  std::vector<double> errors;
  for (const int cells : {6, 12, 24, 48})
    errors.push_back(
        plate_force({"inflator.0.jet.cut_off=0.0", "inflator.0.jet.restitution=0.3", "target.width=0.12",
                     "target.height=0.12", fmt::format("target.columns={}", cells),
                     fmt::format("target.rows={}", cells)}) -
        exact);
  claim::expect_order({"J.12", "case plate_jet, expanded, a plate of 120 mm: force [N]",
                       "centroid rule; the next term h^4 is some percent of it on the coarsest mesh"},
                      errors, 1.9, 2.1);
  EXPECT_LT(std::abs(errors.back()), 1e-3 * exact);
}

// The pressure around the outlet is ambient: the outlet's own law is integrated alone. The pulse chokes and
// unchokes.
TEST(expanded_jet, impulse_on_a_plate_is_that_of_the_law) {
  for (const char* every : {"output.history_every=1e-3", "output.history_every=2.3e-4"}) {
    const auto scene = coupled::scene_of(
        "plate_jet",
        {"inflator.0.mass_flow={time=[0.0,0.004,0.0041,0.01],value=[0.0,9.0,6.0,0.0]}",
         "inflator.0.temperature={time=[0.0,0.01],value=[500.0,300.0]}", "inflator.0.jet.outlet=expanded",
         "inflator.0.jet.temperature=stagnation", "inflator.0.jet.restitution=0.4", every});
    const auto& part = scene.jets.front();
    double thrust = 0.0, load = 0.0;
    constexpr int panels = 200000;
    for (int i = 0; i < panels; ++i) {  // the midpoint rule, to 1e-9 of it
      const auto gas = gas::inflator_point(scene.gas->model, 0, 0.01 * (i + 0.5) / panels);
      const closed_form::SonicOutlet at{{gas.gas_constant, gas.cp / (gas.cp - gas.gas_constant)},
                                        gas.temperature,
                                        true,
                                        gas.mass_flow,
                                        part.outlet.area};
      const auto sonic = closed_form::sonic_outlet(at);
      const double ratio = sonic.static_pressure / kAmbient;
      if (ratio > 1.0) {
        const closed_form::ExpandedOutlet outlet{at.gas, at.temperature, at.area, kAmbient, ratio};
        thrust += 0.01 / panels * closed_form::expanded_outlet(outlet).thrust;
        load += 0.01 / panels * closed_form::plate_load(outlet, 0.4);
      } else {  // subsonic at ambient pressure, tested elsewhere
        const double flux = jet::momentum_flux(
            jet::outlet_state(part.outlet,
                              {gas.mass_flow, gas.temperature, gas.cp, gas.gas_constant, kAmbient}),
            part.outlet.area);
        thrust += 0.01 / panels * flux;
        load += 0.01 / panels * 1.4 * flux;
      }
    }
    double got_thrust = 0.0, got_load = 0.0;
    driver::State state = driver::make_state(scene);
    bool last = false;
    for (; !last; ++state.steps) {
      last = !(state.time < scene.time.end);
      driver::evaluate_level(scene, state, {.last = last});
      const double kick = 0.5 * (state.step.before + state.step.after);
      const auto& run = state.jets.front();
      got_thrust += kick * jet::momentum_flux(run.outlet, part.outlet.area);
      got_load += kick * run.force.norm();
      driver::advance_level(scene, state, {.last = last});
      state.time += state.step.after;
    }
    claim::expect_relative(
        {"J.11", fmt::format("plate, pulse of an expanded jet, {}: thrust's impulse [N s]", every),
         "midpoint rule of the exact integral"},
        got_thrust, thrust, 1e-8);
    EXPECT_NEAR(got_load, load, (2e-6 + 1e-8) * load) << "the cut-off leaves out 1e-6";
  }
}

// Back to back in a bag, the first choked up to pe/p of 3.
const Overrides kBag{"inflator.0.jet.outlet=expanded", "inflator.1.jet.outlet=expanded",
                     "inflator.0.mass_flow={time=[0.0,0.005,0.015],value=[0.5,2.0,0.0]}"};
const Overrides kExternal{"inflator.0.jet.jet_work=external", "inflator.1.jet.jet_work=external"};

TEST(expanded_jet, balances_in_a_bag_close) {
  for (const Overrides& work : {Overrides{}, kExternal}) {
    const auto scene = coupled::scene_of("jet_bag", with(kBag, work));
    driver::State state = driver::make_state(scene);
    double most = 0.0;
    const auto outcome = driver::run_scene(scene, state, [&](bool, const driver::State& now) {
      most = std::max(most, now.jets.front().outlet.area_ratio);
    });
    ASSERT_EQ(outcome.status, driver::RunStatus::done) << outcome.message;
    EXPECT_GT(most, 1.2) << "the jet has to expand";
    const double supplied = state.flows.enthalpy_in;
    const std::string what =
        work.empty() ? "jet_bag, expanded, work from the gas: " : "jet_bag, expanded, work external: ";
    claim::expect_near({"K.20", what + "largest residual of (K.20) over the supply [-]",
                        "bookkeeping: eps x some 2000 additions"},
                       state.peaks.ledger_residual / supplied, 0.0, 1e-12);
    EXPECT_LT(state.peaks.mass_residual, 1e-12);
    EXPECT_LT(state.peaks.energy_residual, 1e-3 * supplied);
    EXPECT_GT(state.peaks.momentum_residual, 0.0);
    EXPECT_LT(state.peaks.momentum_residual, 1e-13);
    EXPECT_EQ(state.flows.jet_work == 0.0, work.empty());
  }
}

// In a bag the pressure around the outlet changes: a held bag, so that nothing else does.
double impulse_in_a_held_bag(double step) {
  const auto scene = coupled::scene_of(
      "jet_bag",
      with(kBag, {"membrane.mesh.levels=2", "membrane.fixed_panels=[\"sphere\"]", "scene.end_time=0.0032",
                  "inflator.0.mass_flow={time=[0.0,0.0032],value=[1.0,2.0]}", "inflator.1.start_time=1.0",
                  fmt::format("time.step={}", step)}));
  driver::State state = driver::make_state(scene);
  double impulse = 0.0;
  bool last = false;
  for (; !last; ++state.steps) {
    last = !(state.time < scene.time.end);
    driver::evaluate_level(scene, state, {.last = last});
    impulse += 0.5 * (state.step.before + state.step.after) *
               jet::momentum_flux(state.jets.front().outlet, scene.jets.front().outlet.area);
    driver::advance_level(scene, state, {.last = last});
    state.time += state.step.after;
  }
  return impulse;
}

TEST(expanded_jet, impulse_follows_the_bags_pressure_with_second_order) {
  std::vector<double> impulses, differences;
  for (const double step : {3.2e-5, 1.6e-5, 8e-6, 4e-6}) impulses.push_back(impulse_in_a_held_bag(step));
  for (std::size_t i = 0; i + 1 < impulses.size(); ++i) differences.push_back(impulses[i] - impulses[i + 1]);
  claim::expect_order({"J.12", "expanded jet in a held bag: its impulse, differences between steps [N s]",
                       "bag pressure of the middle of each kick; the half kicks at both ends add one step's"},
                      differences, 1.9, 2.1);
}

}  // namespace
