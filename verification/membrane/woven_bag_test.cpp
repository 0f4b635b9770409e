// SPDX-License-Identifier: Apache-2.0
// Bags of woven fabric: warp along a line in space, seen from each element's plane.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "dense.hpp"
#include "energy_derivative.hpp"

using membrane::Compression;

namespace {

const Eigen::Vector3d kWarp(0.3, 1.0, 0.1);  // along no side and no normal of the meshes below

membrane::BagDescription woven(const mesh::Mesh& mesh, Compression compression,
                               const membrane::WeaveProperties& weave = {20e6, 3e6, kWarp}) {
  auto d = scenes::describe(mesh, compression);
  for (auto& p : d.properties) p.weave = weave;
  return d;
}

}  // namespace

TEST(WovenBag, force_eq_minus_energy_derivative) {
  const auto mesh = mesh::icosphere(0.3, 1);
  for (const auto compression : {Compression::linear, Compression::none})
    for (const double swelling : {1.0, 1.2})
      scenes::expect_force_eq_minus_energy_derivative(make_model(woven(mesh, compression)),
                                                      scenes::shaken(swelling * mesh.nodes, 0.03, 8));
}

TEST(WovenBag, every_instruction_set_gives_the_same_bits) {
  const auto mesh =
      mesh::icosphere(0.3, 1);  // 80 elements: taut, wrinkled and slack ones share groups of lanes
  const Eigen::Matrix3Xd x = scenes::shaken(1.02 * mesh.nodes, 0.03, 4);
  for (const auto compression : {Compression::linear, Compression::none}) {
    auto d = woven(mesh, compression);
    scenes::expect_same_bits(d, x);
  }
}

// The oracle of one element, by the law itself: energies of the elements sum to the bag's.
TEST(WovenBag, element_response_sums_to_the_strain_energy) {
  const auto mesh = mesh::icosphere(0.3, 1);
  for (const auto compression : {Compression::linear, Compression::none}) {
    const auto model = make_model(woven(mesh, compression));
    const auto state = scenes::evaluated(model, scenes::shaken(1.02 * mesh.nodes, 0.03, 4));
    double sum = 0.0;
    for (int e = 0; e < model.element_count; ++e)
      sum += element_response(model, state, e).response.energy_density * 0.5e-3 *
             model.reference_area[static_cast<std::size_t>(e)];
    EXPECT_NEAR(sum, state.forces.strain_energy, 200 * scenes::kEps * sum);  // 80 terms, some operations each
  }
}

// A weave of isotropic constants, whatever its warp, is the isotropic fabric.
TEST(WovenBag, isotropic_constants_give_the_isotropic_bag) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const Eigen::Matrix3Xd x = scenes::shaken(1.02 * mesh.nodes, 0.03, 4);
  for (const auto compression : {Compression::linear, Compression::none}) {
    const auto plain = scenes::evaluated(make_model(scenes::describe(mesh, compression)), x);
    const auto weave = scenes::evaluated(make_model(woven(mesh, compression, {60e6, 60e6 / 2.6, kWarp})), x);
    const double largest = plain.membrane_force.map().cwiseAbs().maxCoeff();
    // 6 elements a node, some 60 operations each; stress differences of E x eps against forces of E x 0.1.
    EXPECT_LE((plain.membrane_force.map() - weave.membrane_force.map()).cwiseAbs().maxCoeff(),
              2000 * scenes::kEps * largest);
    EXPECT_NEAR(weave.forces.strain_energy, plain.forces.strain_energy,
                2000 * scenes::kEps * plain.forces.strain_energy);
    // A 3 x 3 eigenvalue by two routes.
    EXPECT_NEAR(weave.forces.element_frequency, plain.forces.element_frequency,
                1000 * scenes::kEps * plain.forces.element_frequency);
  }
}

// Design shape, warp and positions turned together, and positions turned alone: the forces turn with the
// positions.
TEST(WovenBag, forces_turn_with_the_frame) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const Eigen::Matrix3Xd x = scenes::shaken(1.02 * mesh.nodes, 0.03, 4);
  const Eigen::Matrix3d turn = scenes::rotation();
  const auto d = woven(mesh, Compression::none);
  const Eigen::Matrix3Xd force = turn * scenes::membrane_force(make_model(d), x);
  auto turned = woven(mesh, Compression::none, {20e6, 3e6, 7.0 * turn * kWarp});  // any length
  turned.reference = turn * mesh.nodes;
  // Rounding of the turned coordinates, eps x radius / side = 2 eps in the strain, times E thickness side
  // over the force.
  const double allowed = 1e-12 * force.cwiseAbs().maxCoeff();
  EXPECT_LE((scenes::membrane_force(make_model(turned), turn * x) - force).cwiseAbs().maxCoeff(), allowed);
  EXPECT_LE((scenes::membrane_force(make_model(d), turn * x) - force).cwiseAbs().maxCoeff(), allowed);
}

