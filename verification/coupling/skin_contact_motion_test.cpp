// SPDX-License-Identifier: Apache-2.0
// Layers of a skin that move: a layer that falls on another, friction between layers, and the step at which
// contact becomes unstable (K.44, K.46; friction K.16, K.17).
#include <gtest/gtest.h>

#include <cmath>

#include "bisection.hpp"
#include "claim.hpp"
#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kDensity;
using scenes::kSkinStiffness;
using scenes::kThickness;

// Two free layers of the same mesh that move along z, by central differences.
struct Falling {
  scenes::Skin skin = scenes::two_plates(3, 3, 0.6, 3.0 * kThickness);
  coupling::SkinContactModel model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
  coupling::SkinContactState state = model.make_state();
  Matrix3Xd nodes = skin.nodes, speed = Matrix3Xd::Zero(3, skin.nodes.cols());
  const Eigen::Index half = skin.nodes.cols() / 2;
  double energy = 0.0;

  void step(double dt) {
    const auto level = scenes::level_of(model, state, nodes);
    energy = level.result.energy;
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      speed(2, a) += dt / skin.masses[static_cast<std::size_t>(a)] * level.forces(2, a);
    nodes += dt * speed;
  }
  double momentum() const {
    double sum = 0.0;
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      sum += skin.masses[static_cast<std::size_t>(a)] * speed(2, a);
    return sum;
  }
};

constexpr double kReduced = 0.5 * kDensity;  // [kg/m2]
const double kDuration = M_PI * std::sqrt(kReduced / kSkinStiffness);
// Goes 0.15 h deep, where no edges touch.
const double kSpeed = 0.15 * kThickness / std::sqrt(kReduced / kSkinStiffness);

struct Bounce {
  double duration = 0.0, speed = 0.0,
         momentum = 0.0;  // relative to the exact ones, minus 1; momentum: of m v
};

// Means over onsets that are spread evenly over a step.
Bounce mean_bounce(int steps) {
  const double dt = kDuration / steps;
  const int onsets = 16;
  Bounce mean;
  for (int k = 0; k < onsets; ++k) {
    Falling scene;
    const double free = (2.3 * steps / 10.0 + (k + 0.5) / onsets) * dt;  // [s] until they touch
    scene.nodes.rightCols(scene.half).row(2).setConstant(kThickness + kSpeed * free);
    scene.speed.rightCols(scene.half).row(2).setConstant(-kSpeed);
    const double before = scene.momentum();
    const int total = 2 * steps;
    for (int n = 0; n < total; ++n) scene.step(dt);
    const double gap = scene.nodes(2, scene.half) - scene.nodes(2, 0);
    const double speed = scene.speed(2, scene.half) - scene.speed(2, 0);
    // Back from where they are to where they parted.
    const double duration = total * dt - free - (gap - kThickness) / speed;
    mean.duration += (duration / kDuration - 1.0) / onsets;
    mean.speed += (speed / kSpeed - 1.0) * (speed / kSpeed - 1.0) / onsets;
    mean.momentum = std::max(mean.momentum, std::abs(scene.momentum() / before - 1.0));
  }
  return mean;
}

TEST(SkinContactMotion, layer_that_falls_on_another_bounces_in_half_a_period_with_its_energy) {
  std::vector<double> duration, speed;
  for (const int steps : {10, 20, 40, 80}) {
    const Bounce bounce = mean_bounce(steps);
    duration.push_back(bounce.duration);
    speed.push_back(std::sqrt(bounce.speed));
    claim::expect_near({"K.44", "layer that falls on a free one: change of momentum, of m v",
                        "rounding of some hundred steps"},
                       bounce.momentum, 0.0, 1e-12);
  }
  claim::expect_order({"K.44", "layer that falls on a free one: duration by pi sqrt(m / (2 kappa)), minus 1",
                       "central differences; mean over 16 phases of the onset in a step"},
                      duration, 1.9, 2.1);
  claim::expect_order(
      {"K.44", "layer that falls on a free one: speed after by that before, minus 1",
       "kinks of the force at onset and end leave third order; root mean square of 16 phases"},
      speed, 2.7, 3.3);
  EXPECT_LT(speed.back(), 1e-5);
}

