// SPDX-License-Identifier: Apache-2.0
#include "closed_form/occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "check.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;
using Polygon = std::vector<Point2>;

double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) twice += cross(polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * twice;
}

// Part of the polygon on the left of the line a -> b (Sutherland-Hodgman).
Polygon clip(const Polygon& polygon, const Point2& a, const Point2& b) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    const double side_p = cross(a, b, p);
    const double side_q = cross(a, b, q);
    if (side_p >= 0.0) kept.push_back(p);
    if (side_p * side_q < 0.0) {
      const double t = side_p / (side_p - side_q);
      kept.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
  }
  return kept;
}

Polygon counterclockwise(const Triangle2& triangle, double scale, const char* name) {
  Polygon polygon;
  for (const Point2& p : triangle)
    polygon.push_back({scale * check::finite(name, p[0]), scale * check::finite(name, p[1])});
  if (area(polygon) == 0.0) check::refuse(name, 0.0, "its area must not be 0");
  if (area(polygon) < 0.0) std::swap(polygon[1], polygon[2]);
  return polygon;
}

void check_distances(double occluder, double target) {
  check::positive("occluder_distance", occluder);
  if (!(std::isfinite(target) && target > occluder))
    check::refuse("target_distance", target, "must be finite and > occluder_distance");
}

// Half angle of the cone from a point at `distance` around a sphere, by its tangent: digits are left where
// the sphere is next to the point.
double cone_half_angle(const char* name, double distance, double radius) {
  check::positive("sphere_radius", radius);
  if (!(std::isfinite(distance) && distance > radius))
    check::refuse(name, distance, "must be finite and > the radius inside");
  return std::atan2(radius, std::sqrt(distance - radius) * std::sqrt(distance + radius));
}

}  // namespace

double hidden_triangle_fraction(const Triangle2& occluder, double occluder_distance, const Triangle2& target,
                                double target_distance) {
  check_distances(occluder_distance, target_distance);
  const Polygon whole = counterclockwise(target, 1.0, "target");
  const Polygon shadow = counterclockwise(occluder, target_distance / occluder_distance, "occluder");
  Polygon overlap = whole;
  for (std::size_t i = 0; i < 3 && !overlap.empty(); ++i)
    overlap = clip(overlap, shadow[i], shadow[(i + 1) % 3]);
  return area(overlap) / area(whole);
}

double circle_overlap_area(double r1, double r2, double distance) {
  check::positive("r1", r1, "r2", r2);
  const double d = check::non_negative("distance", distance);
  if (d >= r1 + r2) return 0.0;
  if (d <= std::abs(r1 - r2)) return pi * std::min(r1, r2) * std::min(r1, r2);
  // Heron's product in factored form; each circle gives sector minus triangle.
  const double product = (r1 + r2 - d) * (d + r1 - r2) * (d - r1 + r2) * (d + r1 + r2);
  const double root = std::sqrt(product);
  const double half1 = std::atan2(root, d * d + (r1 - r2) * (r1 + r2));
  const double half2 = std::atan2(root, d * d - (r1 - r2) * (r1 + r2));
  return r1 * r1 * half1 + r2 * r2 * half2 - 0.5 * root;
}

double hidden_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                            double target_distance, double offset) {
  check_distances(occluder_distance, target_distance);
  check::positive("occluder_radius", occluder_radius, "target_radius", target_radius);
  const double scale = target_distance / occluder_distance;
  return circle_overlap_area(scale * occluder_radius, target_radius,
                             scale * check::non_negative("offset", offset)) /
         (pi * target_radius * target_radius);
}

double hidden_coaxial_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                                    double target_distance) {
  check_distances(occluder_distance, target_distance);
  const double ratio = check::positive("occluder_radius", occluder_radius) * target_distance /
                       (occluder_distance * check::positive("target_radius", target_radius));
  return std::min(1.0, ratio * ratio);
}

double sphere_shadow_half_angle(double sphere_radius, double source_distance, double shell_radius) {
  const double at_source = cone_half_angle("source_distance", source_distance, sphere_radius);
  if (!(std::isfinite(shell_radius) && shell_radius > source_distance))
    check::refuse("shell_radius", shell_radius, "must be finite and > source_distance");
  return at_source + cone_half_angle("shell_radius", shell_radius, sphere_radius);
}

double visible_sphere_fraction(double sphere_radius, double source_distance) {
  cone_half_angle("source_distance", source_distance, sphere_radius);
  return 0.5 * (source_distance - sphere_radius) / source_distance;
}

double sphere_solid_angle(double sphere_radius, double source_distance) {
  const double sine_half = std::sin(0.5 * cone_half_angle("source_distance", source_distance, sphere_radius));
  return 4.0 * pi * sine_half * sine_half;
}

double triangle_solid_angle(const Point3& a, const Point3& b, const Point3& c) {
  for (const Point3& p : {a, b, c})
    for (const double x : p) check::finite("corner", x);
  const auto dot = [](const Point3& p, const Point3& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
  const double la = std::sqrt(dot(a, a));
  const double lb = std::sqrt(dot(b, b));
  const double lc = std::sqrt(dot(c, c));
  const double triple = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0]);
  return 2.0 * std::atan2(std::abs(triple), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

int icosahedron_visible_faces(double distance_ratio) {
  check::non_negative("distance_ratio", distance_ratio);
  if (distance_ratio == 1.0) check::refuse("distance_ratio", 1.0, "must not be 1, a vertex");
  if (distance_ratio < 1.0) return 20;
  return distance_ratio <= 2.0 + std::sqrt(5.0) ? 5 : 10;
}

}  // namespace closed_form
