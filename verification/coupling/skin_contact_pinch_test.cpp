// SPDX-License-Identifier: Apache-2.0
// A tube of inextensible fabric that two plates pinch until its layers meet (K.44).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "claim.hpp"
#include "skin_scenes.hpp"

namespace {

constexpr double kRadius = 0.1, kLength = 0.1, kStiffness = 1e8;  // [m] [m] [N/m3]

// Between plates a distance apart a tube has two flat layers, pi (R - s/2) wide, and two half circles.
Eigen::Vector3d on_pinched(double arc, double y, double apart) {
  const double flat = M_PI * (kRadius - 0.5 * apart), turn = 0.5 * M_PI * apart, r = 0.5 * apart;
  double s = std::fmod(arc, 2.0 * (flat + turn));
  const double sign = s < flat + turn ? 1.0 : -1.0;
  if (sign < 0.0) s -= flat + turn;
  if (s < flat) return {sign * (s - 0.5 * flat), y, -sign * r};
  const double angle = (s - flat) / r;
  return {sign * (0.5 * flat + r * std::sin(angle)), y, -sign * r * std::cos(angle)};
}

scenes::Skin pinched(int around, double apart) {
  const double side = 2.0 * M_PI * kRadius / around;
  const int rows = static_cast<int>(std::lround(kLength / side)) + 1;
  scenes::Skin skin;
  skin.nodes.resize(3, around * rows);
  skin.triangles.resize(3, 2 * around * (rows - 1));
  Eigen::Index e = 0;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < rows; ++j) {
      const int a = i * rows + j, b = (i + 1) % around * rows + j;
      skin.nodes.col(a) = on_pinched((i + 0.3) * side, j * side, apart);
      if (j == rows - 1) continue;
      skin.triangles.col(e++) << a, b, b + 1;
      skin.triangles.col(e++) << a, b + 1, a + 1;
    }
  scenes::lump_masses(skin, scenes::kDensity);
  return skin;
}

// Force and energy of layers that are 0.85 of the thickness apart, over those of the flat part alone; the
// thickness is 0.4 of a side.
std::vector<double> excess(int around) {
  const double side = 2.0 * M_PI * kRadius / around, thickness = 0.4 * side, apart = 0.85 * thickness;
  const scenes::Skin start = pinched(around, 1.1 * thickness), skin = pinched(around, apart);
  const auto model = scenes::skin_contact(start, thickness, kStiffness);
  auto state = model.make_state();
  scenes::level_of(model, state, start.nodes);
  const scenes::SkinLevel level = scenes::level_of(model, state, skin.nodes);
  double force = 0.0;
  for (Eigen::Index a = 0; a < skin.nodes.cols(); ++a)
    if (skin.nodes(2, a) > 0.0) force += level.forces(2, a);
  const double length = skin.nodes.row(1).maxCoeff(), area = M_PI * (kRadius - 0.5 * apart) * length;
  const double depth = thickness - apart;
  return {force / (kStiffness * depth * area) - 1.0,
          level.result.energy / (0.5 * kStiffness * depth * depth * area) - 1.0};
}

TEST(SkinContactPinch, tube_between_plates_presses_with_its_flat_width) {
  std::vector<double> force, energy;
  for (const int around : {40, 80, 160, 320}) {
    const std::vector<double> of = excess(around);
    force.push_back(of[0]);
    energy.push_back(of[1]);
  }
  claim::expect_order(
      {"K.44", "tube that two plates pinch: force beyond kappa (h - s) pi (R - s/2) per length",
       "elements at both creases, whose parts are neighbours"},
      force, 0.8, 1.2);
  claim::expect_order(
      {"K.44", "tube that two plates pinch: energy beyond kappa (h - s)^2 / 2 pi (R - s/2) per length",
       "elements at both creases, whose parts are neighbours"},
      energy, 0.8, 1.2);
}

}  // namespace
