// SPDX-License-Identifier: Apache-2.0
// A body turned into the axes of space. All points are relative to its centre.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bodies.hpp"

namespace coupling::detail {

// Least signed distance [m] on the segment a + t edge, t in [0, 1], or a lower bound within rounding. The
// distance from a convex body is convex along it, so two tangents give a bound.
template <class Body>
double distance_to_edge(const Body& body, const Eigen::Vector3d& a, const Eigen::Vector3d& edge) {
  struct Place {
    double t, value, slope;
  };
  const auto at = [&](double t) {
    const SignedDistance surface = body.signed_distance(a + t * edge);
    return Place{t, surface.distance, surface.normal.dot(edge)};
  };
  Place low = at(0.0), high = at(1.0);
  if (!(low.slope < 0.0)) return low.value;
  if (!(high.slope > 0.0)) return high.value;
  const double tolerance = 1e-12 * (std::abs(low.value) + std::abs(high.value) + body.size());
  constexpr int kMostSteps = 100;  // seen: 20
  for (int step = 0;; ++step) {
    const double rise = high.slope - low.slope, width = high.t - low.t;
    const double crossing = std::clamp((low.value - high.value + high.slope * width) / rise, 0.0, width);
    const double bound = low.value + low.slope * crossing;
    if (std::min(low.value, high.value) - bound <= tolerance || step == kMostSteps) return bound;
    // The secant of the slopes finds the foot of a smooth distance, the tangents that of a kink.
    const Place next = at(low.t + (step % 2 == 0 ? -low.slope / rise * width : crossing));
    if (next.slope < 0.0)
      low = next;
    else if (next.slope > 0.0)
      high = next;
    else
      return next.value;
  }
}

// Least signed distance [m] on a triangle with these columns as corners: in its plane, or on its edges.
template <class Body>
double distance_to_corners(const Body& body, const Eigen::Matrix3d& u) {
  const Eigen::Vector3d normal = (u.col(1) - u.col(0)).cross(u.col(2) - u.col(0));
  if (const double length = normal.norm(); length > 0.0) {
    const Foot foot = body.on_plane(normal / length, normal.dot(u.col(0)) / length);
    for (const Eigen::Vector3d& point : {foot.point, foot.section})
      if (foot_inside(u.colwise() - point, normal)) return foot.distance;
  }
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    least = std::min(least, distance_to_edge(body, u.col(i), u.col((i + 1) % 3) - u.col(i)));
  return least;
}

// A body in its pose, with the functions of Ball.
template <class Body>
struct Placed {
  static constexpr const char* kSizeName = Body::kSizeName;
  static constexpr bool kTurns = true;
  Body body;
  Eigen::Matrix3d axes;
  Eigen::Array3d box;  // [m] half the sides of a box around the body, along the axes of space

  double size() const { return body.size(); }
  double reach() const { return body.reach(); }
  Eigen::Vector3d own(const Eigen::Vector3d& point) const { return axes.transpose() * point; }

  std::optional<Depth> depth(const Eigen::Vector3d& point) const {
    auto found = body.depth(own(point));
    if (found) found->outward = axes * found->outward;
    return found;
  }

  SignedDistance signed_distance(const Eigen::Vector3d& point) const {
    const SignedDistance surface = body.signed_distance(own(point));
    return {surface.distance, axes * surface.normal};
  }

  double distance_to_triangle(const Eigen::Matrix3d& corners) const {
    return distance_to_corners(body, axes.transpose() * corners);
  }

  double distance_to_ball(const Eigen::Vector3d& point, double reach_of_ball) const {
    return less_rounding(body.signed_distance(own(point)).distance) - reach_of_ball;
  }

  double distance_to_box(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    const double apart = (low - box).max(-high - box).max(0.0).matrix().norm();
    const double ball = distance_to_ball(0.5 * (low + high), 0.5 * (high - low).matrix().norm());
    return apart > 0.0 ? std::max(less_rounding(apart), ball) : ball;
  }

  std::optional<Stretch> inside(const Eigen::Vector3d& start, const Eigen::Vector3d& step) const {
    const Eigen::Vector3d from = own(start), along = own(step);
    const Eigen::Array3d half = (1.0 + 1e-9) * body.box();
    Stretch found{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 3; ++i) {
      if (!(std::abs(along[i]) > 0.0)) {
        if (!(std::abs(from[i]) < half[i])) return std::nullopt;
        continue;
      }
      const double first = (-half[i] - from[i]) / along[i], second = (half[i] - from[i]) / along[i];
      found.begin = std::max(found.begin, std::min(first, second));
      found.end = std::min(found.end, std::max(first, second));
    }
    return found.begin <= found.end ? std::optional(found) : std::nullopt;
  }

 private:
  double less_rounding(double distance) const { return distance - 1e-12 * (std::abs(distance) + reach()); }
};

// Throws std::invalid_argument unless the axes are orthonormal and right-handed.
void require_axes(const Eigen::Matrix3d& axes);

// The body of a shape in the axes of space.
inline Ball place(const Sphere& sphere, const Eigen::Matrix3d&) {
  return body_of(sphere);
}
template <class Shape>
auto place(const Shape& shape, const Eigen::Matrix3d& axes) {
  require_axes(axes);
  const auto body = body_of(shape);
  return Placed<std::remove_const_t<decltype(body)>>{body, axes,
                                                     (axes.cwiseAbs() * body.box().matrix()).array()};
}

}  // namespace coupling::detail
