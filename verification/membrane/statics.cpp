// SPDX-License-Identifier: Apache-2.0
#include "statics.hpp"

#include <numbers>
#include <stdexcept>

namespace scenes {

using std::numbers::pi;

namespace {

// Total force on the free components, the largest of them, and how it changed over the last displacement.
struct Balance {
  double largest = 0.0;    // [N]
  double frequency = 0.0;  // Rayleigh quotient of the last displacement, omega [rad/s]
};

Balance balance(const membrane::BagModel& model, const membrane::BagState& state, double dt,
                Eigen::Matrix3Xd& force) {
  Balance result;
  double work = 0.0, inertia = 0.0;
  for (int n = 0; n < model.node_count; ++n) {
    for (int c = 0; c < 3; ++c) {
      if (model.inverse_mass.map()(c, n) == 0.0) continue;
      const Eigen::Index i = 4 * Eigen::Index{n} + c;
      const double now =
          state.membrane_force.data()[i] + state.gauge_pressure * state.volume_gradient.data()[i];
      const double moved = dt * state.velocity.data()[i];
      work -= moved * (now - force(c, n));
      inertia += model.node_mass[static_cast<std::size_t>(n)] * moved * moved;
      result.largest = std::max(result.largest, std::abs(now));
      force(c, n) = now;
    }
  }
  if (work > 0.0) result.frequency = std::sqrt(work / inertia);
  return result;
}

}  // namespace

mesh::Mesh wrapped_grid(int around, int along, const Place& place) {
  Eigen::Matrix3Xd nodes(3, around * (along + 1));
  std::vector<Eigen::Vector3i> elements;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      nodes.col(i + j * around) = place(static_cast<double>(i) / around, static_cast<double>(j) / along);
      if (j == along) continue;
      const int a = i + j * around, b = (i + 1) % around + j * around;
      elements.emplace_back(a, b, b + around);
      elements.emplace_back(a, b + around, a + around);
    }
  return plain_mesh(nodes, elements);
}

Support sliding(std::vector<HeldComponent> held) {
  return [held = std::move(held)](membrane::BagState& state) {
    for (const auto& [component, nodes] : held)
      for (const int n : nodes) {
        state.membrane_force.map()(component, n) = 0.0;
        state.volume_gradient.map()(component, n) = 0.0;
      }
  };
}

Rest relax(membrane::BagModel model, membrane::BagState& state, double overpressure, double tolerance,
           const Support& support) {
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, model.node_count);
  double dt = 0.0, largest = 0.0;
  for (int step = 0; step < 100000; ++step) {
    membrane::update_skin(model, state);
    membrane::pressure_forces(state, overpressure);
    const double volume = volume_about_origin(state);
    if (support) support(state);
    const Balance b = balance(model, state, dt, force);
    if (b.largest <= tolerance) return {state.forces.strain_energy - overpressure * volume, volume, step};
    model.description.mass_damping = 2.0 * b.frequency;
    const double before = dt;
    dt = 0.9 * membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, 0.0));
    membrane::advance(model, state, before, dt);
    largest = b.largest;
  }
  throw std::runtime_error("relax: not at rest after 100 000 steps, force left " + std::to_string(largest) +
                           " N");
}

double volume_about_origin(const membrane::BagState& state) {
  const Eigen::Vector3d first = state.position.map().col(0);
  return state.surface.volume + first.dot(state.volume_gradient.map().rowwise().sum()) / 3.0;
}

}  // namespace scenes
