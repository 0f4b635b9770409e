// SPDX-License-Identifier: Apache-2.0
// Two tensioned strips that a pressure from outside lays on each other, against their closed form (K.44).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;

constexpr double kGap = 1e-3;  // [m] thickness
const closed_form::PressedStrips kStrips{200.0, 0.15, 1.6e-3, 1e6};

// A strip of `cells` x 2 squares, in x from clamp to clamp.
scenes::Skin strip(int cells, double height) {
  scenes::Skin skin;
  const double side = 2.0 * kStrips.half_width / cells;
  skin.nodes.resize(3, 3 * (cells + 1));
  skin.triangles.resize(3, 4 * cells);
  Eigen::Index e = 0;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = 3 * i + j;
      skin.nodes.col(a) << i * side - kStrips.half_width, j * side, height;
      if (i == cells || j == 2) continue;
      skin.triangles.col(e++) << a, a + 3, a + 4;
      skin.triangles.col(e++) << a, a + 4, a + 1;
    }
  scenes::lump_masses(skin, scenes::kDensity);
  return skin;
}

struct StripsAtRest {
  double force, middle;  // [N/m] of the contact, per width; [m] gap
};

// Linear elements of the tension, nodes that move along z alone, by damped steps.
StripsAtRest strips_at_rest(int cells, double load) {
  const double side = 2.0 * kStrips.half_width / cells;
  const scenes::Skin skin = scenes::joined(strip(cells, 0.0), strip(cells, 2.0 * kStrips.approach + kGap));
  const auto model = scenes::skin_contact(skin, kGap, kStrips.stiffness);
  auto state = model.make_state();
  const Eigen::Index half = skin.nodes.cols() / 2;
  Matrix3Xd nodes = skin.nodes, speed = Matrix3Xd::Zero(3, nodes.cols()), contact = speed;
  const double highest =
      model.full_omega_squared() + 8.0 * kStrips.tension / (scenes::kDensity * side * side);
  const double dt = 1.5 / std::sqrt(highest);
  const double slowest = 0.5 * M_PI / kStrips.half_width * std::sqrt(kStrips.tension / scenes::kDensity);
  const int steps = static_cast<int>(30.0 / (slowest * dt));
  for (int n = 0; n < steps; ++n) {
    const double ramp = std::min(1.0, 2.5 * n / steps);  // layers that meet gently stay in the first half
    contact = scenes::level_of(model, state, nodes).forces;
    for (Eigen::Index a = 0; a < nodes.cols(); ++a) {
      const Eigen::Index i = (a % half) / 3, j = (a % half) % 3;
      if (i == 0 || i == cells) continue;
      const double mass = skin.masses[static_cast<std::size_t>(a)];
      const double share = mass / (scenes::kDensity * side * side);  // of a cell
      double force = contact(2, a) + (a < half ? 1.0 : -1.0) * ramp * load * share * side * side;
      // Sides along x are diagonals' legs: one on the rim, two inside.
      force +=
          kStrips.tension * (j == 1 ? 1.0 : 0.5) * (nodes(2, a + 3) + nodes(2, a - 3) - 2.0 * nodes(2, a));
      for (const Eigen::Index b : {a - 1, a + 1})
        if ((b > a ? j < 2 : j > 0)) force += kStrips.tension * (nodes(2, b) - nodes(2, a));
      speed(2, a) = (1.0 - 2.0 * slowest * dt) * speed(2, a) + dt / mass * force;
    }
    nodes += dt * speed;
  }
  const Eigen::Index middle = 3 * (cells / 2) + 1;
  return {contact.rightCols(half).row(2).sum() / (2.0 * side), nodes(2, half + middle) - nodes(2, middle)};
}

TEST(SkinContactStrips, contact_of_pressed_strips_follows_its_closed_form_as_cells_shrink) {
  for (const int cells : {20, 40, 80})
    for (const double load : {100.0, 121.0, 144.0}) {
      const closed_form::StripPress exact = closed_form::pressed_strips(kStrips, load);
      const StripsAtRest press = strips_at_rest(cells, load);
      const double side = 2.0 * kStrips.half_width / cells;
      const double layer = std::sqrt(0.5 * kStrips.tension / kStrips.stiffness);
      claim::expect_relative(
          {"K.44", "two tensioned strips laid on each other: gap in the middle h - p / kappa [m]",
           "the contact ends more than 6 of its layers away; damped steps leave less"},
          press.middle, kGap - exact.closing, 1e-3);
      claim::expect_relative({"K.44", "two tensioned strips laid on each other: force of the contact [N/m]",
                              "linear elements: a hundredth of the square of a cell by the layer at its end"},
                             press.force, exact.force, 0.01 * side * side / (layer * layer));
    }
}

}  // namespace
