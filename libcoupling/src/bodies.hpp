// SPDX-License-Identifier: Apache-2.0
// Impactors as signed distances with a normal. All points are relative to the impactor's centre.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "coupling/impactor.hpp"
#include "distances.hpp"

namespace coupling::detail {

// Position of a point below the surface.
struct Depth {
  double depth;             // [m] > 0: minus the signed distance
  double length;            // [m] length of `outward`; 0 where the distance has no gradient
  Eigen::Vector3d outward;  // [m] along the surface's outward normal

  Eigen::Vector3d normal() const { return outward / length; }  // requires length > 0
};

// Range of the parameter of a line.
struct Stretch {
  double begin;  // the lower end
  double end;    // the upper end
};

// A sphere about the origin.
struct Ball {
  static constexpr const char* kSizeName = "the sphere's radius";
  static constexpr bool kTurns = false;  // it looks the same from all sides
  double radius;

  double size() const { return radius; }
  double reach() const { return radius; }
  double section() const { return std::numbers::pi * radius * radius; }

  // Minus the signed distance of the point, if it is inside, with the outward normal.
  std::optional<Depth> depth(const Eigen::Vector3d& point) const {
    const double squared = point.squaredNorm();
    if (!(squared < radius * radius)) return std::nullopt;
    const double distance = std::sqrt(squared);
    return Depth{radius - distance, distance, point};
  }

  // Signed distance [m] of a triangle, or a lower bound. The closer the bound, the less often the skin is
  // searched.
  double distance_to_triangle(const Eigen::Matrix3d& corners) const {
    return distance_from_origin(corners) - radius;
  }

  // Lower bound [m] of the signed distance of every point within `reach` of the point.
  double distance_to_ball(const Eigen::Vector3d& point, double reach) const {
    return point.norm() / kRounding - reach - radius;
  }

  // Lower bound [m] of the signed distance of every point of a box.
  double distance_to_box(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    return low.max(-high).max(0.0).matrix().norm() / kRounding - radius;
  }

  // Stretch on which the line start + t step can be inside, with a margin for rounding; empty if it is
  // outside.
  std::optional<Stretch> inside(const Eigen::Vector3d& start, const Eigen::Vector3d& step) const {
    const double length2 = step.squaredNorm(), middle = -start.dot(step);
    const double discriminant = middle * middle - length2 * (start.squaredNorm() - radius * radius);
    const double slack = 1e-9 * length2 * radius * radius;  // round-off near a grazing line
    if (discriminant < -slack || !(length2 > 0.0)) return std::nullopt;
    const double half_chord = std::sqrt(std::max(discriminant, 0.0));
    return Stretch{(middle - half_chord) / length2, (middle + half_chord) / length2};
  }

  static constexpr double kRounding = 1.0 + 1e-12;  // margin for points that only round-off puts out of reach
};

// The body of a shape in its own axes.
inline Ball body_of(const Sphere& sphere) {
  return {sphere.radius};
}

// The body of a shape in the axes of space.
inline Ball place(const Sphere& sphere, const Eigen::Matrix3d&) {
  return body_of(sphere);
}

}  // namespace coupling::detail
