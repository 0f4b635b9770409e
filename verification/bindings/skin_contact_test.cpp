// SPDX-License-Identifier: Apache-2.0
// Contact of a skin with itself through gasjet.h: bits of the C++ library, layers that meet, wrong calls.
#include "coupling/skin_contact.hpp"

#include <algorithm>

#include "bad_calls.hpp"

using namespace border_test;
using bad_calls = BadCalls;

namespace {

constexpr double kThickness = 0.05, kStiffness = 1e6, kFriction = 0.3;

/// A box that is pressed flat, then sheared: positions at successive times.
std::vector<std::vector<double>> pressed_flat(const Mesh& mesh) {
  std::vector<std::vector<double>> levels(3, mesh.nodes);
  for (std::size_t i = 0; i < mesh.nodes.size(); i += 3) {
    levels[1][i + 2] *= 0.045;
    levels[2][i + 2] *= 0.04;
    levels[2][i] += 0.01 * mesh.nodes[i + 2];
  }
  return levels;
}

struct Folding {
  explicit Folding(const Mesh& given)
      : mesh(given),
        mass(static_cast<std::size_t>(mesh.node_count()), 1e-2),
        force(mesh.nodes.size(), 0.0),
        size(static_cast<int64_t>(force.size())) {
    EXPECT_OK(gasjet_skin_contact_create(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                         mesh.triangle_count(), nullptr, mass.data(), kThickness, kStiffness,
                                         kFriction, &handle.value));
  }
  int at(const std::vector<double>& nodes) {
    std::ranges::fill(force, 0.0);
    return gasjet_skin_contact_evaluate(handle.value, nodes.data(), mesh.node_count(), nullptr, force.data(),
                                        size, &sums);
  }
  Mesh mesh;
  std::vector<double> mass, force;
  int64_t size;
  gasjet_skin_contact_sums sums{};
  Handle handle;
};

TEST(c_skin_contact, gives_the_bits_of_the_library_in_every_layout) {
  const Mesh mesh = box(4, 1.0);
  const auto levels = pressed_flat(mesh);
  const auto columns = [](const std::vector<double>& rows) {
    return Eigen::Map<const Eigen::Matrix3Xd>(rows.data(), 3, static_cast<Eigen::Index>(rows.size() / 3));
  };
  const Eigen::Map<const Eigen::Matrix3Xi> triangles(mesh.triangles.data(), 3, mesh.triangle_count());
  for (std::size_t k = 0; k < layouts_of(mesh.nodes).size(); ++k) {
    Folding folding(mesh);
    const coupling::SkinContactModel model(triangles, columns(mesh.nodes), folding.mass,
                                           {kThickness, kStiffness, kFriction});
    auto state = model.make_state();
    for (const auto& nodes : levels) {
      Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
      const auto result = model.evaluate(state, columns(nodes), force);
      const Layout layout = layouts_of(nodes)[k];
      std::ranges::fill(folding.force, 0.0);
      ASSERT_OK(gasjet_skin_contact_evaluate(folding.handle.value, layout.data.data() + layout.first,
                                             mesh.node_count(), layout.stride, folding.force.data(),
                                             folding.size, &folding.sums));
      const gasjet_skin_contact_sums& sums = folding.sums;
      EXPECT_EQ(sums.energy, result.energy);
      EXPECT_EQ(sums.friction_loss, result.friction_loss);
      EXPECT_EQ(sums.frequency, result.omega_squared);
      EXPECT_EQ(sums.gap, result.closest.gap);
      EXPECT_EQ(sums.approach, result.approach);
      EXPECT_EQ(sums.contacts, result.contacts);
      EXPECT_EQ(sums.limited_nodes, state.limited_nodes());
      EXPECT_TRUE(std::ranges::equal(sums.first_nodes, result.closest.first));
      EXPECT_TRUE(std::ranges::equal(sums.second_nodes, result.closest.second));
      EXPECT_TRUE(std::ranges::equal(folding.force, force.reshaped()));
    }
    EXPECT_GT(folding.sums.contacts, 100);
    EXPECT_GT(folding.sums.friction_loss, 0.0);
    EXPECT_LT(folding.sums.gap, kThickness);
  }
}

TEST(c_skin_contact, forces_are_added) {
  Folding folding(box(4, 1.0));
  const auto levels = pressed_flat(folding.mesh);
  ASSERT_OK(folding.at(levels[0]));
  EXPECT_EQ(folding.sums.gap, kInfinity);
  EXPECT_EQ(folding.sums.first_nodes[0], -1);
  ASSERT_OK(folding.at(levels[1]));
  auto twice = folding.force;
  ASSERT_OK(folding.at(levels[1]));
  const auto once = folding.force;
  ASSERT_OK(gasjet_skin_contact_evaluate(folding.handle.value, levels[1].data(), folding.mesh.node_count(),
                                         nullptr, twice.data(), folding.size, &folding.sums));
  const double largest = *std::ranges::max_element(once);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], 2.0 * once[i], 1e-12 * largest);
}

