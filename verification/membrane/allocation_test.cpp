// SPDX-License-Identifier: Apache-2.0
// No stage allocates after make_state.
#include <gtest/gtest.h>

#include "scenes.hpp"
#include "support/allocation_counter.hpp"

TEST(Allocation, stages_allocate_nothing) {
  const auto mesh = mesh::icosphere(0.3, 3);
  auto d = scenes::describe(mesh, membrane::Compression::none);
  d.straps = {{0, 10, 4500.0, 0.01}};
  d.plates = {{{0.0, 0.0, -0.1}, {0.0, 0.0, 1.0}, 1e6}};
  const auto model = make_model(d);
  auto state = membrane::make_state(model, mesh.nodes, {.jet = true, .contact = true});
  const std::vector<double> dp(static_cast<std::size_t>(model.element_count), 700.0);
  const long before = support::allocations();
  EXPECT_GT(before, 0);  // the counter works
  for (int i = 0; i < 3; ++i) {
    membrane::update_skin(model, state);
    membrane::update_geometry(model, state);
    membrane::update_mass_shares(model, state);
    membrane::pressure_forces(state, 1000.0);
    membrane::jet_forces(model, state, dp);
    membrane::support_forces(model, state);
    const auto shares = membrane::stiffness_shares(model, state, 1.4, 1.1e5);
    membrane::advance(model, state, 1e-6, 0.5 * membrane::critical_time_step(shares));
    membrane::governing_element(model, state);
  }
  const long during = support::allocations() - before;
  EXPECT_EQ(during, 0);
}
