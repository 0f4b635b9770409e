// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "scenes.hpp"

// Small bags with gas, and whether they blow up; shared by the tests and the stability maps.
namespace scenes {

inline constexpr double kGamma = 1.4, kAmbient = 101325.0;

// A bag at rest in equilibrium, with gas of the absolute pressure p0 at the volume V0 inside (p0 = 0: none).
struct Bag {
  membrane::BagModel model;
  Eigen::Matrix3Xd x;
  double pressure = 0.0, volume = 0.0;

  double gauge(double v) const {
    return pressure > 0.0 ? pressure * std::pow(volume / v, kGamma) - kAmbient : 0.0;
  }
  Eigen::Matrix3Xd force(const Eigen::Matrix3Xd& at) const {
    const auto state = evaluated(model, at);
    return state.membrane_force.map() + gauge(state.surface.volume) * state.volume_gradient.map();
  }
};

// Largest displacement over that of the first step, from a kick of 1e-10 of the size; 1e5 is a blow-up, which
// ends the run. `lagged`: the pressure is that of the step before. `taken`, if wanted: steps until the
// blow-up, or all of them.
inline constexpr double kBlownUp = 1e5;
inline double growth(const Bag& bag, double dt, int steps = 400, bool lagged = false, int* taken = nullptr) {
  auto state = membrane::make_state(bag.model, bag.x);
  const double kick = 1e-10 * bag.x.cwiseAbs().maxCoeff();
  state.velocity.map() = kick / dt * Random(3).vectors(bag.x.cols());
  double largest = 0.0, before = bag.gauge(bag.volume);
  int i = 0;
  for (; i < steps && largest < kBlownUp; ++i) {
    membrane::update_skin(bag.model, state);
    const double now = bag.gauge(state.surface.volume);
    membrane::pressure_forces(state, lagged ? before : now);
    before = now;
    membrane::advance(bag.model, state, dt, dt);
    largest = std::max(largest, (state.position.map() - bag.x).cwiseAbs().maxCoeff() / kick);
  }
  if (taken != nullptr) *taken = i;
  return largest;
}

// The icosahedron's nodes are all alike, so one pressure holds it at any stretch.
inline Bag icosahedron(double stretch) {
  const auto mesh = mesh::icosphere(0.3, 0);
  Bag bag{make_model(describe(mesh, membrane::Compression::none)), stretch * mesh.nodes};
  const auto state = evaluated(bag.model, bag.x);
  const double inward = -state.membrane_force.map().cwiseProduct(bag.x).sum();
  bag.volume = state.surface.volume;
  bag.pressure = kAmbient + inward / (3.0 * bag.volume);  // x . dV/dx = 3 V
  return bag;
}

}  // namespace scenes
