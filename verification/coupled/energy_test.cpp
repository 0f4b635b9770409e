// SPDX-License-Identifier: Apache-2.0
// The books of the coupled scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "run_case.hpp"

namespace {

using coupled::CaseRun;
using coupled::run_case;

double supplied(const CaseRun& run) {
  return run.state.flows.enthalpy_in;
}

// 40 ms take the scenes through unfolding, first contact and the jet's full strength.
const std::vector<std::string> kShort{"scene.end_time=0.04"};

class coupled_books : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(scenes, coupled_books,
                         testing::Values("passenger_pendulum", "passenger_pendulum_no_jet"));

TEST_P(coupled_books, mass_ledger_and_energy_close) {
  const auto run = run_case(GetParam(), kShort);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_GT(run.state.peaks.first_contact, 0.0);  // the scene does what it is for
  EXPECT_GT(run.state.step.maximum, 1.2 * run.state.step.minimum) << "steps have to vary for this claim";
  const std::string scene = std::string(GetParam()) + ", 40 ms: ";
  const char* why = "bookkeeping: eps x some 2000 additions, whatever the scene does";
  claim::expect_near({"G.9", scene + "largest residual of the mass balance [-]", why},
                     run.state.peaks.mass_residual, 0.0, 1e-12);
  claim::expect_near({"K.20", scene + "largest residual of (K.20) over the supply [-]", why},
                     run.state.peaks.ledger_residual / supplied(run), 0.0, 1e-12);
  claim::expect_near({"K.21", scene + "largest drift of energy over the supply [-]",
                      "a third of a percent of what the gas keeps, below the ensemble's scatter"},
                     run.state.peaks.energy_residual / supplied(run), 0.0, 1e-3);
  EXPECT_GT(run.state.peaks.momentum_residual, 0.0);    // not left out: it rounds
  EXPECT_LT(run.state.peaks.momentum_residual, 1e-13);  // eps x some hundred additions of both signs
}

TEST(coupled_energy, drift_is_second_order_on_a_smooth_scene) {
  // The overpressure of the start keeps the sphere taut and sets it in motion: smooth, x and v far from zero
  // over most of the run. Fixed steps, two halvings, the end a multiple of each.
  std::vector<double> drift;
  for (const char* step : {"time.step=8e-6", "time.step=4e-6", "time.step=2e-6"}) {
    const auto run =
        run_case("sphere_inflation",
                 {step, "scene.end_time=0.016", "gas.initial.pressure=111325.0", "membrane.mesh.levels=2"});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    drift.push_back(run.state.peaks.energy_residual);
  }
  claim::expect_order(
      {"K.21", "sphere inflation, bag and gas together: drift of energy [J]", "the dt^4 term's share"}, drift,
      1.9, 2.1);
}

TEST(coupled_energy, drift_falls_with_the_step_on_the_pendulum_scene) {
  // Chaotic (wrinkles, contact): no order is claimed. A quarter of the step would leave a sixteenth of a
  // smooth scene's drift and a quarter of a first-order method's; half is what both have to beat.
  const auto coarse = run_case("passenger_pendulum_no_jet", {"scene.end_time=0.03"});
  const auto fine = run_case("passenger_pendulum_no_jet", {"scene.end_time=0.03", "time.safety=0.2"});
  ASSERT_EQ(coarse.outcome.status, driver::RunStatus::done) << coarse.outcome.message;
  ASSERT_EQ(fine.outcome.status, driver::RunStatus::done) << fine.outcome.message;
  EXPECT_EQ(coarse.state.time, fine.state.time);
  EXPECT_LT(fine.state.peaks.energy_residual, 0.5 * coarse.state.peaks.energy_residual);
}

TEST(coupled_energy, jet_work_from_gas_balances_too) {
  const auto run = run_case(
      "passenger_pendulum",
      {"scene.end_time=0.02", "inflator.0.jet.temperature=stagnation", "inflator.0.jet.jet_work=from_gas"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_EQ(run.state.flows.jet_work, 0.0);
  EXPECT_LT(run.state.peaks.energy_residual, 1e-3 * supplied(run));
}

// What the gas at a level lacks of the work that the books count up to it [J], root mean square over the run.
// Fixed steps, well below the bound; the work's rate swings with the skin, smooth but for elements that cross
// the jet's cut-off.
double lack_of_jet_work(const char* step) {
  const auto scene = coupled::scene_of(
      "jet_bag", {std::string("time.step=") + step, "gas.initial.pressure=121325.0", "membrane.mesh.levels=2",
                  "inflator.0.mass_flow=1.0", "inflator.0.jet.radius=0.08", "inflator.1.jet.radius=0.08"});
  driver::State state = driver::make_state(scene);
  double squares = 0.0;
  for (; state.time < 0.0016; ++state.steps) {
    driver::step(scene, state, {.record = true});
    // Constant heat capacities: U = p V / (gamma - 1).
    const double held = state.gas_point.pressure * state.level.volume / (state.gas_point.gamma - 1.0);
    squares += std::pow(state.level.internal_energy - held, 2);
    state.time += state.step.after;
  }
  return std::sqrt(squares / static_cast<double>(state.steps));
}

TEST(coupled_energy, jet_work_leaves_the_gas_at_second_order) {
  claim::expect_order({"K.21", "two jets in a bag: work that the gas lacks at a level [J]",
                       "smooth but for elements that cross the jet's cut-off"},
                      {lack_of_jet_work("8e-6"), lack_of_jet_work("4e-6"), lack_of_jet_work("2e-6")}, 1.9,
                      2.1);
}

TEST(coupled_energy, jet_work_is_what_the_jet_adds) {
  const auto run = run_case("passenger_pendulum", {"scene.end_time=0.02"});
  EXPECT_GT(run.state.flows.jet_work, 20 * run.state.peaks.energy_residual)
      << "the booked work has to stand out of the drift, else the balance could not miss it";
}

}  // namespace