// The upper layer is rigid, the lower one is at rest. Its nodes are half a cell off, so that the layers share
// the same area while they slide by less than that.
class Sliding {
 public:
  static constexpr double friction = 0.3, side = 0.3, cell = 0.05, area = side * side;  // [-] [m] [m] [m2]

  explicit Sliding(double gap) : gap_(gap) {
    Matrix3Xd far = skin_.nodes;
    far.rightCols(upper).row(2).setConstant(3.0 * kThickness);
    scenes::level_of(model_, state_, far);
    move(Vector3d::Zero());
  }
  /// Moves to that displacement along the layers; returns the work of the mean of the two forces.
  double move(const Vector3d& to) {
    Matrix3Xd nodes = skin_.nodes;
    nodes.rightCols(upper).row(2).setConstant(gap_);
    nodes.rightCols(upper).colwise() += to;
    const auto level = scenes::level_of(model_, state_, nodes);
    const Vector3d before = force;
    force = level.forces.rightCols(upper).rowwise().sum();
    const double work = 0.5 * (before + force).dot(to - at);
    at = to;
    result = level.result;
    return work;
  }
  Vector3d at = Vector3d::Zero(), force = Vector3d::Zero();  // of the upper layer [m] [N]
  coupling::SkinContactResult result;

 private:
  static constexpr Eigen::Index upper = 49;
  static scenes::Skin make() { return scenes::joined(scenes::plate(7, cell), scenes::plate(6, cell)); }
  double gap_;
  scenes::Skin skin_ = make();
  coupling::SkinContactModel model_ = scenes::skin_contact(skin_, kThickness, kSkinStiffness, friction);
  coupling::SkinContactState state_ = model_.make_state();
};

TEST(SkinContactMotion, layers_stick_below_friction_and_slide_at_it) {
  const double gap = 0.85 * kThickness, pressure = kSkinStiffness * (kThickness - gap);
  const double most = Sliding::friction * (kThickness - gap);  // [m] stretch at which they slide
  Sliding sliding(gap);
  for (const double share : {0.2, 0.5, 0.99}) {
    sliding.move({share * most, 0.0, 0.0});
    claim::expect_relative(
        {"K.16", "layer on a layer, sticking: force kappa A s [N]", "rounding of some 100 terms"},
        -sliding.force.x(), kSkinStiffness * Sliding::area * share * most, 1e-12);
    EXPECT_NEAR(sliding.result.friction_loss, 0.0, 1e-18);
  }
  for (const double share : {1.1, 2.0, 5.0}) {
    sliding.move({share * most, 0.0, 0.0});
    claim::expect_relative(
        {"K.16", "layer on a layer, sliding: force mu p A [N]", "rounding of some 100 terms"},
        -sliding.force.x(), Sliding::friction * pressure * Sliding::area, 1e-12);
    EXPECT_GT(sliding.result.friction_loss, 0.0);
  }
}

// To and fro and around.
TEST(SkinContactMotion, work_of_friction_is_stored_or_lost_to_rounding) {
  const double gap = 0.85 * kThickness, most = Sliding::friction * (kThickness - gap);
  Sliding sliding(gap);
  const double start = sliding.result.energy;
  double work = 0.0, loss = 0.0;
  for (int n = 1; n <= 60; ++n) {
    const double t = 0.2 * n;
    work += sliding.move(3.0 * most * Vector3d(std::sin(t), 1.0 - std::cos(1.7 * t), 0.0));
    loss += sliding.result.friction_loss;
  }
  EXPECT_GT(loss, 10.0 * kSkinStiffness * Sliding::area * most * most);
  claim::expect_relative(
      {"K.17", "layer on a layer, to and fro: work of friction, loss and stored energy [J]",
       "rounding of 60 levels"},
      loss + sliding.result.energy - start, -work, 1e-12);
}

