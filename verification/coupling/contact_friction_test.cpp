// SPDX-License-Identifier: Apache-2.0
// Friction between sphere and skin: Coulomb's force when it slides, elastic when it sticks, its loss against
// the work put in.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "eigenvalues.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

constexpr double kDepth = 0.2 * kRadius;

// A fine plate that a caller moves past the sphere at rest, and one evaluation a level.
struct Slider {
  scenes::Skin skin;
  coupling::ContactModel model;
  coupling::ContactState state = model.make_state();
  Matrix3Xd forces;
  Vector3d centre{0.0007, -0.0004, kRadius - kDepth};
  coupling::ContactResult touch;

  explicit Slider(double friction, double size = 0.05, int cells = 81)
      : skin(scenes::plate(cells, size * kRadius)),
        model(scenes::contact(skin, kRadius, kStiffness, 8.41, friction)) {
    move(Vector3d::Zero());
  }
  void move(const Vector3d& shift, const Vector3d& turn = Vector3d::Zero()) {
    skin.nodes.colwise() += shift;
    forces.setZero(3, skin.nodes.cols());
    touch = model.evaluate(state, skin.nodes, {centre}, forces, turn);
  }
};

TEST(ContactFriction, sliding_force_eq_closed_form) {
  for (const double mu : {0.05, 0.1}) {
    Slider s(mu);
    for (int n = 0; n < 100; ++n) s.move({0.002 * kRadius, 0.0, 0.0});  // slides throughout
    double along = 0.0, across = 0.0;
    const int levels = 100;
    for (int n = 0; n < levels; ++n) {
      s.move({0.002 * kRadius, 0.0, 0.0});
      along += s.touch.force.x() / levels;
      across += s.touch.force.y() / levels;
    }
    const double exact = closed_form::sphere_plane_sliding(kRadius, kDepth, kStiffness, mu);
    // The stretch turns with the sphere's surface over a length mu depth: (mu depth / r)^2 / 2 = 2e-4.
    claim::expect_relative({"K.16", "plate that slides past the sphere: friction [N]",
                            "points r/20 apart: 1e-3 in the mean over four cells; turn of the stretch, 2e-4"},
                           along, exact, 2e-3);
    EXPECT_NEAR(across / exact, 0.0, 2e-3) << mu;
  }
}

TEST(ContactFriction, sticking_is_elastic_and_loses_nothing) {
  Slider s(0.5);
  const double before = s.touch.energy, still = s.touch.force.x();
  // Points at the patch's edge have no depth to stick by: they slide, and lose what their small area holds.
  const double step = 1e-3 * kDepth;
  for (int n = 0; n < 20; ++n) s.move({step, 0.0, 0.0});
  const double pulled = s.touch.force.x() - still, moved = 20 * step;
  // kappa times the patch, less its edge, moved / (mu depth) = 4 %, and the sphere's slope, (a/r)^2/4 = 9 %.
  const double patch = closed_form::sphere_plane_cut(kRadius, kDepth).patch_area;
  EXPECT_NEAR(pulled / (kStiffness * patch * moved), 1.0, 0.15);
  for (int n = 0; n < 20; ++n) s.move({-step, 0.0, 0.0});
  EXPECT_LT(std::abs(s.touch.force.x() - still), 0.05 * pulled);
  EXPECT_NEAR(s.touch.energy, before, 0.05 * 0.5 * pulled * moved);
}

// Work put in by hand = energy stored + loss, for a path that sticks, slides, turns back, sinks and leaves.
double work_gap(int steps) {
  Slider s(0.3);
  const double start = s.touch.energy;
  double work = 0.0, loss = 0.0;
  Vector3d last = Vector3d::Zero(), force = s.forces.rowwise().sum();
  for (int n = 1; n <= steps; ++n) {
    const double t = static_cast<double>(n) / steps;
    const Vector3d place(0.15 * kRadius * std::sin(5.0 * t), 0.1 * kRadius * std::sin(3.0 * t),
                         -0.15 * kRadius * t * t);
    s.move(place - last);
    const Vector3d now = s.forces.rowwise().sum();
    work -= 0.5 * (force + now).dot(place - last);
    loss += s.touch.friction_loss;
    EXPECT_GE(s.touch.friction_loss, -1e-12 * start);
    force = now;
    last = place;
  }
  EXPECT_GT(loss, 0.02 * start);
  return std::abs(work - (s.touch.energy - start) - loss) / start;
}

TEST(ContactFriction, work_eq_stored_energy_and_loss_at_order_2) {
  claim::expect_order(
      {"K.17", "stick, slip and turn, steps four times as many: work less stored energy and loss",
       "trapezoidal work; points that come and go are kinks, which scatter"},
      {work_gap(100), work_gap(400), work_gap(1600)}, 1.75, 2.25, 4.0);
}

