// SPDX-License-Identifier: Apache-2.0
// A thrown, spinning disc: centre on its parabola, rotation that of a rigid body as the fabric stiffens.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "claim.hpp"
#include "membrane/error.hpp"
#include "statics.hpp"

using membrane::Compression;

namespace {

constexpr double kRadius = 0.3, kSpin = 40.0, kTurned = 6.0;  // [m], [rad/s], [rad]
const Eigen::Vector3d kStart(0.2, -0.1, 0.4), kVelocity(3.0, 1.0, 5.0), kGravity(0.5, -1.0, -9.81);

struct Flight {
  double lag;                     // behind the rigid body's rotation [rad]
  Eigen::Vector3d centre, exact;  // of mass, at the end; and the parabola's point [m]
  double off_plane;               // largest distance of a node from the disc's plane [m]
};

Flight fly(double young_modulus) {
  const auto mesh = scenes::disc(kRadius, 6);
  auto d = scenes::describe(mesh, Compression::linear);
  for (auto& p : d.properties) p.young_modulus = young_modulus;
  d.gravity = kGravity;
  const auto model = make_model(d);
  const Eigen::Matrix3d frame = scenes::rotation();
  auto state = membrane::make_state(model, (frame * mesh.nodes).colwise() + kStart);
  for (int n = 0; n < mesh.node_count(); ++n)
    state.velocity.map().col(n) =
        kVelocity + frame * (kSpin * Eigen::Vector3d::UnitZ()).cross(Eigen::Vector3d(mesh.nodes.col(n)));
  double time = 0.0;
  for (double dt = 0.0, before = 0.0; time < kTurned / kSpin; time += dt, before = dt) {
    membrane::membrane_forces(model, state);
    dt = 0.9 * membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, 0.0));
    membrane::advance(model, state, before, dt);
  }
  const Eigen::Map<const Eigen::VectorXd> mass(model.node_mass.data(), model.node_count);
  const Eigen::Vector3d centre = state.position.map() * mass / mass.sum();
  const Eigen::Matrix3Xd x = frame.transpose() * (state.position.map().colwise() - centre);
  double sine = 0.0, cosine = 0.0;  // of the angle from the rigid body's place, weighted by mass and arm
  const Eigen::Matrix3Xd rigid =
      Eigen::AngleAxisd(kSpin * time, Eigen::Vector3d::UnitZ()).toRotationMatrix() * mesh.nodes;
  for (int n = 0; n < mesh.node_count(); ++n) {
    cosine += mass[n] * (rigid(0, n) * x(0, n) + rigid(1, n) * x(1, n));
    sine += mass[n] * (rigid(1, n) * x(0, n) - rigid(0, n) * x(1, n));
  }
  return {std::atan2(sine, cosine), centre, kStart + time * kVelocity + 0.5 * time * time * kGravity,
          x.row(2).cwiseAbs().maxCoeff()};
}

// Of a spinning disc at small strain the moment of inertia grows by twice this, u = rho w^2 r / (8 E) ((1 -
// nu) (3 + nu) a^2 - (1 - nu^2) r^2) averaged with r^3 (S. P. Timoshenko, J. N. Goodier, Theory of
// Elasticity).
double spin_strain(double young_modulus) {
  const double nu = 0.3;
  return 620.0 * kSpin * kSpin * kRadius * kRadius / (8.0 * young_modulus) * (1.0 - nu) *
         ((3.0 + nu) - (1.0 + nu) * 2.0 / 3.0);
}

}  // namespace

// Compression is carried here: starting unstretched, the disc swings between no strain and twice that of the
// spin.
TEST(Flight, thrown_disc_tends_to_rigid_body_with_order_1_in_compliance) {
  std::vector<double> lag;
  for (const double young_modulus : {60e6, 120e6, 240e6, 480e6}) {
    const Flight flight = fly(young_modulus);
    // Sums of up to 2000 steps of 1 m: a parabola is exact for equal steps, and these differ by the strain.
    claim::expect_near({"M.9", "thrown disc: distance of its centre from the parabola [m]",
                        "sums of up to 2000 steps of 1 m"},
                       (flight.centre - flight.exact).norm(), 0.0, 2000 * scenes::kEps);
    EXPECT_LE(flight.off_plane, 2000 * scenes::kEps);
    claim::expect_near({"M.9", "spinning disc by stiffness: lag behind the rigid body [rad]",
                        "mesh of 6 rings, 1 / 36, and steps, (omega dt)^2"},
                       flight.lag, 2.0 * spin_strain(young_modulus) * kTurned, flight.lag / 36.0);
    lag.push_back(flight.lag);
  }
  claim::expect_order(
      {"M.9", "spinning disc as it stiffens: lag behind the rigid body", "first order in 1/E"}, lag, 0.95,
      1.05);
}

// One step from rest shape, without force: each node moves by its own length along an axis where it was at 0.
TEST(Flight, a_coordinate_below_1e_90_m_is_zero_and_others_keep_their_bits) {
  constexpr double kStep = 1e-6;
  for (const membrane::Isa isa : {membrane::Isa::scalar, membrane::Isa::baseline, membrane::best_isa()}) {
    const auto mesh = scenes::disc(kRadius, 2);  // in z = 0
    auto d = scenes::describe(mesh, Compression::linear);
    d.isa = isa;
    const auto model = make_model(d);
    for (const double length : {5e-324, 1e-199, 1e-100, 9e-91, 2e-90, 1e-80, 1e-17, 1e-3}) {
      for (const double sign : {-1.0, 1.0}) {
        auto state = membrane::make_state(model, mesh.nodes);
        state.velocity.map().row(2).setConstant(sign * length / kStep);
        membrane::membrane_forces(model, state);
        membrane::advance(model, state, 0.0, kStep);
        const double moved = 0.0 + kStep * (sign * length / kStep);
        for (int n = 0; n < mesh.node_count(); ++n) {
          EXPECT_EQ(state.position.map()(2, n), length < 1e-90 ? 0.0 : moved) << length;
          EXPECT_EQ(state.velocity.map()(2, n), sign * length / kStep);
        }
      }
    }
    auto state = membrane::make_state(model, mesh.nodes);  // what is no number stays so, and is refused
    state.velocity.map()(2, 0) = std::numeric_limits<double>::quiet_NaN();
    membrane::membrane_forces(model, state);
    EXPECT_THROW(membrane::advance(model, state, 0.0, kStep), membrane::MembraneError);
    EXPECT_TRUE(std::isnan(state.position.map()(2, 0)));
  }
}
