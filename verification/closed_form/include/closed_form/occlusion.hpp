// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "closed_form/common.hpp"

/// Closed forms of shadows of a point source. All functions throw std::invalid_argument, naming the field,
/// for a parameter that is missing or out of validity.
namespace closed_form {

using Point2 = std::array<double, 2>;     // [m] in a plane
using Point3 = std::array<double, 3>;     // [m]
using Triangle2 = std::array<Point2, 3>;  // corners, in either order

/// Fraction [-] of the target that the occluder hides. The source is at the distances occluder_distance and
/// target_distance > occluder_distance [m] from two parallel planes. Coordinates [m] in those planes count
/// from the source's foot. The shadow is the occluder scaled by the ratio of distances; the overlap is found
/// by clipping (exact for rational data to round-off). Source: derived here.
double hidden_triangle_fraction(const Triangle2& occluder, double occluder_distance, const Triangle2& target,
                                double target_distance);

/// Fraction [-] of a disc r2 at z2 that a coaxial disc r1 at z1 hides, z2 > z1 > 0 [m]: min(1, (r1 z2/(z1
/// r2))^2).
double hidden_coaxial_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                                    double target_distance);
/// The same with the occluder's axis at `offset` [m] >= 0: the lens of shadow and target over the target's
/// area.
double hidden_disc_fraction(double occluder_radius, double occluder_distance, double target_radius,
                            double target_distance, double offset);

/// Area [m2] of the lens common to circles of radius r1, r2 [m] with centres `distance` [m] apart.
double circle_overlap_area(double r1, double r2, double distance);

/// Half angle [rad] of the shadow that an opaque sphere r casts on a concentric shell R > D, seen from the
/// centre: asin(r/D) + asin(r/R). The source is at distance D > r from the centre [m].
double sphere_shadow_half_angle(double sphere_radius, double source_distance, double shell_radius);
/// Fraction [-] of a sphere's surface that is visible from distance D, (1 - r/D)/2.
double visible_sphere_fraction(double sphere_radius, double source_distance);
/// Solid angle [sr] of a sphere seen from distance D > r: 2 pi (1 - sqrt(1 - (r/D)^2)).
double sphere_solid_angle(double sphere_radius, double source_distance);

/// Solid angle [sr], positive, of triangle abc seen from the origin.
/// Source: A. van Oosterom and J. Strackee (1983).
double triangle_solid_angle(const Point3& a, const Point3& b, const Point3& c);

/// Number of faces of the regular icosahedron that a point on a vertex axis sees. It is distance_ratio
/// circumradii (>= 0, not 1) from the centre: all 20 from inside, 5 from outside up to 2 + sqrt 5, 10 beyond.
/// Source: derived here (face planes).
int icosahedron_visible_faces(double distance_ratio);

}  // namespace closed_form
