// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/membrane.hpp"

/// Flat discs and rings of fabric, exact where a Foeppl theory is not: the pressure follows the surface, and
/// strains are those of Green and Lagrange. All functions throw std::invalid_argument, naming the field, for
/// a parameter that is missing or out of validity.
namespace closed_form {

/// Shape of one disc under pressure.
struct InflatedDisc {
  double centre_stretch = 0.0;     // [-] in every direction
  double centre_deflection = 0.0;  // [m] above the plane of the edge
  double edge_radius = 0.0;        // [m]
  double volume = 0.0;             // [m3] between the disc and the plane of its edge
};
/// Disc with a clamped edge, of fabric that carries compression (none occurs). T1 = h l1 S1 acts along the
/// meridian and T2 = h l2 S2 across; s is the radius in the flat disc; x and z are the place of the point.
/// From the centre it integrates
///   s T1 sin(phi) = -p x^2/2, d(s T1 cos(phi))/ds = T2 + p x z', x' = l1 cos(phi), z' = l1 sin(phi),
/// with the centre's stretch such that x(a) = a (shooting). Needs 1e-6 <= p a/(E h) <= 0.2 and nu >= 0.
/// Source: derived here.
InflatedDisc clamped_disc(const CircularMembrane& membrane);

/// Half of a balloon of two discs sewn at the edge, of fabric without compression: where S2 would be < 0,
/// S2 = 0 and S1 = E E1. The edge moves freely and its tangent is vertical. Tends to the Mylar balloon for p
/// a/(E h) -> 0. Same range and source.
InflatedDisc sealed_disc(const CircularMembrane& membrane);

/// Ring of fabric without compression. Its inner edge is turned by a small angle against the outer one. The
/// fabric wrinkles along straight rays, which are tangents of a circle.
struct TwistedRing {
  /// Poisson's ratio only decides whether the ring is wrinkled up to its edges.
  Sheet sheet;
  double inner_radius = kRequired;  // a [m] > 0
  double outer_radius = kRequired;  // b [m] > a
};
/// State of the twisted ring.
struct RingTwist {
  double ray_radius = 0.0;     // [m] c, radius of the circle that the rays touch
  double torque = 0.0;         // [N m] 2 pi c A h
  double strain_energy = 0.0;  // [J] torque * angle / 2
  /// [-] c^2/(b^2 - c^2) - nu; >= 0 if the outer edge is wrinkled.
  double margin = 0.0;
};
/// Uniaxial stress A/sqrt(r^2 - c^2) along the rays, A = E c angle/L, L = ln((b^2 - c^2)/(a^2 - c^2))/2. c
/// makes c^2/L greatest: 2 L = c^2 (b^2 - a^2)/((a^2 - c^2)(b^2 - c^2)) (M.16). |angle| <= 0.1 [rad]; strains
/// of its size are neglected. Refused where the outer edge would be taut (margin < 0: b/a > 1.745 for
/// nu = 0.3). Source: E. Reissner, On tension field theory, Proc. 5th Int. Congr. Appl. Mech. (1938) for the
/// rays; c derived here from the complementary energy.
RingTwist twisted_ring(const TwistedRing& ring, double angle);

}  // namespace closed_form