// No state of strain or compression law exceeds the bound of omega^2.
TEST(WovenBag, dense_eigenvalue_below_bound) {
  scenes::Random random(21);
  for (const auto compression : {Compression::linear, Compression::none})
    for (int trial = 0; trial < 60; ++trial) {
      auto mesh = mesh::rectangle(1, 1, 0.01, 0.01 * (1.2 + random()), mesh::Diagonals::uniform);
      const double shear = 1e6 * std::pow(10.0, 1.5 * random());
      const auto model = make_model(woven(mesh, compression, {20e6, shear, {1.0, random(), 0.0}}));
      Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
      for (int i = 0; i < 9; ++i) f(i % 3, i / 3) += 0.4 * random();
      const Eigen::Matrix3Xd x = f * mesh.nodes;
      const auto force = [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); };
      const double exact = scenes::greatest_frequency(model, x, force, 1e-9);
      // Differences: rounding eps x sides / h = 1e-7 and curvature h / side = 1e-6 of the largest stiffness.
      EXPECT_LE(exact, scenes::evaluated(model, x).forces.element_frequency * (1.0 + 1e-5));
    }
}

// Sharp where it can be: one free element at rest, stiff warp along a side.
TEST(WovenBag, dense_eigenvalue_of_a_free_element_eq_bound) {
  auto mesh = mesh::rectangle(1, 1, 0.01, 0.01, mesh::Diagonals::uniform);
  mesh.elements = mesh.elements.leftCols(1).eval();
  mesh.nodes = mesh.nodes(Eigen::all, std::array{0, 1, 3}).eval();
  mesh.elements << 0, 1, 2;
  mesh.panel.resize(1);
  for (const Eigen::Vector3d& warp : {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(1.0, 0.7, 5.0)}) {
    const auto model = make_model(woven(mesh, Compression::linear, {20e6, 3e6, warp}));
    const auto force = [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); };
    const double exact = scenes::greatest_frequency(model, mesh.nodes, force, 1e-9);
    EXPECT_NEAR(exact / model.shares.frequency[0].material[0], 1.0, 1e-5);  // differences as above
  }
}

TEST(WovenBag, null_elements_have_no_stress) {
  const auto mesh = mesh::icosphere(0.3, 1);
  auto d = woven(mesh, Compression::none);
  d.properties[5] = {};
  d.properties[5].null_panel = true;
  const auto model = make_model(d);
  const auto state = scenes::evaluated(model, scenes::shaken(1.1 * mesh.nodes, 0.02, 8));
  const auto r = element_response(model, state, 5).response;
  EXPECT_EQ(r.s11, 0.0);
  EXPECT_EQ(r.energy_density, 0.0);
  EXPECT_TRUE(state.membrane_force.map().allFinite());
}

TEST(WovenBag, bad_weaves_are_refused_by_name) {
  const double nan = std::nan("");
  struct Bad {
    membrane::WeaveProperties weave;
    double poisson;
    const char* says;
  };
  const Bad bad[] = {{{nan, 3e6, kWarp}, 0.3, "young_modulus_weft"},
                     {{20e6, -3e6, kWarp}, 0.3, "shear"},
                     {{20e6, 1e3, kWarp}, 0.3, "shear / sqrt(young_modulus young_modulus_weft)"},
                     {{20e6, 3e6, {0.0, 0.0, 0.0}}, 0.3, "length of the warp"},
                     {{20e6, 3e6, {nan, 1.0, 0.0}}, 0.3, "warp"},
                     {{20e6, 3e6, {0.0, 0.0, 1.0}}, 0.3, "element's plane"},
                     {{20e6, 3e6, kWarp}, 1.74, "poisson"},
                     {{180e6, 3e6, kWarp}, 0.58, "poisson"},
                     {{20e6, 3e6, kWarp}, nan, "poisson"}};
  const auto mesh = mesh::rectangle(1, 1, 1.0, 1.0, mesh::Diagonals::uniform);
  for (const auto& b : bad) {
    auto d = woven(mesh, Compression::none);
    d.properties[1].weave = b.weave;
    d.properties[1].poisson = b.poisson;
    try {
      make_model(d);
      ADD_FAILURE() << "accepted: " << b.says;
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("element 1"), std::string::npos) << message;
      EXPECT_NE(message.find(b.says), std::string::npos) << message;
    }
  }
}

// Just inside the limit of poisson^2 weft / warp, with the weft a third and three times as stiff as the warp.
TEST(WovenBag, weaves_of_positive_stiffness_are_accepted) {
  const auto mesh = mesh::rectangle(1, 1, 1.0, 1.0, mesh::Diagonals::uniform);
  for (const auto& [weft, poisson] : {std::pair{20e6, 1.72}, {180e6, 0.57}}) {
    auto d = woven(mesh, Compression::none, {weft, 3e6, kWarp});
    for (auto& p : d.properties) p.poisson = poisson;
    EXPECT_NO_THROW(make_model(d)) << poisson;
  }
}