TEST(c_skin_contact, layers_that_meet_are_refused_until_a_restart) {
  Folding folding(box(4, 1.0));
  const auto levels = pressed_flat(folding.mesh);
  auto inside_out = levels[0];
  for (std::size_t i = 2; i < inside_out.size(); i += 3) inside_out[i] *= -0.5;
  ASSERT_OK(folding.at(levels[0]));
  EXPECT_EQ(folding.at(inside_out), GASJET_DOMAIN);
  EXPECT_NE(std::string(gasjet_last_error()).find("node"), std::string::npos) << gasjet_last_error();
  EXPECT_EQ(folding.at(levels[0]), GASJET_BAD_INPUT);
  EXPECT_STREQ(gasjet_last_error(), "skin_contact: failed at the last call, allowed: a restart");
  ASSERT_OK(gasjet_skin_contact_restart(folding.handle.value));
  // The first level of a run: layers start without force.
  ASSERT_OK(folding.at(levels[1]));
  EXPECT_EQ(folding.sums.energy, 0.0);
  EXPECT_GT(folding.sums.limited_nodes, 0);
  ASSERT_OK(gasjet_skin_contact_restart(folding.handle.value));
  ASSERT_OK(folding.at(levels[0]));
  ASSERT_OK(folding.at(levels[1]));
  EXPECT_GT(folding.sums.energy, 0.0);
  EXPECT_EQ(folding.sums.limited_nodes, 0);
}

TEST(c_skin_contact, default_stiffness_adds_its_share) {
  double stiffness = 0.0;
  ASSERT_OK(gasjet_default_skin_stiffness(0.5, 4e8, 0.2, &stiffness));
  EXPECT_EQ(stiffness, coupling::default_skin_stiffness(0.5, 4e8, 0.2));
}

