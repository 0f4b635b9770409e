// SPDX-License-Identifier: Apache-2.0
// Friction that sticks in the middle of the patch and slides around it: force, stored energy, the switch from
// one to the other, and the loss of a whole cycle, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

constexpr double kFriction = 0.3;
// So shallow that the closed form's limit depth / r -> 0 is off by 1e-6.
constexpr double kShallow = 1e-6 * kRadius;
const double kShallowPatch = std::sqrt(2.0 * kRadius * kShallow);  // [m] its radius

// A plate with elements of `size` patch radii that is displaced along x under the sphere at rest.
class ShallowPlate {
 public:
  explicit ShallowPlate(double size)
      : edge_(size * kShallowPatch),
        skin_(scenes::plate(2 * static_cast<int>(std::ceil(1.4 / size)) + 1, edge_)),
        model_(scenes::contact(skin_, kRadius, kStiffness, 8.41, kFriction)) {}

  /// Presses the sphere in by `depth` [m], at place number `place` of the middle cell.
  void press(int place, double depth) {
    state_ = model_.make_state();
    place_ = 0.0;
    // Even coverage: multiples of the powers of the plastic number's inverse.
    centre_ = {(std::fmod(0.7548776662 * place, 1.0) - 0.5) * edge_,
               (std::fmod(0.5698402910 * place, 1.0) - 0.5) * edge_, kRadius - depth};
    move_to(0.0);
  }
  coupling::ContactResult move_to(double displacement) {
    Matrix3Xd nodes = skin_.nodes;
    nodes.row(0).array() += displacement;
    forces_.setZero(3, nodes.cols());
    return model_.evaluate(state_, nodes, {centre_}, forces_);
  }
  /// The same in equal steps; returns the loss [J].
  double sweep(double displacement, int steps) {
    const double from = place_;
    double loss = 0.0;
    for (int n = 1; n <= steps; ++n) {
      place_ = from + (displacement - from) * n / steps;
      last = move_to(place_);
      loss += last.friction_loss;
    }
    return loss;
  }
  coupling::ContactResult last;

 private:
  double edge_, place_ = 0.0;
  scenes::Skin skin_;
  coupling::ContactModel model_;
  coupling::ContactState state_;
  Vector3d centre_ = Vector3d::Zero();
  Matrix3Xd forces_;
};

struct SlipErrors {
  double force = 0.0, energy = 0.0;  // relative, root mean square over places and depths
};

// Displaced in one step by `share` of what makes all points slide. The depths are from a half to three halves
// of their mean: there are two circles, whose errors on one lattice add or cancel each other, and the
// difference of their radii must pass through some elements.
SlipErrors slip_errors(double size, double share) {
  ShallowPlate plate(size);
  const int places = 432;
  SlipErrors e;
  for (int i = 0; i < places; ++i) {
    const double depth = kShallow * (0.5 + (i + 0.5) / places);
    const double u = share * kFriction * depth;
    const auto exact = closed_form::sphere_plane_slip(kRadius, depth, kStiffness, kFriction, u);
    plate.press(i, depth);
    const double pressed = plate.move_to(0.0).energy;
    const auto touch = plate.move_to(u);
    e.force += std::pow(touch.force.x() / exact.force - 1.0, 2);
    e.energy += std::pow((touch.energy - pressed) / exact.energy - 1.0, 2);
  }
  e.force = std::sqrt(e.force / places), e.energy = std::sqrt(e.energy / places);
  return e;
}

// The tractions have a kink where sticking ends and one at the patch's edge: a lattice sum is off by h^(5/2)
// in the root mean square over places.
TEST(ContactSlip, force_and_energy_of_partial_slip_converge_at_order_5_2) {
  const char* why =
      "432 places of two circles know a root mean square to 5 %, an order to 0.1; 2.5 times that";
  for (const double share : {0.3, 0.7}) {
    std::vector<double> force, energy;
    for (int i = 0; i < 3; ++i) {
      const SlipErrors e = slip_errors(0.12 / (1 << i), share);
      force.push_back(e.force), energy.push_back(e.energy);
    }
    claim::expect_order({"K.16", "sphere that sticks in part: friction, root mean square over places", why},
                        force, 2.25, 2.75);
    claim::expect_order(
        {"K.16", "sphere that sticks in part: energy held, root mean square over places", why}, energy, 2.25,
        2.75);
  }
}

TEST(ContactSlip, friction_grows_from_sticking_to_sliding_as_the_closed_form) {
  ShallowPlate plate(0.04);
  const double whole = kFriction * kShallow;
  for (const double share : {1e-3, 0.1, 0.5, 0.9, 1.0, 1.5}) {
    const auto exact =
        closed_form::sphere_plane_slip(kRadius, kShallow, kStiffness, kFriction, share * whole);
    plate.press(7, kShallow);
    plate.sweep(share * whole, 50);
    claim::expect_relative({"K.16", "sphere from sticking to sliding: friction [N]",
                            "points 1/25 of the patch's radius apart: its area, of order 3/2, to 0.5 %"},
                           plate.last.force.x(), exact.force, 5e-3);
  }
}

// After a turn each point must be let go, and be stretched the other way: twice the displacement for the same
// share of the force.
TEST(ContactSlip, force_after_a_turn_follows_the_loading_curve_at_double_scale) {
  ShallowPlate plate(0.04);
  const double top = 0.8 * kFriction * kShallow;
  const auto load = [](double u) {
    return closed_form::sphere_plane_slip(kRadius, kShallow, kStiffness, kFriction, u).force;
  };
  plate.press(3, kShallow);
  plate.sweep(top, 40);
  for (const double share : {0.5, 0.0, -0.5, -1.0}) {
    plate.sweep(share * top, 40);
    const double exact = load(top) - 2.0 * load(0.5 * (top - share * top));
    claim::expect_near(
        {"K.16", "sphere that turns back while it sticks in part: friction over its largest [-]",
         "points 1/25 of the patch's radius apart: 0.5 %, twice for the doubled curve"},
        plate.last.force.x() / load(top), exact / load(top), 1e-2);
  }
}

// Relative error of the loss of a whole cycle, `steps` from end to end.
double cycle_error(double share, int steps) {
  ShallowPlate plate(0.04);
  const double top = share * kFriction * kShallow;
  const double exact = closed_form::sphere_plane_slip_cycle(kRadius, kShallow, kStiffness, kFriction, top);
  double loss = 0.0;
  const int places = 8;
  for (int i = 0; i < places; ++i) {
    plate.press(i, kShallow);
    plate.sweep(top, steps);
    loss += (plate.sweep(-top, steps) + plate.sweep(top, steps)) / places;
  }
  return (exact - loss) / exact;
}

TEST(ContactSlip, loss_of_a_cycle_converges_at_order_2_in_the_step) {
  for (const double share : {0.8, 1.4})
    claim::expect_order(
        {"K.17", "cycle of sticking and sliding: loss by the number of steps",
         "a point that begins to slide within a step loses too little, by its square; lattice: 3e-4"},
        {cycle_error(share, 5), cycle_error(share, 10), cycle_error(share, 20)}, 1.8, 2.2);
}

}  // namespace
