// SPDX-License-Identifier: Apache-2.0
// Rollers and planes of symmetry of a case, against the whole that the part stands for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/weave.hpp"
#include "half_cylinder.hpp"
#include "mesh/icosphere.hpp"
#include "run_case.hpp"

namespace {

using coupled::half_cylinder, coupled::kHalfLength, coupled::kHalfRadius;
using std::numbers::pi;

constexpr double kOutside = 101325.0;  // [Pa]

// At the pressure at rest, the volume over that of half a cylinder of fixed length, less 1.
double volume_error(const coupled::CaseRun& run) {
  const auto& row = run.history.back();
  const auto exact = closed_form::fixed_length_cylinder({closed_form::paper_fabric(), kHalfRadius},
                                                        row.at("pressure_Pa") - kOutside);
  const double radius = kHalfRadius * exact.hoop_stretch;
  return row.at("volume_m3") / (0.5 * pi * radius * radius * kHalfLength) - 1.0;
}

// The polygon of 2 n sides lacks (2 pi / 2 n)^2 / 6 of the area, and is smaller by the apothem of (M.2).
// The meshes and the case in a folder of their own.
coupled::CaseRun run_half(const std::string& name, int n, std::optional<driver::Scene>& scene) {
  const coupled::Folder folder;
  std::ofstream(folder.path / "half_cylinder.obj") << half_cylinder(n, n / 2);
  for (const char* ending : {".toml", ".csv"}) {
    const auto file = coupled::fs::path(coupled::case_file(name)).replace_extension(ending);
    if (coupled::fs::exists(file)) coupled::fs::copy_file(file, folder.path / (name + ending));
  }
  driver::CaseDocument document(folder.path / (name + ".toml"), {});
  scene.emplace(driver::load_scene(document));
  return coupled::run_of(*scene);
}

TEST(roller, half_a_cylinder_of_fixed_length_converges_with_order_2) {
  std::vector<double> errors;
  for (const int n : {6, 12, 24}) {
    std::optional<driver::Scene> scene;
    const auto run = run_half("half_cylinder", n, scene);
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    errors.push_back(volume_error(run));
    const auto x = run.state.bag->position.map();
    for (int node = 0; node < x.cols(); ++node) {
      const Eigen::Vector3d sewn = scene->bag->mesh.nodes.col(node);
      EXPECT_TRUE(sewn.x() != 0.0 || x(0, node) == 0.0) << node;
      const bool at_end = sewn.z() == 0.0 || sewn.z() == kHalfLength;
      EXPECT_TRUE(!at_end || x(2, node) == sewn.z()) << node;
    }
  }
  claim::expect_order({"M.9", "half a cylinder, rollers in its planes of symmetry: volume at rest",
                       "polygon of 2 n sides, whose next term is (pi / n)^2 / 20 of the first"},
                      errors, 1.9, 2.05);
}

TEST(roller, half_a_cylinder_of_measured_fabric_converges_with_order_2) {
  std::vector<double> errors;
  for (const int n : {6, 12, 24}) {
    std::optional<driver::Scene> scene;
    const auto run = run_half("measured_fabric", n, scene);
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const auto& row = run.history.back();
    const auto& weft = scene->bag->model.description.curves[1];
    const double stretch = closed_form::cylinder_by_curve({weft.strain, weft.stress}, 0.5e-3, kHalfRadius,
                                                          row.at("pressure_Pa") - kOutside);
    const double radius = kHalfRadius * stretch;
    errors.push_back(row.at("volume_m3") / (0.5 * pi * radius * radius * kHalfLength) - 1.0);
  }
  claim::expect_order({"M.30", "half a cylinder by measured curves, weft round it: volume at rest",
                       "polygon of 2 n sides, whose next term is (pi / n)^2 / 20 of the first"},
                      errors, 1.9, 2.05);
}

TEST(roller, faults_of_measured_curves_are_named) {
  const auto says = [](const std::string& key, const std::string& value, const char* text) {
    const std::string message =
        coupled::message_of(coupled::case_file("measured_fabric"), {"fabric." + key + "=" + value});
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  says("warp_curve", "{strain=[0,0.1],value=[0,1e6]}", "accepted");
  says("warp_curve", "{strain=[0.01,0.1],value=[0,1e6]}", "warp_curve: begins at (0.01, 0), allowed: (0, 0)");
  says("weft_curve", "{strain=[0,0.1],value=[1,1e6]}", "weft_curve: begins at (0, 1)");
  says("weft_curve", "{strain=[0,0.1,0.2],value=[0,1e6,1e6]}", "weft_curve: has the stress 1000000 Pa after");
  says("weft_curve", "{strain=[0,0.1,0.1],value=[0,1e6,2e6]}", "weft_curve");
  says("weft_curve", "{strain=[0,0.1],value=[0,nan]}", "weft_curve");
  says("weft_curve", "1e6", "weft_curve: is a number");
  says("young_modulus", "6e7", "young_modulus");
  says("compression", "\"linear\"", "carries no compression");
  says("law", "\"hencky\"", "young_modulus");
  says("weave.young_modulus_weft", "6e7", "young_modulus_weft");
}

std::string message_with(const std::string& roller) {
  return coupled::message_of(coupled::case_file("half_cylinder"), {"membrane.roller.0=" + roller});
}

TEST(roller, faults_are_named) {
  const auto says = [](const std::string& roller, const char* text) {
    EXPECT_NE(message_with(roller).find(text), std::string::npos) << message_with(roller);
  };
  EXPECT_EQ(message_with("{panels=[\"wall\"],directions=[\"x\"]}"), "accepted");
  EXPECT_EQ(message_with("{low=[-1,-1,-1],high=[0,1,1],directions=[\"x\"]}"), "accepted");
  says("{panels=[\"wall\"],directions=[\"xy\"]}", "directions: names \"xy\"");
  says("{panels=[\"wall\"],directions=[]}", "directions: is missing or empty");
  says("{panels=[],directions=[\"x\"]}", "panels: is empty");
  says("{panels=[\"roof\"],directions=[\"x\"]}", "roof");
  says("{directions=[\"x\"]}", "one of the three");
  says("{panels=[\"wall\"],low=[0,0,0],high=[1,1,1],directions=[\"x\"]}", "one of the three");
  says("{nodes=[1],low=[0,0,0],high=[1,1,1],directions=[\"x\"]}", "one of the three");
  says("{nodes=[0],directions=[\"x\"]}", "whole numbers of 1 or more");
  says("{nodes=[1.5],directions=[\"x\"]}", "names node 1.5");
  says("{nodes=[100000],directions=[\"x\"]}",
       "names node 100000, allowed: numbers of the mesh's nodes, 1 to");
  says("{low=[0,0,0],directions=[\"x\"]}", "high");
  says("{low=[1,1,1],high=[0,0,0],directions=[\"x\"]}", "box without a node");
}

// Numbers count the nodes of the file, also if elements without area leave some of them out.
TEST(roller, nodes_by_number_are_those_of_the_file) {
  const coupled::Folder folder;
  std::string text = half_cylinder(8, 4);
  // A node above all others, and a triangle that repeats the place of a corner: it goes, and the node with
  // it.
  const std::string first = text.substr(0, text.find('\n') + 1);
  const auto faces = text.find("g skin");
  text.insert(faces, first);
  const int nodes = 9 * 5 + 1;
  text += fmt::format("f 1 {} 2\n", nodes);
  std::ofstream(folder.path / "half_cylinder.obj") << text;
  std::ofstream(folder.path / "half_cylinder.toml") << coupled::read(coupled::case_file("half_cylinder"));
  driver::CaseDocument document(folder.path / "half_cylinder.toml", {"membrane.fixed_nodes=[3, 1, 3]"});
  const driver::Scene scene = driver::load_scene(document);
  const auto& fixed = scene.bag->model.description.fixed_nodes;
  EXPECT_EQ(fixed, (std::vector<int>{0, 2}));
  const auto says = coupled::message_of(folder.path / "half_cylinder.toml",
                                        {fmt::format("membrane.fixed_nodes=[{}]", nodes)});
  EXPECT_NE(says.find("is left out with the elements that have no area"), std::string::npos) << says;
}

// The order that a large bag's nodes get for speed does not change what numbers mean.
TEST(roller, numbers_survive_the_order_of_a_large_bag) {
  const std::vector<std::string> large{"membrane.mesh={generator=\"icosphere\",radius=0.3,levels=6}"};
  auto overrides = large;
  overrides.emplace_back("membrane.fixed_nodes=[1,100,4000]");
  const auto scene = coupled::scene_of("sphere_inflation", overrides);
  const auto design = mesh::icosphere(0.3, 6);
  ASSERT_NE(scene.bag->mesh.nodes, design.nodes);
  for (const int wanted : {0, 99, 3999}) {
    double nearest = 1.0;
    for (const int node : scene.bag->model.description.fixed_nodes)
      nearest = std::min(nearest, (scene.bag->mesh.nodes.col(node) - design.nodes.col(wanted)).norm());
    EXPECT_EQ(nearest, 0.0) << wanted;
  }
  EXPECT_EQ(scene.bag->model.description.fixed_nodes.size(), 3u);
}

}  // namespace
