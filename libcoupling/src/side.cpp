// SPDX-License-Identifier: Apache-2.0
#include "coupling/side.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "check.hpp"
#include "distances.hpp"
#include "placed_body.hpp"

namespace coupling {
namespace {

using Eigen::Vector3d;

// Corners of one element relative to a point, as columns [m].
Eigen::Matrix3d corners_from(const Triangles& triangles, const Nodes& nodes, Eigen::Index element,
                             const Vector3d& point) {
  Eigen::Matrix3d u;
  for (int i = 0; i < 3; ++i) u.col(i) = nodes.col(triangles(i, element)) - point;
  return u;
}

// A sum of angles, each above -pi and up to pi, as the product of numbers with these arguments and the half
// turns that it passed. So one arc tangent serves any number of angles.
class Turn {
 public:
  void add(double cosine, double sine) {
    if (cosine == 0.0 && sine == 0.0) return;  // a corner, or an edge from its line
    const bool up = sine_ >= 0.0, adds_up = sine >= 0.0, back = cosine_ < 0.0 && cosine < 0.0;
    const double x = cosine_ * cosine - sine_ * sine, y = cosine_ * sine + sine_ * cosine;
    if (up == adds_up && (back || up != (y >= 0.0))) turns_ += up ? 1 : -1;
    const double scale = std::abs(x) + std::abs(y);
    cosine_ = x / scale;
    sine_ = y / scale + 0.0;  // never -0, of which the arc tangent is -pi
  }
  double in_turns() const { return turns_ + elementary::atan2(sine_, cosine_) / (2.0 * std::numbers::pi); }

 private:
  double cosine_ = 1.0, sine_ = 0.0;
  int turns_ = 0;
};

// Adds half the solid angle of a triangle seen from the origin.
void add_half_solid_angle(const Eigen::Matrix3d& u, Turn& turn) {
  const double a = u.col(0).norm(), b = u.col(1).norm(), c = u.col(2).norm();
  const double volume = u.col(0).dot(u.col(1).cross(u.col(2)));
  turn.add(a * b * c + u.col(0).dot(u.col(1)) * c + u.col(1).dot(u.col(2)) * a + u.col(2).dot(u.col(0)) * b,
           volume);
}

}  // namespace

double winding_number(const Triangles& triangles, const Nodes& nodes, const Vector3d& point) {
  detail::require_nodes("winding_number: triangles", triangles, nodes.cols());
  detail::require_finite("winding_number: point", point);
  Turn turn;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    add_half_solid_angle(corners_from(triangles, nodes, e, point), turn);
  const double winding = turn.in_turns();
  if (!std::isfinite(winding)) detail::reject("winding_number: nodes", "not a number", "finite");
  return winding;
}

double distance_to_triangle(const Vector3d& point, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Eigen::Matrix3d u;
  u << a - point, b - point, c - point;
  return detail::distance_from_origin(u);
}

Gap smallest_gap(const Triangles& triangles, const Nodes& nodes, const Impactor& impactor, const Pose& pose) {
  detail::require_nodes("smallest_gap: triangles", triangles, nodes.cols());
  detail::require_finite("smallest_gap: centre", pose.centre);
  require_valid(impactor);
  return std::visit(
      [&](const auto& shape) {
        const auto body = detail::place(shape, pose.axes);
        Gap gap{std::numeric_limits<double>::infinity(), -1};
        for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
          const Eigen::Matrix3d corners = corners_from(triangles, nodes, e, pose.centre);
          if (!corners.allFinite())
            detail::reject("smallest_gap: nodes of element " + std::to_string(e), "not finite", "finite");
          const double distance = body.distance_to_triangle(corners);
          if (distance < gap.distance) gap = {distance, static_cast<int>(e)};
        }
        return gap;
      },
      impactor);
}

void require_outside(const Triangles& triangles, const Nodes& nodes, const Impactor& impactor,
                     const Pose& pose) {
  detail::require_finite("impactor.centre", pose.centre);
  const Gap gap = smallest_gap(triangles, nodes, impactor, pose);
  if (gap.distance < -1e-9 * size_of(impactor))
    detail::reject("impactor",
                   "reaches " + detail::text(-gap.distance) + " m into the skin at element " +
                       std::to_string(gap.element),
                   "outside the skin at the start");
  const double winding = winding_number(triangles, nodes, pose.centre);
  if (std::abs(winding) > 0.5)
    detail::reject("impactor",
                   "a body whose centre, " + detail::text(pose.centre) + " m, lies inside the bag",
                   "outside the bag at the start");
}

bool path_meets_triangle(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end, double tolerance) {
  if (!start.allFinite() || !end.allFinite())
    detail::reject("path_meets_triangle: start and end", "not finite", "finite");
  detail::require_positive("path_meets_triangle: tolerance", tolerance);
  const Eigen::Matrix3d motion = end - start;
  const double largest = motion.colwise().norm().maxCoeff();
  constexpr double least = 1e-6;  // share of the step: with smaller advances rounding would stop the time
  for (double t = 0.0;;) {
    const double distance = detail::distance_from_origin(start + t * motion);
    if (!(distance > tolerance)) return true;
    t += std::max(least, distance / largest);
    if (!(t < 1.0)) return false;
  }
}

}  // namespace coupling
