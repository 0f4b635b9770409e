// SPDX-License-Identifier: Apache-2.0
#include "jet_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "membrane/stages.hpp"

namespace benchmarks {

JetSurface::JetSurface(const driver::Scene& scene, int n)
    : pieces_(scene.bag->mesh.elements, scene.bag->model.node_count, n),
      roles_{pieces_.pieces_of(scene.jets.front().roles.null_elements),
             pieces_.pieces_of(scene.jets.front().roles.attachment_elements)},
      coarse_(scene.bag->mesh.elements),
      nodes_(3, pieces_.node_count()),
      area_vectors_(3, pieces_.triangles().cols()),
      centroids_(3, pieces_.triangles().cols()) {}

void JetSurface::place(const JetState& state, double delay) {
  const Eigen::Matrix3Xd position = state.position + delay * state.velocity;
  Eigen::Matrix3Xd areas(3, coarse_.cols());
  for (Eigen::Index e = 0; e < coarse_.cols(); ++e) {
    const Eigen::Vector3d a = position.col(coarse_(0, e)), b = position.col(coarse_(1, e)),
                          c = position.col(coarse_(2, e));
    areas.col(e) = 0.5 * (b - a).cross(c - a);
  }
  pieces_.interpolate(position, nodes_);
  pieces_.share_areas(areas, area_vectors_);
  jet::corner_means(nodes_, pieces_.triangles(), centroids_);
}

BagTimes time_bag(const driver::Scene& scene, const JetSurface& surface) {
  membrane::BagDescription bag;
  bag.reference = surface.nodes();
  bag.elements = surface.triangles();
  const auto& given = scene.bag->model.description;
  bag.properties.assign(static_cast<std::size_t>(surface.element_count()), given.properties.front());
  bag.straps = given.straps;
  bag.compression = given.compression;
  const auto model = membrane::make_model(bag);
  auto state = membrane::make_state(model, surface.nodes(), {true, false});
  const std::vector<double> overpressure(static_cast<std::size_t>(surface.element_count()), 0.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BagTimes best{infinity, infinity, infinity};
  const int rounds = std::clamp(2'000'000 / surface.element_count(), 5, 200);
  for (int i = 0; i < rounds; ++i) {
    best.surface = std::min(best.surface, microseconds([&] { membrane::update_surface(model, state); }));
    best.forces = std::min(best.forces, microseconds([&] {
                             membrane::membrane_forces(model, state);
                             membrane::support_forces(model, state);
                             membrane::pressure_forces(state, 20e3);
                             membrane::update_geometry(model, state);
                             membrane::jet_forces(model, state, overpressure);
                           }));
    // So short a step that the shape stays.
    best.advance =
        std::min(best.advance, microseconds([&] { membrane::advance(model, state, 1e-15, 1e-15); }));
  }
  return best;
}

}  // namespace benchmarks
