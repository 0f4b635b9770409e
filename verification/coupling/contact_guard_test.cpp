// SPDX-License-Identifier: Apache-2.0
// Where contact ends: penetration beyond r/2, the centre crossing the skin, coordinates that are not finite,
// and bad input at build.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

// One run of levels; every call checks the path from the last.
struct Path {
  scenes::Skin skin;
  coupling::ContactModel model;
  coupling::ContactState state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());

  explicit Path(const scenes::Skin& s) : skin(s), model(scenes::contact(s, kRadius, kStiffness)) {}
  std::string go(const Vector3d& centre) {
    try {
      model.evaluate(state, skin.nodes, centre, forces);
    } catch (const coupling::ContactError& error) {
      return error.what();
    }
    return "";
  }
};

bool names(const std::string& message, const std::string& what) {
  return message.find(what) != std::string::npos;
}

TEST(ContactGuard, penetration_beyond_half_the_radius_throws) {
  // One element under the centre, its quadrature point at the foot: the threshold is exact to round-off.
  scenes::Skin skin = scenes::plate(1, 0.1 * kRadius);
  const Vector3d foot = (skin.nodes.col(0) + skin.nodes.col(2) + skin.nodes.col(3)) / 3.0;
  for (const double depth : {0.1, 0.4, 0.499999, 0.500001, 0.7}) {
    Path run(skin);
    const std::string message = run.go(foot + Vector3d(0.0, 0.0, (1.0 - depth) * kRadius));
    EXPECT_EQ(message.empty(), depth < 0.5) << depth << message;
    if (depth > 0.5) {
      EXPECT_TRUE(names(message, "penetration") && names(message, "element 0")) << message;
    }
  }
}

TEST(ContactGuard, centre_on_the_skin_throws) {
  Path run(scenes::plate(4, 0.1 * kRadius));
  EXPECT_TRUE(names(run.go(Vector3d::Zero()), "penetration"));
}

TEST(ContactGuard, jump_across_the_skin_is_found) {
  for (const double size : {0.1, 1.0, 10.0}) {
    Path run(scenes::plate(6, size * kRadius));
    EXPECT_EQ(run.go({0.001, 0.002, 2.0 * kRadius}), "");
    EXPECT_TRUE(names(run.go({0.003, 0.001, -2.0 * kRadius}), "crossed the skin at element")) << size;
  }
}

TEST(ContactGuard, skin_that_jumps_across_the_centre_is_found) {
  Path run(scenes::plate(6, kRadius));
  EXPECT_EQ(run.go({0.001, 0.002, 2.0 * kRadius}), "");
  run.skin.nodes.row(2).array() += 4.0 * kRadius;
  EXPECT_TRUE(names(run.go({0.001, 0.002, 2.0 * kRadius}), "crossed the skin"));
}

// Both layers of a thin sleeve at once: the centre ends outside again, so a winding number would say nothing.
TEST(ContactGuard, jump_across_two_layers_is_found) {
  const scenes::Skin plate = scenes::plate(6, kRadius);
  scenes::Skin sleeve = plate;
  sleeve.nodes.resize(3, 2 * plate.nodes.cols());
  sleeve.nodes << plate.nodes, (plate.nodes.colwise() - Vector3d(0.0, 0.0, 0.001));
  sleeve.triangles.resize(3, 2 * plate.triangles.cols());
  sleeve.triangles << plate.triangles,
      (plate.triangles.array() + static_cast<int>(plate.nodes.cols())).matrix();
  scenes::lump_masses(sleeve, 0.31);
  Path run(sleeve);
  EXPECT_EQ(run.go({0.0, 0.001, 2.0 * kRadius}), "");
  EXPECT_TRUE(names(run.go({0.0, 0.001, -2.0 * kRadius}), "crossed the skin"));
}

