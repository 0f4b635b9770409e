// SPDX-License-Identifier: Apache-2.0
// A heavy sphere rebounds from a light, tensioned circular membrane: it gives back all its energy but what
// the membrane's waves keep; depth and duration are those of the membrane without mass.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "coupling/sphere_contact.hpp"
#include "disc_mesh.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace {

using Eigen::Vector3d;

constexpr double kRim = 0.3, kSphere = 10.0, kPatch = 0.1;  // [m]: slopes up to 1/100
constexpr double kStrain = 0.05;                            // Green-Lagrange, both ways

// N = h E/(1 - nu) times the strain, stress and thickness changes with the stretch cancelling.
closed_form::MembraneDent dent() {
  return {0.5e-3 * 60e6 / 0.7 * kStrain, kRim, kSphere};
}

// Flat disc of n rings, clamped at the rim.
membrane::BagDescription disc(int n) {
  const auto mesh = scenes::disc(kRim, n);
  membrane::BagDescription d;
  d.reference = mesh.nodes;
  d.elements = mesh.elements;
  for (int i = 0; i < 6 * n; ++i) d.fixed_nodes.push_back(mesh.node_count() - 6 * n + i);
  d.properties.assign(static_cast<std::size_t>(mesh.element_count()), {0.5e-3, 620.0, 60e6, 0.3});
  return d;
}

struct Bounce {
  double depth = 0.0, duration = 0.0;  // [m] [s]
  double kept = 0.0;                   // share of the sphere's energy that stays in the membrane
  double drift = 0.0;                  // of the energy in all, root mean square, as such a share
  double mass_ratio = 0.0;             // membrane over sphere
};

// Steps of one size, `safety` of the bound with all the skin in touch.
Bounce rebound(int rings, double mass, double share, double safety) {
  auto description = disc(rings);
  const Eigen::Matrix3Xd flat = description.reference;
  description.reference /= std::sqrt(1.0 + 2.0 * kStrain);
  const auto model = membrane::make_model(description);
  auto state = membrane::make_state(model, flat, {false, true});
  const double kappa = coupling::default_contact_stiffness(
      {share, model.fabric_frequency, 0.31, coupling::Sphere{kSphere}, mass});
  const coupling::ContactModel contact(description.elements, description.reference, model.node_mass, mass,
                                       {coupling::Sphere{kSphere}, kappa});
  auto cache = contact.make_state();
  membrane::update_skin(model, state);
  const double stiffest = membrane::stiffness_shares(model, state, 0.0, 0.0, kappa / 0.31).total();
  const double dt = safety * 2.0 / std::sqrt(stiffest);
  const double energy = closed_form::membrane_dent(dent(), kPatch).energy,
               strain = state.forces.strain_energy;
  const double start = -std::sqrt(2.0 * energy / mass);
  double height = kSphere, speed = start, squares = 0.0;
  Bounce b;
  for (int n = 0;; ++n) {
    state.contact_force.map().setZero();
    const auto touch =
        contact.evaluate(cache, state.position.map(), {{0.0, 0.0, height}}, state.contact_force.map());
    if (touch.area > 0.0) b.duration = n * dt;
    b.depth = std::max(b.depth, kSphere - height);
    const double before = n == 0 ? 0.0 : dt, next = speed + 0.5 * (before + dt) / mass * touch.force.z();
    membrane::advance(model, state, before, dt);
    // Of level n, by the product of the velocities before and after, for both bodies.
    const double held = state.advance.kinetic_product + 0.5 * mass * speed * next + touch.energy +
                        state.forces.strain_energy - strain;
    if (n > 0) squares += std::pow(held / energy - 1.0, 2);
    speed = next;
    height += dt * speed;
    membrane::update_skin(model, state);
    if (height > kSphere + 0.2 * b.depth) {
      b.kept = 1.0 - std::pow(speed / start, 2);
      b.drift = std::sqrt(squares / n);
      b.mass_ratio = model.fabric_mass / mass;
      return b;
    }
  }
}

TEST(ContactRebound, depth_and_duration_converge_to_the_massless_membrane) {
  const double mass = 40.0, speed = std::sqrt(2.0 * closed_form::membrane_dent(dent(), kPatch).energy / mass);
  const auto exact = closed_form::membrane_rebound(dent(), mass, speed);
  std::vector<double> error;
  for (const int rings : {6, 12, 24}) {
    const Bounce b = rebound(rings, mass, 1.0, 0.8);
    error.push_back(b.depth / exact.turn.depth - 1.0);
    claim::expect_relative({"K.19", "heavy sphere rebounds from a membrane, three meshes: duration [s]",
                            "twice as far off as the depth, and the membrane's mass rides along"},
                           b.duration, exact.duration, 2.0 * std::abs(error.back()) + b.mass_ratio);
  }
  // The membrane's mass, 2e-3 of the sphere's, takes 0.06 off order 2; where the patch's edge falls between
  // the rings scatters a doubling by 0.12 (six of them, from 6 to 12 rings up): twice that.
  claim::expect_order({"K.19", "heavy sphere rebounds from a membrane: error of the depth",
                       "mesh and stiffness together; the patch's edge among the rings scatters by 0.12"},
                      error, 1.7, 2.2);
}

// Skin that leaves with the sphere is no faster than it, so the waves keep less than its mass ratio of the
// energy.
TEST(ContactRebound, membrane_keeps_less_than_its_mass_ratio_of_the_energy) {
  for (const double mass : {2.5, 10.0, 40.0}) {
    const Bounce b = rebound(8, mass, 1.0, 0.8);
    claim::expect_near({"K.19", "heavy sphere rebounds from a membrane: energy it does not get back [-]",
                        "conservation: waves keep less than the ratio of the masses"},
                       b.kept, 0.0, b.mass_ratio);
    EXPECT_GT(b.kept, 0.0) << mass;
    EXPECT_LT(b.drift, 0.05 * b.kept) << mass;  // what is kept is waves, not an error of the method
  }
}

// Points come into touch one by one, a kink each; a soft contact spreads over many. One halving scatters by
// 0.6 about its order 2, three together by 0.2 (two masses, five stiffnesses).
TEST(ContactRebound, energy_drift_is_of_order_2) {
  const double coarse = rebound(8, 2.5, 0.03, 0.4).drift, fine = rebound(8, 2.5, 0.03, 0.05).drift;
  EXPECT_NEAR(std::log2(coarse / fine) / 3.0, 2.0, 0.25);
}

}  // namespace
