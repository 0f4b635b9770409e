// SPDX-License-Identifier: Apache-2.0
// Options of a case against the same case without them, and against a closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/pendulum.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

// What `gasjet check` prints as taken by default is a key that the case may say itself.
TEST(case_options, check_names_only_keys_that_the_case_may_set) {
  const std::vector<std::pair<const char*, std::vector<std::string>>> scenes{
      {"rigid_tank", {"time={}"}},    {"piston_leak", {"time={}"}}, {"bag_volume", {"time={}"}},
      {"tank_triggers", {"time={}"}}, {"plate_jet", {"time={}"}},   {"contact_vent", {"time={}"}},
      {"pendulum_swing", {}}};
  for (const auto& [name, overrides] : scenes) {
    const auto file = coupled::fs::path(GASJET_SOURCE_DIR "/cases") / (std::string(name) + ".toml");
    driver::CaseDocument document(file, overrides);
    driver::load_scene(document);
    std::vector<std::string> defaults;
    for (const auto& setting : document.settings())
      if (setting.is_default) defaults.push_back(setting.path + "=" + setting.value);
    EXPECT_FALSE(defaults.empty()) << name;
    EXPECT_EQ(coupled::message_of(file, defaults), "accepted") << name;
  }
}

double swing_error(const char* step) {
  const auto run = run_case("pendulum_swing", {std::string("time.step=") + step, "scene.end_time=1"});
  const double exact = closed_form::pendulum_swing(closed_form::paper_pendulum(), M_PI / 3.0, 1.0).angle;
  return run.history.back().at("pendulum_angle_rad") - exact;
}

TEST(case_options, initial_angle_swings_as_the_closed_form_with_order_2) {
  claim::expect_order(
      {"K.4", "case pendulum_swing: angle at the end", "(omega0 dt)^2 = 0.0008 changes the ratio by as much"},
      {swing_error("0.01"), swing_error("0.005"), swing_error("0.0025")}, 1.98, 2.02);
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
  // on, to what the ends move in it.
  const auto& velocity = held.state.bag->velocity.map();
  const double motion =
      (velocity.col(nodes.node_b) - velocity.col(nodes.node_a)).norm() * held.state.step.maximum;
  const double force = held.history.back().at("strap_force_N");
  EXPECT_NEAR(force, std::sqrt(2.0 * 4500.0 * held.energy.back().at("strap_J")), 1e-12 * force);
  EXPECT_NEAR(force, 4500.0 * (length - 0.5), 4500.0 * motion);
  EXPECT_LT(motion, 1e-3);
  EXPECT_EQ(slack.history.back().at("strap_force_N"), 0.0);
}

TEST(case_options, mass_damping_brings_the_sphere_to_rest) {
  const auto damped = run_case("strapped_sphere");
  const auto free = run_case("strapped_sphere", {"membrane.mass_damping=0"});
  // exp(-100 * 0.06) = 1/403 of the energy is left; the phase of the breathing varies it.
  EXPECT_LT(damped.energy.back().at("skin_kinetic_J"), 0.02 * free.energy.back().at("skin_kinetic_J"));
  EXPECT_GT(damped.energy.back().at("damping_J"), 0.0);
  EXPECT_FALSE(free.energy.back().contains("damping_J"));
}

TEST(case_options, shapes_come_from_files_in_their_unit) {
  const auto scene = coupled::scene_of("bag_from_files");
  const double full = 4.0 / 3.0 * M_PI * std::pow(0.3, 3) * closed_form::icosphere_ratios(1).volume_ratio;
  const auto volume = [&](const auto& nodes) {
    return mesh::enclosed_volume(nodes, scene.bag->mesh.elements);
  };
  // Nine decimals of a millimetre: 3e-12 of the radius, 3e-11 of the flattened one.
  EXPECT_NEAR(volume(scene.bag->mesh.nodes) / full, 1.0, 1e-11);
  EXPECT_NEAR(volume(scene.bag->initial_position) / full, 0.1, 1e-11);
}

TEST(case_options, curves_of_named_columns_are_those_written_in_the_case) {
  const auto files = run_case("bag_from_files");
  const auto inside = run_case("bag_from_files",
                               {"inflator.0.mass_flow={ time = [0.0, 0.02, 0.04], value = [0.0, 4.5, 0.0] }",
                                "fabric.velocity={ overpressure = [0.0, 500.0, 5000.0, 20000.0, 50000.0], "
                                "value = [0.0, 0.017, 0.12, 0.4, 0.8] }"});
  ASSERT_EQ(files.outcome.status, driver::RunStatus::done) << files.outcome.message;
  ASSERT_EQ(files.history.size(), inside.history.size());
  EXPECT_EQ(files.history.back().at("pressure_Pa"), inside.history.back().at("pressure_Pa"));
  EXPECT_EQ(files.history.back().at("volume_m3"), inside.history.back().at("volume_m3"));
  EXPECT_GT(files.history.back().at("pressure_Pa"), 101.5e3);  // it inflates
  EXPECT_LT(files.history.back().at("gas_mass_kg") - files.history.front().at("gas_mass_kg"),
            0.99 * 0.09);  // and leaks
}

TEST(case_options, constant_cp_is_that_of_the_reference_temperature) {
  const auto cp = [](const std::vector<std::string>& overrides) {
    const auto gas = run_case("bag_from_files", overrides).state.gas_point;
    return 0.0280134 * gas.gas_constant * gas.gamma / (gas.gamma - 1.0);
  };
  // Nitrogen [J/(mol K)], M. W. Chase, NIST-JANAF Thermochemical Tables (1998); the NASA fit is within 0.1 %.
  EXPECT_NEAR(cp({"scene.end_time=1e-3"}), 30.110, 0.03);
  EXPECT_NEAR(cp({"scene.end_time=1e-3", "gas.reference_temperature=298.15"}), 29.124, 0.03);
}

}  // namespace