// Slides until half of its energy is lost: v^2 = u^2 - (mu p / rho) (2 x - s), s the stretch of sticking.
TEST(SkinContactMotion, layer_that_slides_slows_down_by_mu_p_over_its_density_at_order_2) {
  const double gap = 0.85 * kThickness, pressure = kSkinStiffness * (kThickness - gap);
  const double stretch = Sliding::friction * (kThickness - gap),
               slowing = Sliding::friction * pressure / kDensity;
  const double start = std::sqrt(slowing * 0.016);  // stops after 8 mm
  const double omega = std::sqrt(kSkinStiffness / kDensity);
  const double stick = std::asin(stretch * omega / start) / omega;  // [s] until it slides
  const double slides = start * std::cos(omega * stick);            // [m/s] then
  const double end = stick + 0.5 * slides / slowing;
  const double exact = stretch + slides * (end - stick) - 0.5 * slowing * (end - stick) * (end - stick);
  std::vector<double> error;
  for (const int steps : {80, 160, 320}) {
    double mean = 0.0;
    const int onsets = 8;  // phases of the step at which it is let go
    for (int k = 0; k < onsets; ++k) {
      Sliding sliding(gap);
      const double dt = end / (steps + (k + 0.5) / onsets);
      double x = 0.0, speed = start, last = 0.0, time = 0.0;
      for (; time + dt <= end * (1.0 + 1e-12); time += dt) {
        last = sliding.force.x() / (kDensity * Sliding::area);
        speed += (time == 0.0 ? 0.5 : 1.0) * dt * last;
        x += dt * speed;
        sliding.move({x, 0.0, 0.0});
      }
      const double rest = end - time, now = sliding.force.x() / (kDensity * Sliding::area);
      mean += (x + rest * (speed + 0.5 * dt * now) + 0.5 * rest * rest * now) / onsets;
    }
    error.push_back(mean / exact - 1.0);
  }
  claim::expect_order({"K.16", "layer that slides on another: relative error of its way",
                       "central differences; mean over 8 phases of the end of sticking in a step"},
                      error, 1.8, 2.2);
}

// Two layers held together by a pressure, each a free sheet: amplitude of what begins as rounding.
double amplitude(double dt, int steps) {
  Falling scene;
  const double gap = 0.9 * kThickness, pressure = kSkinStiffness * (kThickness - gap);
  scene.step(0.0);
  Matrix3Xd start = scene.nodes;
  start.rightCols(scene.half).row(2).setConstant(gap);
  scene.nodes = start;
  for (Eigen::Index a = 0; a < start.cols(); ++a)
    scene.speed(2, a) = 1e-12 / dt * std::cos(2.0 + 3.0 * static_cast<double>(a));
  double largest = 0.0;
  for (int n = 0; n < steps && largest < 1e-4; ++n) {
    for (Eigen::Index a = 0; a < start.cols(); ++a)
      scene.speed(2, a) += (a < scene.half ? 1.0 : -1.0) * dt * pressure / kDensity;
    scene.step(dt);
    largest = std::max(largest, (scene.nodes - start).row(2).cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST(SkinContactMotion, flat_layers_blow_up_at_2_over_the_omega_of_the_bound) {
  Falling scene;
  scene.step(0.0);
  scene.nodes.rightCols(scene.half).row(2).setConstant(0.9 * kThickness);
  scene.step(0.0);  // at rest: what comes fast counts as stiffer
  const double bound = scenes::level_of(scene.model, scene.state, scene.nodes).result.omega_squared;
  claim::expect_relative({"K.46", "two flat layers: bound of omega^2, 2 kappa / surface density [1/s2]",
                          "some ten additions a node"},
                         bound, 2.0 * kSkinStiffness / kDensity, 1e-12);
  const double limit = 2.0 / std::sqrt(bound);
  const double measured = claim::largest_passing(0.5 * limit, 2.0 * limit, 2e-4,
                                                 [&](double dt) { return amplitude(dt, 1000) < 1e-8; });
  claim::expect_threshold({"K.46", "two flat layers of one mesh, free, held together by a pressure",
                           "bisection to 2e-4; tilting elements add (h - d) d / side^2 = 2e-4"},
                          {"contact stiffness", "Δt = 2/ω, ω² = 2 κ/(ρ h)", limit, measured, "s",
                           "Δt follows any stiffness before it touches; a fixed step: exit 3"},
                          1.0 - 1e-3, 1.0 + 1e-3);
}

}  // namespace
