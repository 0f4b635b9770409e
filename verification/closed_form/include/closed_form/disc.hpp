// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/membrane.hpp"

// Flat discs and rings of fabric, exact where a Foeppl theory is not: pressure follows the surface, strains
// are those of Green and Lagrange. All functions throw std::invalid_argument naming the field when a
// parameter is missing or out of validity.
namespace closed_form {

/// Shape of one disc under pressure.
struct InflatedDisc {
  double centre_stretch = 0.0;     // [-] in every direction
  double centre_deflection = 0.0;  // [m] above the plane of the edge
  double edge_radius = 0.0;        // [m]
  double volume = 0.0;             // [m3] between the disc and the plane of its edge
};
/// Clamped edge, fabric that carries compression (none occurs). With T1 = h l1 S1 along the meridian, T2 = h
/// l2 S2 across, s the radius in the flat disc, x and z of the point: s T1 sin(phi) = -p x^2/2, d(s T1
/// cos(phi))/ds = T2 + p x z', x' = l1 cos(phi), z' = l1 sin(phi), integrated from the centre; the centre's
/// stretch is shot at x(a) = a. Needs 1e-6 <= p a/(E h) <= 0.2, nu >= 0. Source: derived here.
InflatedDisc clamped_disc(const CircularMembrane& membrane);

/// Half of a balloon of two discs sewn at the edge, fabric without compression (where S2 would be < 0, S2 = 0
/// and S1 = E E1); the edge moves freely with its tangent vertical. Tends to the Mylar balloon for p a/(E h)
/// -> 0. Same range and source.
InflatedDisc sealed_disc(const CircularMembrane& membrane);

/// Ring of fabric without compression whose inner edge is turned by a small angle against the outer one: the
/// fabric wrinkles along straight rays, tangents of a circle.
struct TwistedRing {
  Sheet sheet;  // Poisson's ratio decides only whether the ring is wrinkled up to its edges
  double inner_radius = kRequired;  // a [m] > 0
  double outer_radius = kRequired;  // b [m] > a
};
/// What the turn does.
struct RingTwist {
  double ray_radius = 0.0;     // c [m] of the circle that the rays touch
  double torque = 0.0;         // [N m] 2 pi c A h
  double strain_energy = 0.0;  // [J] torque * angle / 2
  double margin = 0.0;         // [-] c^2/(b^2 - c^2) - nu, >= 0 where the outer edge is wrinkled
};
/// Uniaxial stress A/sqrt(r^2 - c^2) along the rays, A = E c angle/L, L = ln((b^2 - c^2)/(a^2 - c^2))/2; c
/// from the greatest c^2/L, 2 L = c^2 (b^2 - a^2)/((a^2 - c^2)(b^2 - c^2)) (M.16). Angle [rad] of
/// magnitude up to 0.1, strains of its size neglected. Refused where the outer edge would be taut (margin <
/// 0: b/a > 1.745 for nu = 0.3). Source: E. Reissner, On tension field theory, Proc. 5th Int. Congr. Appl.
/// Mech. (1938) for the rays; c derived here from the complementary energy.
RingTwist twisted_ring(const TwistedRing& ring, double angle);

}  // namespace closed_form
