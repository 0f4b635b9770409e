// SPDX-License-Identifier: Apache-2.0
// The per-step calls of the jet allocate nothing: every allocation of this program is counted.
#include <gtest/gtest.h>

#include "jet/field.hpp"
#include "jet/visibility.hpp"
#include "plates.hpp"
#include "routes.hpp"
#include "support/allocation_counter.hpp"

namespace {

struct Bag {
  scenes::Mesh mesh;
  plates::Target surface;
};

Bag make_bag(const scenes::Mesh& mesh) {
  return {mesh, plates::finish(mesh.points(), mesh.triangles())};
}

jet::JetModel outlet(jet::OutletShape shape) {
  jet::JetModel model;
  model.shape = shape;
  model.centre = Eigen::Vector3d(0.05, 0.02, 0.01);
  model.axis = Eigen::Vector3d(1, 0, 0);
  model.long_direction = Eigen::Vector3d(0, 1, 0);
  model.radius = 0.15;
  model.short_side = 0.2;
  model.long_side = 0.4;
  model.decay_coefficient = 0.1;
  return model;
}

TEST(allocation, a_step_of_the_jet_allocates_nothing) {
  const jet::OutletState state{410.0, 0.97, 1.17e5, 406.0};
  for (const auto shape : {jet::OutletShape::round, jet::OutletShape::rectangular}) {
    for (const Bag& bag : {make_bag(scenes::star(4, 0.2, 1)), make_bag(scenes::crumpled(4, 0.01, 2))}) {
      const int count = bag.surface.count();
      const jet::JetField field(outlet(shape), count);
      jet::FieldState work = field.make_state();
      jet::VisibilityQuery query(bag.surface.triangles, static_cast<int>(bag.mesh.nodes.size()));
      const jet::RaySource source = jet::ray_source(field.model());
      std::vector<std::uint8_t> lit(static_cast<std::size_t>(count));
      const jet::Points areas(bag.surface.area_vectors), centroids(bag.surface.centroids),
          nodes(bag.surface.nodes);
      const long before = support::allocations();
      field.evaluate(areas, centroids, state, work);
      const auto mask = std::span(lit).first(work.candidates.size());
      query.query(jet::VisibilityRoute::fast, nodes, source, work.candidates, mask);
      jet::apply_mask(mask, work);
      const Eigen::Vector3d force = jet::jet_force(work, areas);
      EXPECT_EQ(support::allocations(), before);
      EXPECT_GT(work.candidates.size(), 20u);
      EXPECT_GT(force[0], 0.0);
    }
  }
}

}  // namespace
