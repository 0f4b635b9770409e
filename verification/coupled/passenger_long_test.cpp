// SPDX-License-Identifier: Apache-2.0
// The paper's scene, with its jet and without, over its whole 100 ms: books, and the impactor's side of the
// skin.
#include <gtest/gtest.h>

#include "coupling/side.hpp"
#include "run_case.hpp"

namespace {

class passenger_long : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(scenes, passenger_long,
                         testing::Values("passenger_pendulum", "passenger_pendulum_no_jet"));

TEST_P(passenger_long, books_close_and_the_sphere_stays_outside_for_100_ms) {
  const driver::Scene scene = coupled::scene_of(GetParam());
  driver::State state = driver::make_state(scene);
  int rows = 0;
  const auto outcome = driver::run_scene(scene, state, [&](bool recorded, const driver::State& now) {
    if (!recorded) return;
    ++rows;
    const Eigen::Vector3d centre = scene.pendulum->model.impactor_centre(now.pendulum->motion.angle);
    // Whole numbers to round-off (K.14).
    EXPECT_NEAR(coupling::winding_number(scene.bag->mesh.elements, now.bag->position.map(), centre), 0.0,
                1e-6)
        << now.time;
  });
  ASSERT_EQ(outcome.status, driver::RunStatus::done) << outcome.message;
  EXPECT_EQ(state.time, 0.1);
  EXPECT_EQ(rows, 1001);
  EXPECT_GT(state.peaks.penetration, 0.0);
  const double supplied = state.flows.enthalpy_in;
  // Round-off of some 10 000 additions; the drift's limit is that of the short runs.
  EXPECT_LT(state.peaks.mass_residual, 1e-12);
  EXPECT_LT(state.peaks.ledger_residual, 1e-12 * supplied);
  EXPECT_LT(state.peaks.energy_residual, 1e-3 * supplied);
}

// As without the jet: chaotic, no order, but half at a quarter of the step.
TEST(passenger_long_drift, falls_with_the_step_with_the_jet_too) {
  const auto coarse = coupled::run_case("passenger_pendulum", {"scene.end_time=0.03"});
  const auto fine = coupled::run_case("passenger_pendulum", {"scene.end_time=0.03", "time.safety=0.2"});
  ASSERT_EQ(coarse.outcome.status, driver::RunStatus::done) << coarse.outcome.message;
  ASSERT_EQ(fine.outcome.status, driver::RunStatus::done) << fine.outcome.message;
  EXPECT_LT(fine.state.peaks.energy_residual, 0.5 * coarse.state.peaks.energy_residual);
}

}  // namespace
