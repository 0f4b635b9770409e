// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "closed_form/common.hpp"

// Closed forms of point-source shadows.
// All functions throw std::invalid_argument naming the field when a parameter is missing or out of validity.
namespace closed_form {

using Point2 = std::array<double, 2>;     // [m] in a plane
using Point3 = std::array<double, 3>;     // [m]
using Triangle2 = std::array<Point2, 3>;  // corners, in either order

/// Fraction of target hidden by occluder, a source at distance occluder_distance and target_distance > it [m]
/// from two parallel planes; coordinates [m] in those planes about the source's foot. The shadow is the
/// occluder scaled by the ratio of distances; overlap by clipping (exact for rational data to round-off).
/// Source: derived here.
double hidden_triangle_fraction(const Triangle2& occluder, double occluder_distance, const Triangle2& target,
                                double target_distance);

/// Coaxial discs r1 at z1 in front of r2 at z2 (> z1 > 0): min(1, (r1 z2/(z1 r2))^2).
double hidden_coaxial_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                                    double target_distance);
/// The same with the occluder's axis offset [m] >= 0: lens area of shadow and target over the target's.
double hidden_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                            double target_distance, double offset);

/// Area [m2] of the lens common to circles r1, r2 at centre distance d.
double circle_overlap_area(double r1, double r2, double distance);

/// Opaque sphere r between a source at distance D (> r) from its centre and a concentric shell R (> D): half
/// angle [rad] of the shadow cap on the shell seen from the centre, asin(r/D) + asin(r/R).
double sphere_shadow_half_angle(double sphere_radius, double source_distance, double shell_radius);
/// Fraction of a sphere's surface visible from outside, (1 - r/D)/2.
double visible_sphere_fraction(double sphere_radius, double source_distance);
/// Solid angle [sr] of a sphere seen from distance D > r: 2 pi (1 - sqrt(1 - (r/D)^2)).
double sphere_solid_angle(double sphere_radius, double source_distance);

/// Solid angle [sr], positive, of triangle abc seen from the origin.
/// Source: A. van Oosterom and J. Strackee (1983).
double triangle_solid_angle(const Point3& a, const Point3& b, const Point3& c);

/// Faces of the regular icosahedron that a point on a vertex axis sees, distance_ratio circumradii (>= 0, not
/// 1) from the centre: all 20 from inside, 5 from outside up to 2 + sqrt 5, 10 beyond. Source: derived here
/// (face planes).
int icosahedron_visible_faces(double distance_ratio);

}  // namespace closed_form
