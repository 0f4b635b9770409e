// SPDX-License-Identifier: Apache-2.0
// Impactors of every shape, of the same size.
#pragma once
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "coupling/side.hpp"
#include "scenes.hpp"

namespace scenes {

struct NamedShape {
  std::string name;
  coupling::Impactor shape;
};

inline std::vector<NamedShape> shapes() {
  return {{"sphere", coupling::Sphere{kRadius}},
          {"ellipsoid", coupling::Ellipsoid{{2.0 * kRadius, 1.7 * kRadius, 1.5 * kRadius}}},
          {"cylinder", coupling::Cylinder{kRadius, 1.5 * kRadius}},
          {"disc", coupling::Disc{1.8 * kRadius, kRadius}}};
}

inline Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& about = {0.36, 0.48, 0.8}) {
  return Eigen::AngleAxisd(angle, about.normalized()).toRotationMatrix();
}

inline coupling::Pose tilted(const Eigen::Vector3d& centre, double angle) {
  return {centre, turned(angle)};
}

inline coupling::ContactModel contact(const Skin& skin, const coupling::Impactor& shape, double stiffness,
                                      double friction = 0.0) {
  return coupling::ContactModel(skin.triangles, skin.nodes, skin.masses, 8.41, {shape, stiffness, friction});
}

inline Touch touch(const coupling::ContactModel& model, const Eigen::Matrix3Xd& nodes,
                   const coupling::Pose& pose) {
  coupling::ContactState state = model.make_state();
  Touch t;
  t.forces.setZero(3, nodes.cols());
  t.result = model.evaluate(state, nodes, pose, t.forces);
  return t;
}

// The pose at this angle in which the body reaches `depth` [m] below the plane z = 0.
inline coupling::Pose pressed(const coupling::Impactor& shape, double depth, double angle) {
  const Skin wide = plate(1, 100.0);
  const coupling::Pose high = tilted({0.003, 0.001, 10.0}, angle);
  const double gap = coupling::smallest_gap(wide.triangles, wide.nodes, shape, high).distance;
  return tilted({0.003, 0.001, 10.0 - gap - depth}, angle);
}

}  // namespace scenes
