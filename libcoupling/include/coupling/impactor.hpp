// SPDX-License-Identifier: Apache-2.0
// The shape of a rigid impactor, and where it is. Every shape is convex. Sphere, cylinder and disc are all
// points within a radius of a core: a point, a segment, a flat disc. CONTRIBUTING.md gives the steps to add a
// shape.
#pragma once
#include <Eigen/Core>
#include <variant>

namespace coupling {

/// A sphere.
struct Sphere {
  double radius = 0.0;  // [m] > 0
};

/// An ellipsoid along the body's axes.
struct Ellipsoid {
  Eigen::Vector3d half_axes = Eigen::Vector3d::Zero();  // [m] > 0
};

/// A cylinder with hemispheres as ends, along the body's z axis.
struct Cylinder {
  double radius = 0.0;       // [m] > 0
  double half_length = 0.0;  // [m] >= 0: half the distance between the centres of the hemispheres
};

/// A disc with a round rim, across the body's z axis: 2 rim radii thick, 2 (radius + rim radius) wide.
struct Disc {
  double radius = 0.0;      // [m] >= 0 of each flat face
  double rim_radius = 0.0;  // [m] > 0
};

/// A shape of an impactor.
using Impactor = std::variant<Sphere, Ellipsoid, Cylinder, Disc>;

/// Position of a rigid body.
struct Pose {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m]
  /// [-] (3 x 3) columns: the body's axes in space, orthonormal and right-handed. A sphere ignores them.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// Throws std::invalid_argument that names the first member out of range, such as impactor.radius.
void require_valid(const Impactor& impactor);

/// Length scale [m] of a valid impactor: quadrature points are at most a quarter of it apart, and a point may
/// sink in by half of it. It is the radius of a sphere or cylinder, the rim radius of a disc, and the least
/// radius of curvature of an ellipsoid, c^2/a with the shortest and longest half axes (K.49).
double size_of(const Impactor& impactor);

/// Largest distance [m] of a point of the impactor from its centre.
double reach_of(const Impactor& impactor);

/// Largest area [m2] of a plane section of the impactor: pi r^2 for a sphere.
double section_of(const Impactor& impactor);

/// Signed distance of a point from a surface.
struct SignedDistance {
  double distance;         // [m] negative inside; in a rounded body's core minus its radius
  Eigen::Vector3d normal;  // [-] its gradient, outwards; zero in a rounded body's core
};

/// Signed distance (K.49) of `point` [m] from the surface of an impactor. Throws std::invalid_argument for an
/// impactor out of range, and for axes that are not orthonormal.
SignedDistance signed_distance(const Impactor& impactor, const Pose& pose, const Eigen::Vector3d& point);

}  // namespace coupling
