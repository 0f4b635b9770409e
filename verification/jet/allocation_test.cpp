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

jet::JetModel outlet(jet::OutletShape shape, const Eigen::Vector3d& axis) {
  jet::JetModel model;
  model.shape = shape;
  model.centre = Eigen::Vector3d(0.05, 0.02, 0.01);
  model.axis = axis;
  model.long_direction = Eigen::Vector3d(0, 0, 1).cross(axis);
  model.radius = 0.15;
  model.short_side = 0.2;
  model.long_side = 0.4;
  model.decay_coefficient = 0.1;
  return model;
}

void expect_no_allocation_in_a_step(const jet::JetModel& model, const Bag& bag) {
  const jet::OutletState state{410.0, 0.97, 1.17e5, 406.0};
  const int count = bag.surface.count();
  const jet::JetField field(model, count);
  jet::FieldState work = field.make_state();
  jet::VisibilityQuery query(bag.surface.triangles, static_cast<int>(bag.mesh.nodes.size()));
  query.prepare();
  const jet::RaySource source = jet::ray_source(field.model());
  std::vector<std::uint8_t> lit(static_cast<std::size_t>(count));
  const jet::Points areas(bag.surface.area_vectors), centroids(bag.surface.centroids),
      nodes(bag.surface.nodes);
  const long before = support::allocations();
  field.evaluate(areas, centroids, state, work);
  const auto mask = std::span(lit).first(work.candidates.size());
  jet::VisibilityCounters counters;
  for (int i = 0; i < 3; ++i)  // with what it kept, too
    counters = query.query(jet::VisibilityRoute::fast, nodes, source, work.candidates, mask);
  jet::apply_mask(mask, work);
  const Eigen::Vector3d force = jet::jet_force(work, areas);
  EXPECT_EQ(support::allocations(), before);
  EXPECT_EQ(counters.tree_builds, 0u);
  EXPECT_GT(work.candidates.size(), 20u);
  EXPECT_GT(force.dot(model.axis), 0.0);
}

TEST(allocation, a_step_of_the_jet_allocates_nothing) {
  const Bag bags[] = {make_bag(scenes::star(4, 0.2, 1)), make_bag(scenes::crumpled(4, 0.01, 2))};
  for (const auto shape : {jet::OutletShape::round, jet::OutletShape::rectangular}) {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 1)}) {
      for (const Bag& bag : bags) expect_no_allocation_in_a_step(outlet(shape, axis), bag);
    }
  }
}

TEST(allocation, rays_that_go_upstream_allocate_at_the_first_query_alone) {
  const scenes::Mesh mesh = scenes::star(4, 0.2, 1);
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  jet::RaySource source;
  std::vector<int> chosen;
  for (int e = 0; e < 2048; e += 32) {
    if ((mesh.centroid(static_cast<std::size_t>(e)) - source.centre).dot(source.axis) > 0.0 || e % 64 == 0)
      chosen.push_back(e);
  }
  std::vector<std::uint8_t> lit(chosen.size());
  const Eigen::Matrix3Xd points = mesh.points();
  const jet::Points nodes(points);
  query.query(jet::VisibilityRoute::fast, nodes, source, chosen, lit);
  const long before = support::allocations();
  const auto counters = query.query(jet::VisibilityRoute::fast, nodes, source, chosen, lit);
  EXPECT_EQ(support::allocations(), before);
  EXPECT_EQ(counters.tree_builds, 0u);
  EXPECT_GT(counters.lit, 40u);
}

}  // namespace
