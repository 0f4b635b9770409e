// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "statics.hpp"

// Long cylinder at rest under constant overpressure.
namespace scenes {

// Long cylinder of radius 0.15 m under 20 kPa.
inline constexpr double kTubeRadius = 0.15, kTubePressure = 2e4;

struct Tube {
  mesh::Mesh mesh;
  int around, along;
  std::vector<int> ring(int j) const {
    std::vector<int> nodes;
    for (int i = 0; i < around; ++i) nodes.push_back(i + j * around);
    return nodes;
  }
};

inline Tube tube(int around) {
  const int along = around / 2;
  const auto place = [](double turn, double height) {
    const double angle = 2.0 * std::numbers::pi * turn;
    return Eigen::Vector3d(kTubeRadius * std::cos(angle), kTubeRadius * std::sin(angle), 0.5 * height);
  };
  return {wrapped_grid(around, along, place), around, along};
}

// End walls that stay plane: they pull the end rings by the pressure on them, and share out the axial force
// evenly.
inline void push_end_walls(const Tube& tube, membrane::BagState& state) {
  for (const int j : {0, tube.along}) {
    const std::vector<int> ring = tube.ring(j);
    double area = 0.0, axial = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d a = state.position.map().col(ring[i]),
                            b = state.position.map().col(ring[(i + 1) % ring.size()]);
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      axial += state.membrane_force.map()(2, ring[i]);
    }
    for (const int n : ring) {
      state.membrane_force.map()(2, n) = axial / tube.around;
      state.volume_gradient.map()(2, n) = (j == 0 ? -1.0 : 1.0) * area / tube.around;
    }
  }
}

struct TubeStretch {
  double hoop, axial;
};
// Half way along the tube.
inline TubeStretch stretch_tube(int around, bool closed, const char* law = "saint_venant_kirchhoff") {
  const Tube t = tube(around);
  auto description = describe(t.mesh, membrane::Compression::none);
  description.law = law;
  const auto model = make_model(description);
  auto state = membrane::make_state(model, 1.05 * t.mesh.nodes);
  if (!closed) state.position.map().row(2) = t.mesh.nodes.row(2);
  std::vector<int> ends = t.ring(0);
  for (const int n : t.ring(t.along)) ends.push_back(n);
  const double tolerance = 1e-9 * kTubePressure * kTubeRadius * kTubeRadius;
  const auto walls = [&](membrane::BagState& s) { push_end_walls(t, s); };
  relax(model, state, kTubePressure, tolerance, closed ? Support(walls) : sliding({{2, ends}}));
  const auto at = [&](int j) { return Eigen::Vector3d(state.position.map().col(j * t.around)); };
  const int middle = t.along / 2;
  return {at(middle).head<2>().norm() / kTubeRadius,
          (at(middle + 1)[2] - at(middle - 1)[2]) / (2.0 * 0.5 / t.along)};
}

}  // namespace scenes