TEST(ContactFriction, action_eq_reaction_in_force_and_moment) {
  Slider s(0.4, 0.3, 15);
  for (int n = 0; n < 30; ++n) {
    scenes::shake(s.skin, 1e-4 * kRadius, static_cast<unsigned>(n));
    s.move({0.004 * kRadius, 0.002 * kRadius, 0.0}, {0.0, 0.001, 0.002});
    const double scale = s.touch.force.norm();
    ASSERT_GT(s.touch.couple.norm(), 0.0);
    // A few hundred additions; arms below 1 m.
    EXPECT_LT((s.forces.rowwise().sum() + s.touch.force).norm(), 1e-13 * scale);
    Vector3d moment = Vector3d::Zero();
    for (Eigen::Index a = 0; a < s.forces.cols(); ++a)
      moment += Vector3d(s.skin.nodes.col(a)).cross(Vector3d(s.forces.col(a)));
    EXPECT_LT((moment + s.centre.cross(s.touch.force) + s.touch.couple).norm(), 1e-13 * scale);
  }
}

TEST(ContactFriction, rolling_feels_nothing_and_spinning_drags) {
  Slider rolling(0.3), spinning(0.3);
  const double turn = 1e-4;  // [rad] a level, about y: the foot below the centre moves by -turn * distance
  for (int n = 0; n < 50; ++n) {
    rolling.move({-turn * (kRadius - kDepth), 0.0, 0.0}, {0.0, turn, 0.0});
    spinning.move(Vector3d::Zero(), {0.0, turn, 0.0});
  }
  EXPECT_GT(spinning.touch.force.x(), 0.0);  // the skin holds the foot, which runs towards -x
  // Off the foot the sphere turns out of the plate, with the slope of its surface: (a / r)^2 / 2 = 0.18 of
  // the motion at the patch's rim, less inside.
  EXPECT_LT(std::abs(rolling.touch.force.x()), 0.18 * spinning.touch.force.x());
}

TEST(ContactFriction, none_by_default_and_bad_values_are_named) {
  Slider s(0.0);
  s.move({0.01 * kRadius, 0.0, 0.0});
  EXPECT_EQ(s.touch.couple.norm(), 0.0);
  EXPECT_EQ(s.touch.friction_loss, 0.0);
  for (const double bad : {-0.1, std::nan("")}) {
    try {
      scenes::contact(s.skin, kRadius, kStiffness, 8.41, bad);
      ADD_FAILURE() << bad;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind("contact.friction", 0), 0u) << error.what();
    }
  }
}

TEST(ContactFriction, turn_that_is_not_finite_is_named_and_changes_nothing) {
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    for (const double friction : {0.0, 0.3}) {
      Slider s(friction), other(friction);
      try {
        s.move(Vector3d::Zero(), {0.0, bad, 0.0});
        FAIL() << "no throw";
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("contact.turn"), std::string::npos) << error.what();
      }
      const Vector3d shift(1e-4 * kRadius, 0.0, 0.0), turn(0.0, 1e-3, 0.0);
      s.move(shift, turn);
      other.move(shift, turn);
      EXPECT_EQ(s.touch.force, other.touch.force);
    }
  }
}

// The matrix of the forces' change with the nodes, from one state: sticking or sliding points.
TEST(ContactFriction, bound_covers_the_skewed_stiffness) {
  for (const double mu : {0.2, 1.0})
    for (const double slide : {0.001, 0.5}) {
      Slider s(mu, 0.5, 5);
      for (int n = 0; n < 10; ++n) s.move({0.1 * slide * kDepth, 0.0, 0.0});
      const coupling::ContactState state = s.state;
      const Eigen::Index size = 3 * s.skin.nodes.cols();
      const auto force = [&](Eigen::Index k, double h) {
        coupling::ContactState work = state;
        Matrix3Xd x = s.skin.nodes, f = Matrix3Xd::Zero(3, x.cols());
        x(k) += h;
        s.model.evaluate(work, x, {s.centre}, f);
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(f.data(), size));
      };
      const double h = 1e-9;
      MatrixXd matrix(size, size);
      for (Eigen::Index k = 0; k < size; ++k) matrix.col(k) = -(force(k, h) - force(k, -h)) / (2.0 * h);
      for (Eigen::Index k = 0; k < size; ++k) matrix.row(k) /= s.skin.masses[static_cast<std::size_t>(k / 3)];
      const double largest = dense::spectral_radius(matrix);
      ASSERT_GT(largest, 0.0);
      EXPECT_LE(largest, s.touch.omega_squared_skin * (1.0 + 1e-6)) << mu << ' ' << slide;  // differences
      EXPECT_GE(largest, 0.3 * s.touch.omega_squared_skin) << mu << ' ' << slide;
    }
}

}  // namespace