TEST_F(bad_calls, skin_contact) {
  gasjet_handle out = 0;
  const auto create = [&](const double* reference, int64_t count, const int32_t* triangles,
                          const double* masses, double thickness, double stiffness, double friction) {
    return gasjet_skin_contact_create(reference, count, nullptr, triangles, m(), nullptr, masses, thickness,
                                      stiffness, friction, &out);
  };
  refused(create(nullptr, n(), t(), mass.data(), 0.1, 1e5, 0.0), "reference");
  refused(create(x(), 0, t(), mass.data(), 0.1, 1e5, 0.0), "node_count");
  refused(create(x(), n() - 1, t(), mass.data(), 0.1, 1e5, 0.0), "triangles");
  refused(create(x(), n(), nullptr, mass.data(), 0.1, 1e5, 0.0), "triangles");
  refused(create(x(), n(), t(), nullptr, 0.1, 1e5, 0.0), "mass");
  each(kNotPositive, "thickness", [&](double h) { return create(x(), n(), t(), mass.data(), h, 1e5, 0.0); });
  refused(create(x(), n(), t(), mass.data(), 0.4, 1e5, 0.0), "self_contact.thickness = 0.4 m");
  each(kNotPositive, "stiffness",
       [&](double kappa) { return create(x(), n(), t(), mass.data(), 0.1, kappa, 0.0); });
  each(kNotCounted, "friction", [&](double mu) { return create(x(), n(), t(), mass.data(), 0.1, 1e5, mu); });
  for (const double bad : kNotPositive) {
    auto changed = mass;
    changed[3] = bad;
    refused(create(x(), n(), t(), changed.data(), 0.1, 1e5, 0.0), "self_contact.masses[3]");
  }
  refused(
      gasjet_skin_contact_create(x(), n(), nullptr, t(), m(), nullptr, mass.data(), 0.1, 1e5, 0.0, nullptr),
      "skin_contact");
  EXPECT_EQ(out, 0);
  for (const double bad : kNotPositive) {
    double stiffness = 7.0;
    refused(gasjet_default_skin_stiffness(bad, 1e8, 0.3, &stiffness), "share");
    refused(gasjet_default_skin_stiffness(0.5, bad, 0.3, &stiffness), "other_frequency");
    refused(gasjet_default_skin_stiffness(0.5, 1e8, bad, &stiffness), "surface_density");
    EXPECT_EQ(stiffness, 7.0);
  }
  refused(gasjet_default_skin_stiffness(0.5, 1e8, 0.3, nullptr), "stiffness");
}

TEST_F(bad_calls, skin_contact_evaluate) {
  Handle skin;
  ASSERT_OK(gasjet_skin_contact_create(x(), n(), nullptr, t(), m(), nullptr, mass.data(), 0.1, 1e5, 0.0,
                                       &skin.value));
  gasjet_skin_contact_sums sums;
  double* f = values.data();
  const auto evaluate = [&](const double* nodes, int64_t count, const int64_t* stride, double* force,
                            int64_t forces, gasjet_skin_contact_sums* s) {
    return gasjet_skin_contact_evaluate(skin.value, nodes, count, stride, force, forces, s);
  };
  refused(evaluate(nullptr, n(), nullptr, f, 3 * n(), &sums), "nodes");
  each(std::vector<int64_t>{0, -1, n() - 1, n() + 1, INT64_MAX}, "nodes",
       [&](int64_t c) { return evaluate(x(), c, nullptr, f, 3 * n(), &sums); });
  for (const int64_t bad : {int64_t{0}, INT64_MAX, INT64_MIN}) {
    const int64_t stride[] = {3, bad};
    refused(evaluate(x(), n(), stride, f, 3 * n(), &sums), "nodes");
  }
  refused(evaluate(x(), n(), nullptr, nullptr, 3 * n(), &sums), "force");
  each(std::vector<int64_t>{0, -1, n(), 3 * n() + 1}, "force",
       [&](int64_t c) { return evaluate(x(), n(), nullptr, f, c, &sums); });
  refused(evaluate(x(), n(), nullptr, f, 3 * n(), nullptr), "sums");
  for (const double bad : kNotFinite) {
    auto nodes = mesh.nodes;
    nodes[4] = bad;
    refused(evaluate(nodes.data(), n(), nullptr, f, 3 * n(), &sums), "nodes");
  }
  each_bad_handle("skin_contact", contact.value, [&](gasjet_handle h) {
    return gasjet_skin_contact_evaluate(h, x(), n(), nullptr, f, 3 * n(), &sums);
  });
  each_bad_handle("skin_contact", contact.value, gasjet_skin_contact_restart);
  for (const double v : values) EXPECT_EQ(v, 7.0);
  EXPECT_OK(evaluate(x(), n(), nullptr, f, 3 * n(), &sums));  // refusals are not calls
}

}  // namespace
