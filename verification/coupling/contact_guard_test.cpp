// SPDX-License-Identifier: Apache-2.0
// Where contact ends: penetration beyond r/2, the centre crossing the skin, coordinates that are not finite,
// and bad input at build.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "bisection.hpp"
#include "claim.hpp"
#include "refusal.hpp"
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
      model.evaluate(state, skin.nodes, {centre}, forces);
    } catch (const coupling::ContactError& error) {
      return error.what();
    }
    return "";
  }
};

// Both layers of a fold, 1 mm apart.
scenes::Skin sleeve() {
  const scenes::Skin plate = scenes::plate(6, kRadius);
  scenes::Skin both = plate;
  both.nodes.resize(3, 2 * plate.nodes.cols());
  both.nodes << plate.nodes, (plate.nodes.colwise() - Vector3d(0.0, 0.0, 0.001));
  both.triangles.resize(3, 2 * plate.triangles.cols());
  both.triangles << plate.triangles,
      (plate.triangles.array() + static_cast<int>(plate.nodes.cols())).matrix();
  scenes::lump_masses(both, 0.31);
  return both;
}

bool names(const std::string& message, const std::string& what) {
  return message.find(what) != std::string::npos;
}

TEST(ContactGuard, penetration_beyond_half_the_radius_throws) {
  // One element under the centre, its quadrature point at the foot: the threshold is exact to round-off.
  scenes::Skin skin = scenes::plate(1, 0.1 * kRadius);
  const Vector3d foot = (skin.nodes.col(0) + skin.nodes.col(2) + skin.nodes.col(3)) / 3.0;
  const auto passes = [&](double depth) {
    Path run(skin);
    const std::string message = run.go(foot + Vector3d(0.0, 0.0, kRadius - depth));
    EXPECT_TRUE(message.empty() || (names(message, "penetration") && names(message, "element 0"))) << message;
    return message.empty();
  };
  const double deepest = claim::largest_passing(0.1 * kRadius, 0.7 * kRadius, 1e-9, passes);
  claim::expect_threshold({"K.24", "sphere of 41 mm pressed into a plate", "bisection to 1e-9"},
                          {"penetration", "r/2", 0.5 * kRadius, deepest, "m",
                           "exit 3, naming element, depth and limit; contact's force ends there"},
                          1.0 - 1e-8, 1.0 + 1e-8);
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

// One step straight down from a clear height: past r/2 deep it is refused, and where the centre has come to
// the skin the sweep names the crossing, however far it goes.
TEST(ContactGuard, centre_crosses_from_where_the_step_is_as_long_as_its_height) {
  const double height = 2.0 * kRadius;
  for (const bool two_layers : {false, true}) {
    const auto message = [&](double motion) {
      Path run(two_layers ? sleeve() : scenes::plate(6, kRadius));
      EXPECT_EQ(run.go({0.001, 0.002, height}), "");
      return run.go({0.001, 0.002, height - motion});
    };
    const double longest = claim::largest_passing(1.6 * kRadius, 10.0 * kRadius, 1e-4, [&](double motion) {
      const std::string text = message(motion);
      EXPECT_TRUE(names(text, "penetration") || names(text, "crossed the skin at element")) << text;
      return !names(text, "crossed the skin");
    });
    claim::expect_threshold(
        {"K.15", two_layers ? "sphere's centre 82 mm over two layers 1 mm apart" : "the same over one layer",
         "bisection to 1e-4; less motion than the distance needs no sweep"},
        {"centre crosses the skin", "motion in a step = distance of the centre", height, longest, "m",
         "exit 3, naming the element; from a motion of distance − r/2 on, for its depth"},
        1.0 - 2e-4, 1.0 + 2e-4);
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
  Path run(sleeve());
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
    coupling::ContactParameters parameters{coupling::Sphere{kRadius}, kStiffness};
  };
  const std::vector<std::pair<const char*, std::function<void(Input&)>>> faults = {
      {"impactor.radius", [](Input& i) { i.parameters.impactor = coupling::Sphere{0.0}; }},
      {"contact.stiffness", [](Input& i) { i.parameters.stiffness = std::nan(""); }},
      {"contact.effective_mass", [](Input& i) { i.mass = -1.0; }},
      {"contact.masses", [](Input& i) { i.skin.masses.pop_back(); }},
      {"contact.masses[3]", [](Input& i) { i.skin.masses[3] = 0.0; }},
      {"contact.triangles[1]", [](Input& i) { i.skin.triangles(2, 1) = 9; }},
      {"contact.triangles[1]", [](Input& i) { i.skin.triangles(2, 1) = -1; }},
      {"contact: skin element 0 area", [](Input& i) { i.skin.nodes.col(4) = i.skin.nodes.col(0); }},
      {"contact: skin element 0", [](Input& i) { i.parameters.impactor = coupling::Sphere{1e-4}; }}};
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
  EXPECT_EQ(refusal([&] { run.go({0.0, 0.0, 1.0}); }), "contact.nodes = 16 columns: must be one a node, 9");
  run.skin = scenes::plate(2, kRadius);
  run.forces.resize(3, 7);
  EXPECT_EQ(refusal([&] { run.go({0.0, 0.0, 1.0}); }), "contact.forces = 7 columns: must be one a node, 9");
}

TEST(ContactGuard, state_of_another_model_is_refused) {
  const scenes::Skin skin = scenes::plate(4, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  const coupling::ContactModel copy = model;
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  const auto answers = [&](coupling::ContactState state) {
    return std::pair(refusal([&] {
                       model.evaluate(state, skin.nodes, {{0.0, 0.0, 0.9 * kRadius}}, forces);
                     }),
                     refusal([&] { model.stays_clear(state, 0.0); }));
  };
  const std::pair<std::string, std::string> fine{"accepted", "accepted"};
  EXPECT_EQ(answers(model.make_state()), fine);
  EXPECT_EQ(answers(copy.make_state()), fine);
  // Of no model, of a smaller one, and of one that differs by the sphere alone.
  for (const auto& state : {coupling::ContactState(), Path(scenes::plate(1, kRadius)).state,
                            scenes::contact(skin, 1.1 * kRadius, kStiffness).make_state()}) {
    const auto [evaluated, told] = answers(state);
    EXPECT_TRUE(names(evaluated, "contact.state") && names(evaluated, "make_state")) << evaluated;
    EXPECT_TRUE(names(told, "contact.state")) << told;
  }
}

}  // namespace
