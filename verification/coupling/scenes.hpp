// SPDX-License-Identifier: Apache-2.0
// Small skins and pendulums that the coupling tests share.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

#include "coupling/pendulum.hpp"
#include "coupling/sphere_contact.hpp"

namespace scenes {

inline constexpr double kRadius = 0.041, kStiffness = 1e8;  // of the sphere [m], [N/m3] of its contact

struct Skin {
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix3Xd nodes;      // [m]
  std::vector<double> masses;  // [kg]
};

// Lumped masses of a skin of surface density [kg/m2].
inline void lump_masses(Skin& skin, double surface_density) {
  skin.masses.assign(static_cast<std::size_t>(skin.nodes.cols()), 0.0);
  for (Eigen::Index e = 0; e < skin.triangles.cols(); ++e) {
    const Eigen::Vector3d a = skin.nodes.col(skin.triangles(0, e)), b = skin.nodes.col(skin.triangles(1, e)),
                          c = skin.nodes.col(skin.triangles(2, e));
    const Eigen::Vector3d u = b - a, v = c - a;
    const double area = 0.5 * std::sqrt(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v));
    for (const int node : skin.triangles.col(e))
      skin.masses[static_cast<std::size_t>(node)] += surface_density * area / 3.0;
  }
}

// Flat plate in z = 0 of 2 cells^2 right triangles, cells of side `edge` [m], centred at the origin.
inline Skin plate(int cells, double edge, double surface_density = 0.31) {
  Skin skin;
  const int row = cells + 1;
  skin.nodes.resize(3, row * row);
  for (int i = 0; i < row; ++i)
    for (int j = 0; j < row; ++j)
      skin.nodes.col(i * row + j) << (i - 0.5 * cells) * edge, (j - 0.5 * cells) * edge, 0.0;
  skin.triangles.resize(3, 2 * cells * cells);
  for (int i = 0, e = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const int a = i * row + j;
      skin.triangles.col(e++) << a, a + row, a + row + 1;
      skin.triangles.col(e++) << a, a + row + 1, a + 1;
    }
  lump_masses(skin, surface_density);
  return skin;
}

inline void shake(Skin& skin, double amplitude, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  for (Eigen::Index i = 0; i < skin.nodes.size(); ++i) skin.nodes(i) += uniform(generator);
}

inline coupling::ContactModel contact(const Skin& skin, double radius, double stiffness,
                                      double effective_mass = 8.41, double friction = 0.0) {
  return coupling::ContactModel(skin.triangles, skin.nodes, skin.masses, effective_mass,
                                {coupling::Sphere{radius}, stiffness, friction});
}

// One evaluation from scratch.
struct Touch {
  coupling::ContactResult result;
  Eigen::Matrix3Xd forces;  // [N]
};
inline Touch touch(const coupling::ContactModel& model, const Eigen::Matrix3Xd& nodes,
                   const Eigen::Vector3d& centre) {
  coupling::ContactState state = model.make_state();
  Touch t;
  t.forces.setZero(3, nodes.cols());
  t.result = model.evaluate(state, nodes, {centre}, t.forces);
  return t;
}

// The pendulum of "Gas Jet Model for Airbag Inflators", hanging, impactor of 82 mm.
inline coupling::PendulumParameters paper_pendulum() {
  coupling::PendulumParameters p;
  p.pivot = {0.0, 0.0, 0.0};
  p.axis = {0.0, -1.0, 0.0};
  p.rest_direction = {0.0, 0.0, -1.0};
  p.mass = 10.9;
  p.inertia_cg = 2.07;
  p.cg_distance = 1.065;
  p.impactor_distance = 1.310;
  p.impactor_radius = 0.041;
  p.gravity = {0.0, 0.0, -9.80665};
  return p;
}

}  // namespace scenes
