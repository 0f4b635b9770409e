// SPDX-License-Identifier: Apache-2.0
// Options of a case against the same case without them, and against a closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "closed_form/pendulum.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

double swing_error(const char* step) {
  const auto run = run_case("pendulum_swing", {std::string("time.step=") + step, "scene.end_time=1"});
  const double exact = closed_form::pendulum_swing(closed_form::paper_pendulum(), M_PI / 3.0, 1.0).angle;
  return run.history.back().pendulum_angle_rad - exact;
}

TEST(case_options, initial_angle_swings_as_the_closed_form_with_order_2) {
  // Central difference: second order. Half-steps of 0.02 s leave a relative change of the ratio of (omega0
  // dt)^2 = 0.003, for which the band is wide.
  const double coarse = swing_error("0.02"), middle = swing_error("0.01"), fine = swing_error("0.005");
  EXPECT_GT(std::log2(coarse / middle), 1.95);
  EXPECT_LT(std::log2(coarse / middle), 2.05);
  EXPECT_GT(std::log2(middle / fine), 1.98);
  EXPECT_LT(std::log2(middle / fine), 2.02);
}

double pole_distance(const driver::State& state) {
  const auto z = state.bag->position.map().row(2);
  return z.maxCoeff() - z.minCoeff();
}

TEST(case_options, strap_between_named_points_holds_the_sphere_in) {
  const auto held = run_case("strapped_sphere");
  const auto slack = run_case("strapped_sphere", {"membrane.strap.0.free_length=2"});
  const auto& strap = held.state.bag->position.map();
  const auto scene = coupled::scene_of("strapped_sphere");
  const auto& nodes = scene.bag->model.description.straps.front();
  for (const int node : {nodes.node_a, nodes.node_b})  // the poles of the design shape
    EXPECT_LT(scene.bag->mesh.nodes.col(node).head<2>().norm(), 1e-12);
  const double length = (strap.col(nodes.node_b) - strap.col(nodes.node_a)).norm();
  EXPECT_LT(length, 0.6);
  EXPECT_GT(pole_distance(slack.state), 0.6);
  // Hooke's law: force against energy of one level to round-off; against the length, which is a step further
  // on, to what the damped sphere still moves in a step, 1e-4 m at a few tenths of a m/s.
  const double force = held.history.back().strap_force_N;
  EXPECT_NEAR(force, std::sqrt(2.0 * 4500.0 * held.energy.back().strap_J), 1e-12 * force);
  EXPECT_NEAR(force, 4500.0 * (length - 0.5), 4500.0 * 1e-4);
  EXPECT_EQ(slack.history.back().strap_force_N, 0.0);
}

TEST(case_options, mass_damping_brings_the_sphere_to_rest) {
  const auto damped = run_case("strapped_sphere");
  const auto free = run_case("strapped_sphere", {"membrane.mass_damping=0"});
  // exp(-100 * 0.06) = 1/403 of the energy is left; the phase of the breathing varies it.
  EXPECT_LT(damped.energy.back().skin_kinetic_J, 0.02 * free.energy.back().skin_kinetic_J);
  EXPECT_GT(damped.energy.back().damping_J, 0.0);
  EXPECT_EQ(free.energy.back().damping_J, 0.0);
}

}  // namespace
