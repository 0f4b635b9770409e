// SPDX-License-Identifier: Apache-2.0
// Impactors on a rail and free, against a ball that floats free: momenta, energy, limits; frames that move.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "claim.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;
using Eigen::Vector3d;

// The case of the ball, with an impactor in place of its pendulum that begins where that hangs.
std::vector<std::string> struck_by(const std::vector<std::string>& motion,
                                   const std::string& centre = "[-0.16, 0.0, 0.03]") {
  std::vector<std::string> overrides{"unset pendulum", "impactor.centre=" + centre,
                                     "impactor.shape.type=sphere", "impactor.shape.radius=0.041"};
  for (const auto& key : motion) overrides.push_back("impactor.motion." + key);
  return overrides;
}

Vector3d momentum_of_skin(const driver::State& state) {
  const membrane::AdvanceSums& sums = state.bag->advance;
  return 0.5 * (sums.momentum_before + sums.momentum_after);
}

TEST(impactor_scene, what_a_guided_mass_loses_the_ball_gains) {
  const auto run =
      run_case("ball_impact", struck_by({"type=rail", "direction=[1, 0, 0]", "mass=8.41", "velocity=3.93"}));
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const double lost = 8.41 * (3.93 - run.history.back().at("impactor_velocity_m_s"));
  EXPECT_GT(lost, 0.5);
  claim::expect_relative(
      {"K.26", "guided mass strikes a free ball: impulse along its path [N s]", "eps x 1000 kicks"},
      -run.state.flows.path_impulse, lost, 1e-11);
  claim::expect_relative(
      {"K.53", "guided mass strikes a free ball: momentum of the ball along the rail [N s]",
       "eps x 1000 kicks"},
      momentum_of_skin(run.state).x(), lost, 1e-10);
  EXPECT_LT(run.state.peaks.ledger_residual, 1e-12 * run.state.peaks.energy_scale);
  // Friction turns the ball and pulls the mass across its rail, which takes that force.
  EXPECT_GT(run.state.flows.contact_impulse, 1.001 * lost);
  EXPECT_EQ(run.state.level.impactor.centre.z(), 0.03);
}

// A pendulum of 20 km is nearly a rail.
TEST(impactor_scene, rail_eq_pendulum_of_a_long_arm) {
  auto on_rail = struck_by({"type=rail", "direction=[1, 0, 0]", "mass=10", "velocity=4"});
  on_rail.insert(on_rail.end(),
                 {"contact.friction=0", "contact.stiffness_share=0.02"});  // soft, so that nothing bounces
  const auto rail = run_case("ball_impact", on_rail);
  const auto pendulum =
      run_case("ball_impact", {"pendulum.pivot=[-0.16, 0.0, 20000.03]", "pendulum.mass=10",
                               "pendulum.inertia_cg=0", "pendulum.cg_distance=2e4",
                               "pendulum.impactor_distance=2e4", "pendulum.initial_angular_velocity=2e-4",
                               "contact.friction=0", "contact.stiffness_share=0.02"});
  ASSERT_EQ(rail.outcome.status, driver::RunStatus::done) << rail.outcome.message;
  ASSERT_EQ(pendulum.outcome.status, driver::RunStatus::done) << pendulum.outcome.message;
  claim::expect_relative(
      {"K.53", "guided mass strikes a ball: impulse against that of a pendulum of 20 km [N s]",
       "the arc leaves the line by (0.08 m)^2 / 40 km, to other points of the mesh"},
      rail.state.flows.path_impulse, pendulum.state.flows.path_impulse, 1e-4);
  EXPECT_NEAR(rail.history.back().at("impactor_displacement_m"),
              2e4 * pendulum.history.back().at("pendulum_angle_rad"), 1e-5);
}

