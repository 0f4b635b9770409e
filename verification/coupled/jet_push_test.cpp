// SPDX-License-Identifier: Apache-2.0
// What `gasjet check` says of how much a jet pushes, against closed forms and runs.
#include "forecast/jet_push.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "closed_form/jet.hpp"
#include "run_case.hpp"

namespace {

using coupled::scene_of;

TEST(jet_push, load_in_free_air_is_that_of_the_run_that_it_names) {
  const auto scene = scene_of("plate_jet");
  const driver::JetPush push = driver::jet_push(scene, scene.jets.front());
  const double rest = 1.2 * 406.0;  // (gamma + 1) / 2
  EXPECT_NEAR(push.rest_temperature, rest, 1e-10);
  const auto run = coupled::run_case(
      "plate_jet", {"inflator.0.temperature=" + std::to_string(rest), "inflator.0.jet.outlet=\"expanded\"",
                    "inflator.0.jet.temperature=\"stagnation\"", "inflator.0.jet.restitution=0"});
  // The case's cut-off leaves out 1e-6, and as much is the lattice's share.
  EXPECT_NEAR(run.history.back().at("jet_force_N") / push.thrust, 1.0, 3e-6);
  const auto sonic = closed_form::sonic_outlet({{}, 406.0, false, 2.0, 5e-3});
  EXPECT_NEAR(push.momentum / sonic.momentum_flux, 1.0, 1e-14);
  EXPECT_NEAR(push.pressure_ratio, sonic.static_pressure / 101325.0, 1e-13);
  EXPECT_NEAR(push.load, 2.0 * sonic.momentum_flux, 1e-10);
  EXPECT_EQ(push.most_load, push.load);
}

TEST(jet_push, outlet_below_the_pressure_around_it_has_no_pressure_thrust) {
  const auto scene = scene_of("plate_jet", {"inflator.0.mass_flow=1.0"});
  const driver::JetPush push = driver::jet_push(scene, scene.jets.front());
  EXPECT_LT(push.pressure_ratio, 1.0);
  EXPECT_LT(push.thrust, push.momentum) << "the matched outlet is subsonic";
}

TEST(jet_push, curve_of_restitution_has_both_ends) {
  const auto scene =
      scene_of("passenger_sharp", {"inflator.0.jet.restitution={mass_ratio=[0,0.2,1],value=[-0.2,0.4,0.3]}"});
  const driver::JetPush push = driver::jet_push(scene, scene.jets.front());
  EXPECT_NEAR(push.load, 0.8 * push.momentum, 1e-9);
  EXPECT_NEAR(push.most_load, 1.4 * push.momentum, 1e-9);
}

// A sphere of radius r: depth 2 r less the outlet's distance from its rim, over its diameter; the projection
// of the icosphere is smaller by 1 %.
TEST(jet_push, depth_over_width_of_a_sphere_does_not_know_its_direction) {
  const auto scene = scene_of("jet_bag");
  for (const auto& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 1, 1),
                           Eigen::Vector3d(1e-3, 1e-3, 1)}) {
    jet::JetModel model = scene.jets.front().field.model();
    model.centre.setZero();
    model.axis = axis.normalized();
    const auto range = driver::restitution_range(scene, model);
    ASSERT_TRUE(range.has_value());
    EXPECT_NEAR(range->depth_over_width, 0.5, 0.01);
    EXPECT_FALSE(range->deep);
    EXPECT_EQ(range->high, 1.0);
  }
}

TEST(jet_push, bag_that_is_flat_as_sewn_has_no_shape) {
  auto scene = scene_of("passenger_sharp");
  EXPECT_TRUE(driver::restitution_range(scene, scene.jets.front().field.model())->deep);
  scene.bag->mesh.nodes.row(0) *= 1e-9;
  EXPECT_FALSE(driver::restitution_range(scene, scene.jets.front().field.model()).has_value());
  EXPECT_FALSE(driver::missing_energy(scene, scene.jets.front()).pressure.has_value());
}

// 0.16 kg at V0^2 / 2 = gamma R T / 2, of the case's nitrogen (gamma by its own cp).
TEST(jet_push, missing_energy_is_the_kinetic_energy_of_the_inflow) {
  const auto scene = scene_of("passenger_sharp");
  const auto missing = driver::missing_energy(scene, scene.jets.front());
  const double speed = driver::jet_push(scene, scene.jets.front()).momentum / 4.0;
  EXPECT_NEAR(missing.energy, 0.16 * 0.5 * speed * speed, 1e-9 * missing.energy);
}

}  // namespace
