// SPDX-License-Identifier: Apache-2.0
// An impactor of the caller that exchanges place and force at intervals: order, and the interval at which it
// becomes unstable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bisection.hpp"
#include "claim.hpp"
#include "engine/controls.hpp"
#include "run_simulation.hpp"

namespace {

using driver::Simulation, Eigen::Vector3d, coupled::drift, coupled::simulation_of;

// A guided mass of the caller strikes a free ball; the two exchange place and force every `interval`. Its
// displacement after 20 ms.
double exchanged(double interval) {
  constexpr double end = 0.02, mass = 1.0;
  Simulation simulation = simulation_of(
      "ball_impact",
      {"unset pendulum", "impactor.centre=[-0.16,0,0]", "impactor.shape.type=sphere",
       "impactor.shape.radius=0.041", "impactor.motion.type=rail", "impactor.motion.direction=[1,0,0]",
       "impactor.motion.mass=1", "impactor.motion.velocity=2", "contact.stiffness_share=0.02",
       "contact.friction=0", "scene.end_time=0.03"});
  driver::ImpactorPlace place{{-0.16, 0.0, 0.0}, Eigen::Matrix3d::Identity(), {2.0, 0.0, 0.0}};
  set_impactor(simulation, place);
  meet_every(simulation, interval);
  for (int k = 0; k < static_cast<int>(std::lround(end / interval)); ++k) {
    simulation.evaluate();
    place.velocity.x() += (k == 0 ? 0.5 : 1.0) * interval / mass * simulation.state().contact.force.x();
    set_impactor_speed(simulation, place.velocity, Vector3d::Zero());
    simulation.advance(interval * (k + 1 - 1e-9));
    place.centre += interval * place.velocity;
    set_impactor(simulation, place);
  }
  simulation.evaluate();
  EXPECT_LT(drift(simulation), 1e-3);
  return place.centre.x() + 0.16;
}

// The force is met at the exchanges and the path is straight between them: a central difference of the
// caller's body, with the interval as its step. Where contact begins its error jumps, so its order is that
// over all intervals.
TEST(simulation, exchange_at_intervals_is_of_second_order) {
  const double exact = exchanged(1.0 / 64000.0);
  std::vector<double> logarithms;
  for (const double interval : {1e-3, 5e-4, 2.5e-4, 1.25e-4})
    logarithms.push_back(std::log2(std::abs(exchanged(interval) - exact)));
  EXPECT_LT(logarithms[0], std::log2(1e-3));
  const double order = (3.0 * (logarithms[0] - logarithms[3]) + logarithms[1] - logarithms[2]) / 10.0;
  claim::expect_near({"K.53", "own impactor that exchanges at intervals: order in them",
                      "2, with the kink of the contact's onset: 0.3"},
                     order, 2.0, 0.3);
}

constexpr double kDepth = 3e-3;  // [m] of the disc in the lid's and the gas's way

// The disc of the gas spring, 1 kg, pressed down slowly to rest at a depth. The lid has little mass, and what
// it vibrates dies out in milliseconds, so that the gas is a spring.
Simulation pressed_spring() {
  Simulation simulation = simulation_of(
      "gas_spring", {"unset scene.gravity", "impactor.motion.mass=1", "scene.end_time=1",
                     "output.history_every=0.05", "contact.stiffness=1e7", "membrane.mass_damping=1000"});
  constexpr double end = 0.02;
  driver::ImpactorPlace place{{0.0, 0.0, 0.38}};
  while (simulation.state().time < end) {
    place.velocity.z() =
        -kDepth * std::numbers::pi / (2.0 * end) * std::sin(std::numbers::pi * simulation.state().time / end);
    set_impactor(simulation, place);
    simulation.evaluate();
    place.centre += simulation.state().step.after * place.velocity;
    simulation.step();
  }
  place.velocity.setZero();
  set_impactor(simulation, place);
  simulation.advance(end + 0.02);
  return simulation;
}

// Whether the disc, held at its depth by a constant force and struck, strays further than it may.
bool strays(const Simulation& pressed, double interval) {
  constexpr double mass = 1.0, struck = 1e-3;  // [kg], [m/s]
  constexpr int exchanges = 16;
  Simulation simulation(pressed);
  const Vector3d rest = simulation.state().body->motion.centre;
  meet_every(simulation, interval);
  simulation.advance((std::floor(simulation.state().time / interval) + 1.0 - 1e-9) * interval);
  simulation.evaluate();
  const double hold = simulation.state().contact.force.z(), begin = simulation.state().time;
  double speed = struck, farthest = 0.0;
  for (int k = 0; k < exchanges; ++k) {
    simulation.evaluate();
    if (k > 0) speed += interval / mass * (simulation.state().contact.force.z() - hold);
    set_impactor_speed(simulation, speed * Vector3d::UnitZ(), Vector3d::Zero());
    simulation.advance(begin + interval * (k + 1 - 1e-9));
    farthest = std::max(farthest, (simulation.state().body->motion.centre - rest).norm());
    if (farthest > 10.0 * struck * interval) return true;
  }
  return false;
}

// A central difference of the disc with the interval as its step, against gas and contact in series.
TEST(simulation, exchange_is_unstable_beyond_two_over_omega) {
  const Simulation pressed = pressed_spring();
  const double area = 8.0 * 0.1 * 0.1 * std::sin(std::numbers::pi / 8.0);  // of 16 sides
  const double force = pressed.state().contact.force.norm();
  const double contact = 1e7 * area, gap = kDepth - force / contact;
  const double gas = 1.4 * pressed.state().gas_point.pressure * area / (0.3 - gap);
  // of 1 kg
  const double predicted = 2.0 * std::sqrt(1.0 / gas + 1.0 / contact);
  const double measured = claim::largest_passing(0.97 * predicted, 1.03 * predicted, 4e-3,
                                                 [&](double interval) { return !strays(pressed, interval); });
  claim::expect_threshold(
      {"K.53", "disc of 1 kg on a gas spring, force and speed met at intervals H",
       "bisection to 4e-3; 16 exchanges see a growth of 15 % each: 3e-3; inertia and damping of the lid"},
      {"own impactor in the loop", "H = 2 √(m/k), k of the bag at rest", predicted, measured, "s",
       "the caller's to keep; a bag that cannot follow within H is stiffer than k"},
      0.98, 1.01);
}

}  // namespace