TEST(impactor_scene, momenta_of_a_free_body_and_a_ball_are_conserved) {
  const auto run =
      run_case("ball_impact", struck_by({"type=free", "mass=0.5", "velocity=[4, 0, 0]",
                                         "angular_velocity=[0, 20, 0]", "inertia=[3e-4, 3.4e-4, 4e-4]"}));
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const driver::State& state = run.state;
  EXPECT_GT(state.flows.friction_loss, 1e-3);
  const Vector3d body = 0.5 * state.body->velocity, start(2.0, 0.0, 0.0);
  claim::expect_near({"K.55", "free body strikes a free ball: change of momentum over that at the start",
                      "eps x 1000 kicks"},
                     (body + momentum_of_skin(state) - start).norm() / start.norm(), 0.0, 1e-11);
  // About the origin; positions and speeds belong to times half a step apart.
  const auto nodes = state.bag->position.map(), velocity = state.bag->velocity.map();
  Vector3d moment =
      0.5 * state.level.impactor.centre.cross(state.body->velocity) + state.body->motion.angular_momentum;
  const driver::Scene scene = coupled::scene_of("ball_impact");
  for (Eigen::Index n = 0; n < nodes.cols(); ++n)
    moment += scene.bag->model.node_mass[static_cast<std::size_t>(n)] *
              Vector3d(nodes.col(n)).cross(Vector3d(velocity.col(n)));
  const Vector3d spin_at_start(0.0, 20.0 * 3.4e-4, 0.0);
  const Vector3d before = 0.5 * Vector3d(-0.16, 0.0, 0.03).cross(Vector3d(4.0, 0.0, 0.0)) + spin_at_start;
  EXPECT_NEAR((moment - before).norm() / before.norm(), 0.0, 2e-3);
  EXPECT_LT(driver::energy_drift(state), 1e-3);
  EXPECT_GT(run.history.back().at("impactor_angular_velocity_rad_s"), 0.0);
}

TEST(impactor_scene, guided_mass_follows_its_parabola_to_the_stop) {
  const auto run = run_case("rail_stop");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto& row = run.history[300];  // 30 ms, before the stop
  const double t = row.at("time_s");
  EXPECT_NEAR(t, 0.03, 1e-9);
  claim::expect_relative(
      {"K.53", "guided mass under a brake of 500 N: displacement v t - F t^2 / 2 m [m]", "exact"},
      row.at("impactor_displacement_m"), 5.0 * t - 0.5 * 500.0 / 20.0 * t * t, 1e-11);
  EXPECT_LT(driver::energy_drift(run.state), 1e-6);
  EXPECT_GT(run.state.flows.impactor_damping, 10.0);
  EXPECT_LT(run.history.back().at("impactor_velocity_m_s"), -3.0);
}

// All that is free follows the frame; what is tied to nothing has no forces in it.
TEST(impactor_scene, field_of_a_sled_moves_a_ball_and_a_free_body_alike) {
  auto overrides = struck_by({"type=free", "mass=0.5", "inertia=[3e-4, 3e-4, 3e-4]"}, "[-0.3, 0.0, 0.0]");
  overrides.push_back(
      "scene.gravity={ time = [0.0, 0.005, 0.015], value = [[0, 0, 0], [300, 0, -40], [0, 0, 0]] }");
  const auto run = run_case("ball_impact", overrides);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const Vector3d change = 0.5 * 0.015 * Vector3d(300.0, 0.0, -40.0);
  claim::expect_near(
      {"K.41", "free body in the frame of a sled: change of velocity over that of the pulse, less 1",
       "exact"},
      (run.state.body->velocity - change).norm() / change.norm(), 0.0, 1e-12);
  const double mass = 4.0 * M_PI * 0.11 * 0.11 * 3e-3 * 620.0;
  EXPECT_NEAR((momentum_of_skin(run.state) / mass - change).norm() / change.norm(), 0.0, 1e-2);  // of facets
  const Vector3d gained = run.state.flows.driving_work > 0.0 ? change : Vector3d::Zero();
  EXPECT_GT(gained.norm(), 0.0);
  EXPECT_LT(driver::energy_drift(run.state), 1e-4);
  EXPECT_LT(run.state.peaks.ledger_residual, 1e-12 * run.state.peaks.energy_scale);
}

