// SPDX-License-Identifier: Apache-2.0
// Forces against the derivative of the energy (M.4), over taut, wrinkled and slack elements.
#include "energy_derivative.hpp"

using membrane::Compression;

namespace {

struct Count {
  int taut = 0, wrinkled = 0, slack = 0;
};

Count count_states(const membrane::BagModel& model, const membrane::BagState& state) {
  Count count;
  for (int e = 0; e < model.element_count; ++e) {
    const auto r = element_response(model, state, e).response;
    const double smaller = r.s11 + r.s22 - r.stress_1;
    if (r.stress_1 == 0.0)
      ++count.slack;
    else if (smaller > 1e-6 * r.stress_1)
      ++count.taut;
    else
      ++count.wrinkled;
  }
  return count;
}

}  // namespace

TEST(EnergyGradient, force_eq_minus_energy_derivative) {
  const auto mesh = mesh::icosphere(0.3, 1);
  for (const auto compression : {Compression::linear, Compression::none})
    for (const double swelling : {1.0, 1.05, 1.2}) {
      const auto model = make_model(scenes::describe(mesh, compression));
      scenes::expect_force_eq_minus_energy_derivative(model, scenes::shaken(swelling * mesh.nodes, 0.03, 8));
    }
}

// The test above must have met every state of the relaxed law.
TEST(EnergyGradient, scenes_hold_taut_wrinkled_and_slack_elements) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  Count all;
  for (const double swelling : {1.0, 1.05, 1.2}) {
    const auto count =
        count_states(model, scenes::evaluated(model, scenes::shaken(swelling * mesh.nodes, 0.03, 8)));
    all.taut += count.taut;
    all.wrinkled += count.wrinkled;
    all.slack += count.slack;
  }
  EXPECT_GT(all.taut, 20);
  EXPECT_GT(all.wrinkled, 20);
  EXPECT_GT(all.slack, 0);
}

TEST(EnergyGradient, largest_strains_are_those_of_the_responses) {
  const auto mesh = mesh::icosphere(0.3, 1);
  auto description = scenes::describe(mesh, Compression::none);
  description.properties[5] = {};
  description.properties[5].null_panel = true;
  const auto model = make_model(description);
  const auto state = scenes::evaluated(model, scenes::shaken(1.1 * mesh.nodes, 0.03, 8));
  std::vector<double> strains(static_cast<std::size_t>(model.element_count), -1.0);
  largest_strains(model, state, strains);
  for (int e = 0; e < model.element_count; ++e)
    EXPECT_NEAR(strains[static_cast<std::size_t>(e)], element_response(model, state, e).response.strain_1,
                1e-15);
  EXPECT_GT(*std::ranges::max_element(strains), 0.1);
  strains.pop_back();
  EXPECT_THROW(largest_strains(model, state, strains), std::invalid_argument);
}

TEST(EnergyGradient, null_elements_bear_pressure_only) {
  const auto mesh = mesh::icosphere(0.3, 1);
  auto description = scenes::describe(mesh, Compression::linear);
  description.properties[5] = {};
  description.properties[5].null_panel = true;
  const auto model = make_model(description);
  const auto whole = make_model(scenes::describe(mesh, Compression::linear));
  const Eigen::Matrix3Xd x = scenes::shaken(1.1 * mesh.nodes, 0.02, 8);
  const auto state = scenes::evaluated(model, x), reference = scenes::evaluated(whole, x);
  EXPECT_EQ(element_response(model, state, 5).response.stress_1, 0.0);
  EXPECT_EQ(state.surface.volume, reference.surface.volume);
  EXPECT_EQ((state.volume_gradient.map() - reference.volume_gradient.map()).norm(), 0.0);
  const double missing = reference.forces.strain_energy - state.forces.strain_energy;
  const double of_element =
      element_response(whole, reference, 5).response.energy_density * whole.reference_area[5] * 0.5e-3;
  EXPECT_NEAR(missing, of_element, 200 * scenes::kEps * reference.forces.strain_energy);
}
