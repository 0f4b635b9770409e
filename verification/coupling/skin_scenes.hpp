// SPDX-License-Identifier: Apache-2.0
// Skins in contact with themselves, for several tests.
#pragma once
#include <random>

#include "closed_skins.hpp"
#include "coupling/skin_contact.hpp"

namespace scenes {

inline constexpr double kThickness = 0.01, kSkinStiffness = 1e6;  // [m] [N/m3] of the contact
inline constexpr double kDensity = 0.31;                          // [kg/m2] of the skins

inline coupling::SkinContactModel skin_contact(const Skin& skin, double thickness, double stiffness,
                                               double friction = 0.0) {
  return {skin.triangles, skin.nodes, skin.masses, {thickness, stiffness, friction}};
}

/// A level of a skin in contact with itself.
struct SkinLevel {
  coupling::SkinContactResult result;
  Eigen::Matrix3Xd forces;  // [N]
};
inline SkinLevel level_of(const coupling::SkinContactModel& model, coupling::SkinContactState& state,
                          const Eigen::Matrix3Xd& nodes) {
  SkinLevel level;
  level.forces.setZero(3, nodes.cols());
  level.result = model.evaluate(state, nodes, level.forces);
  return level;
}

/// Two plates of the same square, `gap` [m] apart in z. The upper one has its own number of cells.
inline Skin two_plates(int cells, int upper_cells, double side, double gap) {
  Skin upper = plate(upper_cells, side / upper_cells);
  upper.nodes.row(2).array() += gap;
  return joined(plate(cells, side / cells), upper);
}

// A sphere that crumples under an outer pressure, with contact alone against it.
struct Crumple {
  Skin skin = octasphere(3);
  Eigen::Matrix3Xd nodes, velocity;

  explicit Crumple(double radius) {
    skin.nodes *= radius;
    lump_masses(skin, 0.31);
    nodes = skin.nodes;
    velocity.setZero(3, nodes.cols());
    std::mt19937_64 random(3);
    for (Eigen::Index i = 0; i < velocity.size(); ++i)
      velocity(i) = 4.0 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    velocity -= 20.0 * (nodes / radius);
    velocity.row(2) *= 2.0;
  }
  void advance(const Eigen::Matrix3Xd& forces, double dt) {
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      velocity.col(a) += dt / skin.masses[static_cast<std::size_t>(a)] * forces.col(a);
    nodes += dt * velocity;
  }
};

}  // namespace scenes