TEST(ContactGuard, jumps_that_do_not_cross_pass) {
  Path run(scenes::plate(6, 0.5 * kRadius));  // 3 radii wide
  EXPECT_EQ(run.go({0.0, 0.0, 3.0 * kRadius}), "");
  EXPECT_EQ(run.go({20.0 * kRadius, 0.0, 0.0}), "");
  EXPECT_EQ(run.go({0.0, 0.0, -3.0 * kRadius}), "");
  EXPECT_GT(run.state.sweeps, 0);
  run.skin.nodes.row(2).array() += 1.0;  // skin and sphere fly together
  EXPECT_EQ(run.go({0.0, 0.0, 1.0 - 3.0 * kRadius}), "");
}

// A crossing is found at any number of steps on the way, or the penetration before it.
TEST(ContactGuard, no_step_size_slips_through) {
  for (int steps = 1; steps < 60; ++steps) {
    Path run(scenes::plate(6, kRadius));
    std::string message;
    for (int n = 0; n <= steps && message.empty(); ++n)
      message = run.go({0.001, 0.002, kRadius * (2.0 - 4.0 * n / steps)});
    EXPECT_FALSE(message.empty()) << steps;
  }
}

TEST(ContactGuard, ordinary_steps_need_no_sweep) {
  Path run(scenes::plate(20, 0.3 * kRadius));
  for (int n = 0; n < 300; ++n)  // 2 mm a step
    ASSERT_EQ(run.go({0.05 * std::sin(0.04 * n), 0.0, kRadius * (1.1 + 0.4 * std::sin(0.05 * n))}), "");
  EXPECT_EQ(run.state.sweeps, 0);
}

TEST(ContactGuard, beginning_anew_forgets_the_path) {
  Path run(scenes::plate(6, kRadius));
  EXPECT_EQ(run.go({0.0, 0.0, 2.0 * kRadius}), "");
  run.state.started = false;
  EXPECT_EQ(run.go({0.0, 0.0, -2.0 * kRadius}), "");
}

TEST(ContactGuard, coordinates_that_are_not_finite_throw) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Path run(scenes::plate(6, kRadius));
    EXPECT_TRUE(names(run.go({bad, 0.0, 1.0}), "not finite"));
    Path other(scenes::plate(6, kRadius));
    EXPECT_EQ(other.go({0.0, 0.0, 1.0}), "");
    other.skin.nodes(1, 17) = bad;
    EXPECT_TRUE(names(other.go({0.0, 0.0, 1.0}), "not finite"));
  }
}

TEST(ContactGuard, bad_input_names_the_field) {
  struct Input {
    scenes::Skin skin = scenes::plate(2, kRadius);
    double mass = 8.41;
    coupling::ContactParameters parameters{kRadius, kStiffness};
  };
  const std::vector<std::pair<const char*, std::function<void(Input&)>>> faults = {
      {"contact.sphere_radius", [](Input& i) { i.parameters.sphere_radius = 0.0; }},
      {"contact.stiffness", [](Input& i) { i.parameters.stiffness = std::nan(""); }},
      {"contact.effective_mass", [](Input& i) { i.mass = -1.0; }},
      {"contact.masses", [](Input& i) { i.skin.masses.pop_back(); }},
      {"contact.masses[3]", [](Input& i) { i.skin.masses[3] = 0.0; }},
      {"contact.triangles[1]", [](Input& i) { i.skin.triangles(2, 1) = 9; }},
      {"contact.triangles[1]", [](Input& i) { i.skin.triangles(2, 1) = -1; }},
      {"contact.reference element 0 area", [](Input& i) { i.skin.nodes.col(4) = i.skin.nodes.col(0); }},
      {"contact.reference element 0", [](Input& i) { i.parameters.sphere_radius = 1e-4; }}};
  for (const auto& [field, fault] : faults) {
    Input i;
    fault(i);
    try {
      coupling::ContactModel model(i.skin.triangles, i.skin.nodes, i.skin.masses, i.mass, i.parameters);
      ADD_FAILURE() << field << " accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(field, 0), 0u) << error.what();
    }
  }
}

TEST(ContactGuard, arrays_of_another_mesh_are_refused) {
  Path run(scenes::plate(2, kRadius));
  run.skin = scenes::plate(3, kRadius);
  EXPECT_THROW(run.go({0.0, 0.0, 1.0}), std::invalid_argument);
}

}  // namespace
