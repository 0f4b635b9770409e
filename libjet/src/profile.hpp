// SPDX-License-Identifier: Apache-2.0
// The velocity profile behind an outlet in the outlet's own frame: written once, for the pointwise functions
// and S4.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "jet/centreline.hpp"
#include "jet/jet.hpp"

namespace jet::profile {

/// Position in the outlet's frame, and the radius that the Gaussian sees.
struct Local {
  double z;        // [m] along the axis
  double along;    // [m] along the long side; 0 for a round outlet
  double radius2;  // [m2] squared distance from the axis (round) or from the long mid-plane (rectangular)
};

inline Local local(const JetModel& model, const Eigen::Vector3d& across, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = point - model.centre;
  const double z = d.dot(model.axis);
  if (model.shape == OutletShape::round) return {z, 0.0, (d - z * model.axis).squaredNorm()};
  const double y = d.dot(across);
  return {z, d.dot(model.long_direction), y * y};
}

/// Unit vector of the velocity. Upstream distance of the virtual origin as in centreline.hpp.
inline Eigen::Vector3d direction(const JetModel& model, const Eigen::Vector3d& across,
                                 const Eigen::Vector3d& point) {
  if (model.direction == Direction::axial) return model.axis;
  const Eigen::Vector3d d = point - model.centre;
  if (model.shape == OutletShape::round) {
    return (d + model.radius * round_virtual_origin(model.decay_coefficient) * model.axis).normalized();
  }
  const double origin = 0.5 * model.short_side * plane_virtual_origin(model.decay_coefficient);
  return (d.dot(across) * across + (d.dot(model.axis) + origin) * model.axis).normalized();
}

/// V / V0 on the ray of similarity: V_max / V0 exp(-(r/R)^2).
inline double speed(const Section& section, double radius2) {
  return section.decay * std::exp(-radius2 / (section.width * section.width));
}

}  // namespace jet::profile
