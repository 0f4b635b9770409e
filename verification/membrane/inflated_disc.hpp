// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "closed_form/disc.hpp"
#include "statics.hpp"

namespace scenes {

// A flat disc of fabric of radius 0.3 m under the overpressure q E h / a, edge clamped or sewn to its mirror
// image.
struct Disc {
  double q;
  bool sealed;
  static constexpr double kRadius = 0.3;
  double pressure() const { return q * 60e6 * 0.5e-3 / kRadius; }
  closed_form::CircularMembrane exact() const { return {closed_form::paper_fabric(), kRadius, pressure()}; }
};

struct DiscShape {
  double volume, centre_height;
  Eigen::Matrix3Xd nodes;
};
inline DiscShape inflate(const Disc& disc, int rings, double relative_tolerance) {
  const double a = Disc::kRadius;
  const auto mesh = scenes::disc(a, rings);
  std::vector<int> edge;
  for (int n = mesh.node_count() - 6 * rings; n < mesh.node_count(); ++n) edge.push_back(n);
  auto d = describe(mesh, membrane::Compression::none);
  if (!disc.sealed) d.fixed_nodes = edge;
  const auto model = make_model(d);
  Eigen::Matrix3Xd x = (disc.sealed ? 0.8 : 1.0) * mesh.nodes;
  x.row(2) = (disc.sealed ? 0.5 : 0.1) * (a - mesh.nodes.colwise().squaredNorm().array() / a);
  auto state = membrane::make_state(model, x);
  const double tolerance = relative_tolerance * disc.pressure() * a * a / (rings * rings);
  const auto rest = relax(model, state, disc.pressure(), tolerance, sliding({{2, edge}}));
  return {rest.volume, state.position.map()(2, 0), state.position.map()};
}

// The axisymmetric balloon: one of `sectors` equal sectors of the disc, one element wide, its sides in
// symmetry planes.
inline DiscShape inflate_sector(const Disc& disc, int rings, int sectors, double relative_tolerance) {
  const double a = Disc::kRadius, half = std::numbers::pi / sectors;
  const Eigen::Vector3d normal[2] = {{-std::sin(half), -std::cos(half), 0.0},
                                     {-std::sin(half), std::cos(half), 0.0}};
  membrane::BagDescription d;
  d.reference = Eigen::Matrix3Xd::Zero(3, 2 * rings + 1);  // the pole; then each ring's right and left node
  d.elements.resize(3, 2 * rings - 1);
  for (int k = 1; k <= rings; ++k) {
    const double r = a * k / rings;
    d.reference.col(2 * k - 1) << r * std::cos(half), -r * std::sin(half), 0.0;
    d.reference.col(2 * k) << r * std::cos(half), r * std::sin(half), 0.0;
    if (k == 1) d.elements.col(0) << 0, 1, 2;
    if (k > 1) d.elements.col(2 * k - 3) << 2 * k - 3, 2 * k - 1, 2 * k;
    if (k > 1) d.elements.col(2 * k - 2) << 2 * k - 3, 2 * k, 2 * k - 2;
  }
  d.properties.assign(static_cast<std::size_t>(d.elements.cols()), fabric());
  const auto model = make_model(d);
  Eigen::Matrix3Xd x = 0.8 * d.reference;
  x.row(2) = 0.5 * (a - d.reference.colwise().squaredNorm().array() / a);
  auto state = membrane::make_state(model, x);
  const auto planes = [&](membrane::BagState& s) {
    for (auto force : {s.membrane_force.map(), s.volume_gradient.map()}) {
      force.col(0).head<2>().setZero();
      force.row(2).tail<2>().setZero();
      for (int n = 1; n <= 2 * rings; ++n)
        force.col(n) -= force.col(n).dot(normal[n % 2 == 0]) * normal[n % 2 == 0];
    }
  };
  const double tolerance = relative_tolerance * disc.pressure() * a * a / (rings * sectors);
  const Rest rest = relax(model, state, disc.pressure(), tolerance, planes);
  return {sectors * rest.volume, state.position.map()(2, 0), state.position.map()};
}

}  // namespace scenes
