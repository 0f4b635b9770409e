// SPDX-License-Identifier: Apache-2.0
// Jets in general position, shared by the tests of this folder.
#pragma once

#include <Eigen/Geometry>

#include "jet/jet.hpp"
#include "jet/outlet.hpp"
#include "plates.hpp"

namespace models {

inline const Eigen::Vector3d kAxis = Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0;
inline const Eigen::Vector3d kLong = Eigen::Vector3d(3.0, -6.0, 2.0) / 7.0;  // perpendicular to kAxis
inline const Eigen::Vector3d kAcross = kAxis.cross(kLong);
inline const Eigen::Vector3d kCentre(0.1, -0.2, 0.05);  // [m]
inline const jet::OutletState kOutlet{410.0, 0.97, 1.17e5, 406.0};

inline jet::JetModel round(double radius, double decay_coefficient) {
  jet::JetModel model;
  model.centre = kCentre;
  model.axis = kAxis;
  model.radius = radius;
  model.decay_coefficient = decay_coefficient;
  return jet::validated(model);
}

inline jet::JetModel rectangular(double short_side, double long_side, double decay_coefficient) {
  jet::JetModel model;
  model.shape = jet::OutletShape::rectangular;
  model.centre = kCentre;
  model.axis = kAxis;
  model.long_direction = kLong;
  model.short_side = short_side;
  model.long_side = long_side;
  model.decay_coefficient = decay_coefficient;
  return jet::validated(model);
}

/// Plate normal to the axis at distance z: n x n square cells of side h, a node on the axis. Normal along the
/// axis.
inline plates::Target normal_plate(double z, double h, int n) {
  return plates::plate(kCentre + z * kAxis, h * kLong, h * kAcross, n, n);
}

/// Plate tilted about the long direction by theta, n x n cells that are squares of side h seen along the
/// axis.
inline plates::Target tilted_plate(double z, double theta, double h, int n) {
  const Eigen::Vector3d slope = kAcross + std::tan(theta) * kAxis;
  return plates::plate(kCentre + z * kAxis, h * kLong, h * slope, n, n);
}

}  // namespace models
