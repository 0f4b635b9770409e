// SPDX-License-Identifier: Apache-2.0
// The shape of a rigid impactor, and where it is. CONTRIBUTING.md gives the steps to add a shape.
#pragma once
#include <Eigen/Core>
#include <variant>

namespace coupling {

/// A sphere.
struct Sphere {
  double radius = 0.0;  // [m] > 0
};

/// A shape of an impactor.
using Impactor = std::variant<Sphere>;

/// Position of a rigid body.
struct Pose {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m]
  /// [-] (3 x 3) columns: the body's axes in space, orthonormal and right-handed. A sphere ignores them.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// Throws std::invalid_argument that names the first member out of range, such as impactor.radius.
void require_valid(const Impactor& impactor);

/// Length scale [m] of a valid impactor: quadrature points are at most a quarter of it apart, and a point may
/// sink in by half of it. It is the radius of a sphere.
double size_of(const Impactor& impactor);

/// Largest distance [m] of a point of the impactor from its centre.
double reach_of(const Impactor& impactor);

/// Largest area [m2] of a plane section of the impactor: pi r^2 for a sphere.
double section_of(const Impactor& impactor);

}  // namespace coupling