TEST(impactor_scene, torso_on_a_sled_follows_the_pulse_until_it_meets_the_bag) {
  const auto run = run_case("sled_pulse", {"unset impactor.motion.spring", "scene.end_time=0.03"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  ASSERT_EQ(run.state.flows.contact_impulse, 0.0);
  const auto& row = run.history.back();
  claim::expect_relative({"K.53", "torso on a sled, pulse of 250 m/s2 in 30 ms: velocity a t^2 / 2 T [m/s]",
                          "the last kick reaches half a step beyond the peak"},
                         row.at("impactor_velocity_m_s"), 0.5 * 250.0 * 0.03, 1e-6);
  claim::expect_relative({"K.53", "torso on a sled, pulse of 250 m/s2 in 30 ms: displacement a t^3 / 6 T [m]",
                          "central difference, (dt / t)^2"},
                         row.at("impactor_displacement_m"), 250.0 * 0.03 * 0.03 / 6.0, 1e-5);
}

TEST(impactor_scene, each_shape_keeps_energy_and_momentum_against_a_ball) {
  for (const char* shape : {"{ type = 'ellipsoid', half_axes = [0.05, 0.06, 0.07] }",
                            "{ type = 'cylinder', radius = 0.03, half_length = 0.05 }",
                            "{ type = 'disc', radius = 0.03, rim_radius = 0.02 }"}) {
    const auto run =
        run_case("ball_impact",
                 {"unset pendulum",
                  "impactor={ centre = [-0.2, 0.0, 0.02], shape = " + std::string(shape) +
                      ", motion = { type = 'free', mass = 0.5, velocity = [4, 0, 0], angular_velocity = "
                      "[10, 20, 5], inertia = [3e-4, 3.4e-4, 4e-4] } }"});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    EXPECT_GT(run.state.flows.contact_impulse, 0.1) << shape;
    EXPECT_LT(driver::energy_drift(run.state), 1e-3) << shape;
    EXPECT_LT(run.state.peaks.ledger_residual, 1e-12 * run.state.peaks.energy_scale) << shape;
    const Vector3d change =
        0.5 * run.state.body->velocity + momentum_of_skin(run.state) - Vector3d(2.0, 0.0, 0.0);
    EXPECT_LT(change.norm(), 2e-11) << shape;
  }
}

// A short pendulum, which turns its bar as it strikes: the bar's end meets the ball.
std::vector<std::string> swung_bar(const std::string& safety) {
  return {"unset pendulum", "contact.stiffness_share=0.1", "scene.end_time=0.012", "time.safety=" + safety,
          "impactor={ shape = { type = 'cylinder', radius = 0.03, half_length = 0.06 }, axis = [0, 0, 1], "
          "motion = "
          "{ type = 'pendulum', pivot = [-0.16, 0.0, 0.25], axis = [0, -1, 0], rest_direction = [0, 0, -1], "
          "mass = "
          "2.0, inertia_cg = 0.01, cg_distance = 0.2, impactor_distance = 0.2, initial_angular_velocity = "
          "25.0 } }"};
}

TEST(impactor_scene, bar_on_a_pendulum_turns_with_it) {
  std::vector<double> drift;
  for (const char* safety : {"0.5", "0.25", "0.125"}) {
    const auto run = run_case("ball_impact", swung_bar(safety));
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    EXPECT_GT(run.state.flows.contact_impulse, 0.5);
    EXPECT_LT(run.state.peaks.ledger_residual, 1e-12 * run.state.peaks.energy_scale);
    drift.push_back(driver::energy_drift(run.state));
    const Vector3d arm = run.state.level.impactor.centre - Vector3d(-0.16, 0.0, 0.25);
    EXPECT_NEAR(run.state.level.impactor.axes.col(2).cross(arm.normalized()).norm(), 0.0, 1e-14);
  }
  // The contact's moment about the pivot has the couple of forces off the bar's middle.
  claim::expect_order(
      {"K.21", "bar on a pendulum strikes a ball with its end: drift of the energy", "central difference"},
      drift, 1.7, 2.3);
  // Its farthest point feels the least mass: I / (L + reach)^2.
  EXPECT_NEAR(driver::impactor_mass(coupled::scene_of("ball_impact", swung_bar("0.5"))),
              (0.01 + 2.0 * 0.2 * 0.2) / std::pow(0.2 + 0.09, 2), 1e-14);
}

TEST(impactor_scene, pendulum_of_the_new_table_has_the_bits_of_the_old_one) {
  const auto old = run_case("ball_impact");
  std::vector<std::string> overrides{"unset pendulum", "impactor.shape.type=sphere",
                                     "impactor.shape.radius=0.041"};
  for (const char* key : {"type=pendulum", "pivot=[-0.16, 0.0, 1.34]", "axis=[0.0, -1.0, 0.0]",
                          "rest_direction=[0.0, 0.0, -1.0]", "mass=10.9", "inertia_cg=2.07",
                          "cg_distance=1.065", "impactor_distance=1.31", "initial_angular_velocity=3.0"})
    overrides.push_back(std::string("impactor.motion.") + key);
  const auto now = run_case("ball_impact", overrides);
  ASSERT_EQ(now.outcome.status, driver::RunStatus::done) << now.outcome.message;
  EXPECT_EQ(now.history, old.history);
  EXPECT_EQ(now.energy, old.energy);
}

}  // namespace
