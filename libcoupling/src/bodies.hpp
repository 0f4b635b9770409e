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

  SignedDistance signed_distance(const Eigen::Vector3d& point) const {
    const double distance = point.norm();
    return {distance - radius, distance > 0.0 ? (point / distance).eval() : Eigen::Vector3d::Zero()};
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

// The point of a plane that lies deepest in a body or closest to it.
struct Foot {
  Eigen::Vector3d point;
  Eigen::Vector3d section;  // some point of the plane inside the body, if there is one
  double distance;          // [m] signed, of `point`; a lower bound where it is deeper than the body's size
};

// Core of a cylinder: a segment of the z axis.
struct Segment {
  static constexpr const char* kSizeName = "the cylinder's radius";
  double half_length;  // [m]

  double reach() const { return half_length; }
  Eigen::Array3d box() const { return {0.0, 0.0, half_length}; }
  double section(double radius) const {
    return 4.0 * half_length * radius + std::numbers::pi * radius * radius;
  }
  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const {
    return {0.0, 0.0, std::clamp(point.z(), -half_length, half_length)};
  }
  // A point farthest along the direction.
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    return {0.0, 0.0, std::copysign(half_length, direction.z())};
  }
};

// Core of a disc: a flat disc across the z axis.
struct FlatDisc {
  static constexpr const char* kSizeName = "the disc's rim radius";
  double radius;  // [m]

  double reach() const { return radius; }
  Eigen::Array3d box() const { return {radius, radius, 0.0}; }
  double section(double rim) const { return std::numbers::pi * (radius + rim) * (radius + rim); }
  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const {
    const double length = std::sqrt(point.x() * point.x() + point.y() * point.y());
    return length > radius ? on_rim(point, length) : Eigen::Vector3d(point.x(), point.y(), 0.0);
  }
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    const double length = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    return length > 0.0 ? on_rim(direction, length) : Eigen::Vector3d(0.0, 0.0, 0.0);
  }

 private:
  Eigen::Vector3d on_rim(const Eigen::Vector3d& point, double length) const {
    return {radius / length * point.x(), radius / length * point.y(), 0.0};
  }
};

// All points within a radius of a convex core (K.49).
template <class Core>
struct Rounded {
  static constexpr const char* kSizeName = Core::kSizeName;
  Core core;
  double radius;  // [m]

  double size() const { return radius; }
  double reach() const { return core.reach() + radius; }
  double section() const { return core.section(radius); }
  Eigen::Array3d box() const { return core.box() + radius; }  // half the sides of a box around the body

  std::optional<Depth> depth(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d outward = point - core.nearest(point);
    const double squared = outward.squaredNorm();
    if (!(squared < radius * radius)) return std::nullopt;
    const double distance = std::sqrt(squared);
    return Depth{radius - distance, distance, outward};
  }

  SignedDistance signed_distance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d outward = point - core.nearest(point);
    const double distance = outward.norm();
    return {distance - radius, distance > 0.0 ? (outward / distance).eval() : Eigen::Vector3d::Zero()};
  }

  // Of the plane with unit normal n through d n.
  Foot on_plane(const Eigen::Vector3d& n, double d) const {
    const Eigen::Vector3d top = core.farthest(n), bottom = core.farthest(-n);
    const double above = d - n.dot(top), below = n.dot(bottom) - d;
    if (above >= 0.0) return {top + above * n, top + above * n, above - radius};
    if (below >= 0.0) return {bottom - below * n, bottom - below * n, below - radius};
    const Eigen::Vector3d cut = bottom + below / (above + below) * (top - bottom);
    return {cut, cut, -radius};
  }
};

// An ellipsoid along the axes.
struct EllipsoidBody {
  static constexpr const char* kSizeName = "the ellipsoid's least radius of curvature";
  Eigen::Array3d half_axes;  // [m]

  double size() const { return half_axes.minCoeff() * half_axes.minCoeff() / half_axes.maxCoeff(); }
  double reach() const { return half_axes.maxCoeff(); }
  double section() const { return std::numbers::pi * half_axes.prod() / half_axes.minCoeff(); }
  Eigen::Array3d box() const { return half_axes; }

  std::optional<Depth> depth(const Eigen::Vector3d& point) const {
    if (!((point.array() / half_axes).square().sum() < 1.0)) return std::nullopt;
    const SignedDistance surface = signed_distance(point);
    if (!(surface.distance < 0.0)) return std::nullopt;
    return Depth{-surface.distance, 1.0, surface.normal};
  }

  // (K.50). Where two points of the surface are closest, the normal belongs to one of them.
  SignedDistance signed_distance(const Eigen::Vector3d& point) const;

  Foot on_plane(const Eigen::Vector3d& n, double d) const {
    const double height = (half_axes * n.array()).matrix().norm();  // of the body above its centre
    const Eigen::Vector3d top = (half_axes.square() * n.array()).matrix() / height;
    const double above = std::abs(d) - height, side = std::copysign(1.0, d);
    const Eigen::Vector3d foot = side * (top + above * n);
    return {foot, above < 0.0 ? (d / height * top).eval() : foot, std::max(above, -half_axes.minCoeff())};
  }
};

// The body of a shape in its own axes.
inline Ball body_of(const Sphere& sphere) {
  return {sphere.radius};
}
inline EllipsoidBody body_of(const Ellipsoid& ellipsoid) {
  return {ellipsoid.half_axes};
}
inline Rounded<Segment> body_of(const Cylinder& cylinder) {
  return {{cylinder.half_length}, cylinder.radius};
}
inline Rounded<FlatDisc> body_of(const Disc& disc) {
  return {{disc.radius}, disc.rim_radius};
}

}  // namespace coupling::detail
