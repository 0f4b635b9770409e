// SPDX-License-Identifier: Apache-2.0
// Contact of impactors of every shape: forces and couples as derivatives of the energy, balances, closed
// forms on a plate, limits, search and guards.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "claim.hpp"
#include "shapes.hpp"

namespace {

using coupling::Pose;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

constexpr double kPi = std::numbers::pi;

scenes::Skin shaken_plate() {
  scenes::Skin skin = scenes::plate(12, 0.5 * kRadius);
  scenes::shake(skin, 0.05 * kRadius, 7);
  return skin;
}

TEST(ContactShape, force_and_couple_eq_minus_energy_derivatives) {
  const scenes::Skin skin = shaken_plate();
  for (const auto& [name, shape] : scenes::shapes())
    for (const double angle : {0.0, 0.4, 1.3}) {
      const auto model = scenes::contact(skin, shape, kStiffness);
      const Pose pose = scenes::pressed(shape, 0.2 * kRadius, angle);
      const auto energy = [&, &model = model](const Matrix3Xd& x, const Pose& at) {
        return scenes::touch(model, x, at).result.energy;
      };
      const auto t = scenes::touch(model, skin.nodes, pose);
      ASSERT_GT(t.result.energy, 0.0);
      const double scale = t.result.force.norm();
      const double h = 1e-9;  // as for the sphere: rounding and points that enter are below 1e-6
      for (int i = 0; i < 3; ++i) {
        const Vector3d d = h * Vector3d::Unit(i);
        const double slope = (energy(skin.nodes, {pose.centre + d, pose.axes}) -
                              energy(skin.nodes, {pose.centre - d, pose.axes})) /
                             (2.0 * h);
        claim::expect_near({"K.51", name + " in a shaken skin: force by differences of the energy [N]",
                            "1e-6 of the force: rounding"},
                           t.result.force[i], -slope, 2e-6 * scale);
        const double turn = h / kRadius;
        const auto rotated = [&, &at = pose](double by) {
          return Pose{at.centre, scenes::turned(by, Vector3d::Unit(i)) * at.axes};
        };
        const double moment =
            (energy(skin.nodes, rotated(turn)) - energy(skin.nodes, rotated(-turn))) / (2.0 * turn);
        claim::expect_near({"K.51", name + " in a shaken skin: couple by differences of the energy [N m]",
                            "1e-6 of force times radius: rounding"},
                           t.result.couple[i], -moment, 3e-6 * scale * kRadius);
      }
      for (Eigen::Index a = 0; a < skin.nodes.cols(); a += 5)
        for (int i = 0; i < 3; ++i) {
          Matrix3Xd up = skin.nodes, down = skin.nodes;
          up(i, a) += h;
          down(i, a) -= h;
          EXPECT_NEAR(t.forces(i, a), -(energy(up, pose) - energy(down, pose)) / (2.0 * h), 2e-6 * scale);
        }
    }
}

// With friction, after a step with a rotation.
TEST(ContactShape, action_eq_reaction_in_force_and_moment) {
  const scenes::Skin skin = shaken_plate();
  for (const auto& [name, shape] : scenes::shapes())
    for (const double friction : {0.0, 0.5}) {
      const auto model = scenes::contact(skin, shape, kStiffness, friction);
      auto state = model.make_state();
      const Pose pose = scenes::pressed(shape, 0.2 * kRadius, 0.4);
      Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
      model.evaluate(state, skin.nodes, pose, forces);
      const Vector3d turn(0.002, -0.003, 0.001);
      const Pose next{pose.centre + Vector3d(2e-4, 1e-4, -1e-4),
                      scenes::turned(turn.norm(), turn) * pose.axes};
      forces.setZero();
      const auto result = model.evaluate(state, skin.nodes, next, forces, turn);
      EXPECT_EQ(result.friction_loss > 0.0, friction > 0.0);
      const double scale = result.force.norm();
      claim::expect_near({"K.51", name + " in a shaken skin: forces on skin and body, their sum [N]",
                          "a few hundred additions of one sign"},
                         (forces.rowwise().sum() + result.force).norm(), 0.0, 1e-13 * scale);
      Vector3d moment = next.centre.cross(result.force) + result.couple;
      for (Eigen::Index a = 0; a < forces.cols(); ++a)
        moment += Vector3d(skin.nodes.col(a)).cross(Vector3d(forces.col(a)));
      claim::expect_near({"K.51", name + ": their moments, sum [N m]", "arms below 1 m"}, moment.norm(), 0.0,
                         1e-13 * scale);
    }
}

// (K.52) per unit of stiffness: a cylinder that lies on a plate, and a disc. Height of the core's axis or
// plane: h = r - depth.
double strip(double r, double h) {
  return r * std::asinh(std::sqrt(r * r - h * h) / h) - std::sqrt(r * r - h * h);
}
double cylinder_force(double r, double half_length, double depth) {
  const double h = r - depth;
  return kPi * depth * depth * h + 4.0 * half_length * h * strip(r, h);
}
double disc_force(double radius, double r, double depth) {
  const double h = r - depth;
  return kPi * radius * radius * depth + 2.0 * kPi * radius * h * strip(r, h) + kPi * h * depth * depth;
}

// Root mean square of the relative error over places, as for the sphere.
template <class Exact>
double plate_error(double size, const coupling::Impactor& shape, const Matrix3d& axes, const Exact& exact) {
  const int cells = 2 * static_cast<int>(std::ceil(2.4 / size)) + 1;
  const auto skin = scenes::plate(cells, size * kRadius);
  const auto model = scenes::contact(skin, shape, kStiffness);
  constexpr int places = 48;
  double sum = 0.0;
  for (int i = 0; i < places; ++i) {
    const double x = (std::fmod(0.7548776662 * i, 1.0) - 0.5) * size * kRadius;
    const double y = (std::fmod(0.5698402910 * i, 1.0) - 0.5) * size * kRadius;
    const double depth = 0.2 * kRadius * (1.0 + (i + 0.5 - 0.5 * places) / (3.0 * places));
    const auto t = scenes::touch(model, skin.nodes, Pose{{x, y, kRadius - depth}, axes}).result;
    sum += std::pow(t.force.z() / (kStiffness * exact(depth)) - 1.0, 2);
  }
  return std::sqrt(sum / places);
}

TEST(ContactShape, disc_on_a_plate_converges_to_the_closed_form) {
  std::vector<double> errors;
  for (int i = 0; i < 3; ++i)
    errors.push_back(plate_error(0.16 / (1 << i), coupling::Disc{kRadius, kRadius}, Matrix3d::Identity(),
                                 [](double depth) { return disc_force(kRadius, kRadius, depth); }));
  EXPECT_LT(errors[0], 1e-3);
  claim::expect_order({"K.52", "disc flat on a plate: force, root mean square over places",
                       "the derivative jumps on a circle: 5/2; 48 places know an order to 0.2"},
                      errors, 2.1, 2.9);
}

TEST(ContactShape, cylinder_on_a_plate_converges_to_the_closed_form) {
  const Matrix3d lying =
      scenes::turned(0.37, Vector3d::UnitZ()) * scenes::turned(0.5 * kPi, Vector3d::UnitX());
  for (const double size : {0.04, 0.08, 0.16}) {
    const double error = plate_error(size, coupling::Cylinder{kRadius, kRadius}, lying,
                                     [](double depth) { return cylinder_force(kRadius, kRadius, depth); });
    claim::expect_near(
        {"K.52", "cylinder along a plate, elements of 0.04 to 0.16 r: force, relative error [-]",
         "order 2: the spacing over the width of the strip, squared"},
        error, 0.0, 0.1 * size * size);
  }
}

TEST(ContactShape, pressure_times_area_is_the_force_of_a_wide_disc) {
  const double wide = 1.0, rim = 0.01, depth = 0.004;
  const auto skin = scenes::plate(240, 0.01);
  const auto t = scenes::touch(scenes::contact(skin, coupling::Disc{wide, rim}, kStiffness), skin.nodes,
                               Pose{{0.0, 0.0, rim - depth}});
  claim::expect_relative({"K.52", "disc of 1 m, rim of 10 mm, 4 mm in a plate: stiffness x depth x area [N]",
                          "the rim adds 2 (0.6 x 0.36) rim/radius"},
                         t.result.force.z(), kStiffness * depth * kPi * wide * wide, 0.01);
  claim::expect_relative({"K.52", "the same, with the rim", "points 2.5 mm apart on a rim 8 mm wide"},
                         t.result.force.z(), kStiffness * disc_force(wide, rim, depth), 5e-5);
}

// Elements from a tenth of the size to three times it.
TEST(ContactShape, energy_does_not_depend_on_the_mesh) {
  for (const auto& [name, shape] : scenes::shapes()) {
    const Pose pose = scenes::pressed(shape, 0.2 * kRadius, 0.4);
    const auto energy = [&, &shape = shape](double size) {
      const auto skin = scenes::plate(2 * static_cast<int>(std::ceil(3.5 / size)), size * kRadius);
      return scenes::touch(scenes::contact(skin, shape, kStiffness), skin.nodes, pose).result.energy;
    };
    const double fine = energy(0.02);
    for (const double size : {0.1, 0.25, 1.0, 3.0})
      claim::expect_relative({"K.10", name + " in a plate, elements from 0.1 to 3 times its size: energy [J]",
                              "points a quarter of the size apart, on a patch of the size"},
                             energy(size), fine, 1e-2);
  }
}

TEST(ContactShape, round_limits_eq_sphere) {
  const scenes::Skin skin = shaken_plate();
  const Pose pose = scenes::tilted({0.003, 0.001, 0.8 * kRadius}, 0.4);
  const auto sphere =
      scenes::touch(scenes::contact(skin, coupling::Sphere{kRadius}, kStiffness), skin.nodes, pose);
  const std::pair<const char*, coupling::Impactor> limits[] = {
      {"ellipsoid of equal axes", coupling::Ellipsoid{{kRadius, kRadius, kRadius}}},
      {"cylinder without length", coupling::Cylinder{kRadius, 0.0}},
      {"disc without faces", coupling::Disc{0.0, kRadius}}};
  for (const auto& [name, shape] : limits) {
    const auto t = scenes::touch(scenes::contact(skin, shape, kStiffness), skin.nodes, pose);
    const double scale = sphere.result.force.norm();
    claim::expect_relative({"K.49", std::string(name) + ": energy of the sphere [J]", "rounding"},
                           t.result.energy, sphere.result.energy, 1e-12);
    claim::expect_near(
        {"K.49", std::string(name) + ": forces of the sphere on all nodes, difference [N]", "rounding"},
        (t.forces - sphere.forces).cwiseAbs().maxCoeff(), 0.0, 1e-12 * scale);
    EXPECT_LT(t.result.couple.norm(), 1e-13 * scale * kRadius);
    EXPECT_EQ(t.result.area, sphere.result.area);
    EXPECT_EQ(t.result.deepest_element, sphere.result.deepest_element);
  }
}

// The search is a cache: a path with rotations gives the bits of evaluations from scratch.
TEST(ContactShape, carried_state_gives_the_same_bits) {
  const scenes::Skin skin = scenes::plate(24, 0.4 * kRadius);
  for (const auto& [name, shape] : scenes::shapes()) {
    const auto model = scenes::contact(skin, shape, kStiffness);
    auto state = model.make_state();
    Matrix3Xd forces(3, skin.nodes.cols());
    Pose last;
    int touching = 0, clear = 0;
    for (int n = 0; n < 250; ++n) {
      const double s = 0.02 * n;
      Pose pose = scenes::pressed(shape, (0.9 * std::sin(2.9 * s) - 0.5) * kRadius, 1.4 * std::sin(0.9 * s));
      pose.centre.x() += 0.15 * std::sin(s);
      pose.centre.y() += 0.1 * std::sin(1.7 * s);
      const double motion =
          (pose.centre - last.centre).norm() + (pose.axes - last.axes).norm() * coupling::reach_of(shape);
      last = pose;
      const auto t = scenes::touch(model, skin.nodes, pose);
      touching += t.result.deepest_element >= 0;
      if (n % 3 != 0 && n > 0 && model.stays_clear(state, motion)) {
        ASSERT_EQ(t.result.deepest_element, -1) << name << ' ' << n;
        ++clear;
        continue;
      }
      if (n % 3 == 0 && n > 0) model.stays_clear(state, motion);
      if (state.started && std::isnan(state.told)) continue;
      const auto result = model.evaluate(state, skin.nodes, pose, forces.setZero());
      ASSERT_EQ(result.energy, t.result.energy) << name << ' ' << n;
      ASSERT_EQ(result.couple, t.result.couple) << name << ' ' << n;
      ASSERT_EQ(forces, t.forces) << name << ' ' << n;
    }
    EXPECT_GT(touching, 30) << name;
    EXPECT_GT(clear, 30) << name;
  }
}

std::string message_of(coupling::ContactState& state, const coupling::ContactModel& model,
                       const Matrix3Xd& nodes, const Pose& pose) {
  Matrix3Xd forces = Matrix3Xd::Zero(3, nodes.cols());
  try {
    model.evaluate(state, nodes, pose, forces);
  } catch (const coupling::ContactError& error) {
    return error.what();
  }
  return "";
}

TEST(ContactShape, penetration_beyond_half_the_size_throws) {
  const scenes::Skin skin = scenes::plate(40, 0.1 * kRadius);
  const char* limits[] = {"half the sphere's radius", "half the ellipsoid's least radius of curvature",
                          "half the cylinder's radius", "half the disc's rim radius"};
  int i = 0;
  for (const auto& [name, shape] : scenes::shapes()) {
    const auto model = scenes::contact(skin, shape, kStiffness);
    const double size = coupling::size_of(shape);
    auto state = model.make_state();
    EXPECT_EQ(message_of(state, model, skin.nodes, scenes::pressed(shape, 0.49 * size, 0.3)), "") << name;
    const std::string deep = message_of(state, model, skin.nodes, scenes::pressed(shape, 0.53 * size, 0.3));
    EXPECT_NE(deep.find(limits[i]), std::string::npos) << deep;
    ++i;
  }
}

TEST(ContactShape, motion_beyond_the_clearance_throws) {
  const scenes::Skin skin = scenes::plate(40, 0.3 * kRadius);
  const coupling::Impactor bar = coupling::Cylinder{kRadius, 4.0 * kRadius};
  const auto model = scenes::contact(skin, bar, kStiffness);
  const auto message = [&](const Pose& first, const Pose& second) {
    auto state = model.make_state();
    EXPECT_EQ(message_of(state, model, skin.nodes, first), "");
    return message_of(state, model, skin.nodes, second);
  };
  const Matrix3d lying = scenes::turned(0.5 * kPi, Vector3d::UnitX());
  // 2 radii above the skin, its surface 1: a step of less than 2 radii is followed.
  const Pose above{{0.0, 0.0, 2.0 * kRadius}, lying};
  const auto step = [&](double by) { return message(above, {{0.0, by * kRadius, 2.0 * kRadius}, lying}); };
  EXPECT_EQ(step(1.9), "");
  EXPECT_NE(step(2.1).find("the cylinder's radius plus the gap before"), std::string::npos) << step(2.1);
  EXPECT_NE(message(above, {{0.0, 0.0, -2.0 * kRadius}, lying}).find("may have crossed"), std::string::npos);
  // A turn about the skin's normal moves the ends by up to twice their distance, 5 radii.
  const auto turn = [&](double by) {
    return message(above, {above.centre, scenes::turned(by, Vector3d::UnitZ()) * lying});
  };
  EXPECT_EQ(turn(1.9 / 5.0), "");
  EXPECT_NE(turn(2.1 / 5.0).find("may have crossed"), std::string::npos) << turn(2.1 / 5.0);
}

}  // namespace
