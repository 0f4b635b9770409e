// SPDX-License-Identifier: Apache-2.0
// What every fabric law must have, whatever it says: of each in the list of fabric_laws.hpp.
#include <gtest/gtest.h>

#include "dense.hpp"
#include "energy_derivative.hpp"
#include "membrane/law_table.hpp"

using membrane::Compression;
using membrane::LawTraits;

namespace {

// Fabric in the middle of what the law allows.
membrane::BagDescription describe_law(const mesh::Mesh& mesh, const LawTraits& law, Compression compression) {
  auto d = scenes::describe(mesh, compression);
  d.law = law.name;
  if (law.curves) d.curves = {{{{0.0, 0.1, 1.5}, {0.0, 2e6, 9e7}}, {{0.0, 0.2, 1.5}, {0.0, 9e6, 4e7}}}};
  for (auto& p : d.properties) {
    if (law.woven) p.weave = membrane::WeaveProperties{45e6, 5e6, {0.3, 0.5, 0.8}};
    for (int i = 0; i < law.own_count; ++i)
      p.law_constants.push_back(0.5 * (law.own[i].least + law.own[i].most));
  }
  return d;
}

// Calls f(law, compression) for all there are.
template <class F>
void each_law(F&& f) {
  for (const LawTraits& law : membrane::fabric_laws())
    for (const auto compression : {Compression::none, Compression::linear}) {
      if (compression == Compression::linear && !law.compression) continue;
      SCOPED_TRACE(std::string(law.name) + (law.woven ? ", woven" : ", isotropic"));
      f(law, compression);
    }
}

}  // namespace

TEST(FabricLaws, force_eq_minus_energy_derivative) {
  const auto mesh = mesh::icosphere(0.3, 1);
  each_law([&](const LawTraits& law, Compression compression) {
    for (const double swelling : {1.0, 1.05, 1.2})
      scenes::expect_force_eq_minus_energy_derivative(make_model(describe_law(mesh, law, compression)),
                                                      scenes::shaken(swelling * mesh.nodes, 0.03, 8));
  });
}

TEST(FabricLaws, all_instruction_sets_give_the_same_bits) {
  const auto mesh = mesh::icosphere(0.3, 2);
  each_law([&](const LawTraits& law, Compression compression) {
    auto d = describe_law(mesh, law, compression);
    d.properties[7] = {.null_panel = true};
    scenes::expect_same_bits(d, scenes::shaken(1.1 * mesh.nodes, 0.01, 3));
  });
}

// The kernels' energy is the sum over the elements' responses.
TEST(FabricLaws, energy_eq_sum_of_responses) {
  const auto mesh = mesh::icosphere(0.3, 2);
  each_law([&](const LawTraits& law, Compression compression) {
    const auto model = make_model(describe_law(mesh, law, compression));
    const auto state = scenes::evaluated(model, scenes::shaken(1.1 * mesh.nodes, 0.01, 3));
    double energy = 0.0;
    for (int e = 0; e < model.element_count; ++e)
      energy += 0.5e-3 * model.reference_area[static_cast<std::size_t>(e)] *
                element_response(model, state, e).response.energy_density;
    EXPECT_GT(energy, 100.0);
    EXPECT_NEAR(state.forces.strain_energy, energy, 320 * scenes::kEps * energy);  // one for each element
  });
}

TEST(FabricLaws, dense_eigenvalue_below_bound) {
  const auto mesh = mesh::rectangle(1, 1, 0.1, 0.1, mesh::Diagonals::uniform);
  scenes::Random random(21);
  each_law([&](const LawTraits& law, Compression compression) {
    const auto model = make_model(describe_law(mesh, law, compression));
    for (int trial = 0; trial < 100; ++trial) {
      Eigen::Matrix3d f = (1.1 + 0.12 * random()) * Eigen::Matrix3d::Identity();
      for (int i = 0; i < 9; ++i) f(i % 3, i / 3) += 0.12 * random();
      const Eigen::Matrix3Xd x = scenes::rotation() * f * mesh.nodes;
      const double exact = scenes::greatest_frequency(
          model, x, [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); }, 1e-9);
      // Rounding eps x sides / h = 1e-7 and curvature h / side = 1e-6 of the largest stiffness.
      EXPECT_LE(exact, scenes::evaluated(model, x).forces.element_frequency * (1.0 + 1e-5)) << trial;
    }
  });
}

TEST(FabricLaws, own_constants_out_of_range_are_refused) {
  const auto mesh = mesh::icosphere(0.3, 1);
  each_law([&](const LawTraits& law, Compression compression) {
    auto d = describe_law(mesh, law, compression);
    d.properties[3].law_constants.push_back(1.0);
    EXPECT_THROW(make_model(d), std::invalid_argument);
    for (int i = 0; i < law.own_count; ++i)
      for (const double wrong : {law.own[i].least - 1.0, law.own[i].most + 1.0, std::nan("")}) {
        d = describe_law(mesh, law, compression);
        d.properties[3].law_constants[static_cast<std::size_t>(i)] = wrong;
        EXPECT_THROW(make_model(d), std::invalid_argument) << law.own[i].name << " = " << wrong;
      }
  });
}
