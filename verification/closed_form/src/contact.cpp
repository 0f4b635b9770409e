// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/pendulum.hpp"
#include "quadrature.hpp"

namespace closed_form {

using std::numbers::pi;

SphereContact sphere_plane_cut(double radius, double depth) {
  check::positive("radius", radius);
  check::within("depth", depth, 0.0, 2.0 * radius);
  return {pi * depth * (2.0 * radius - depth), pi * depth * depth * (radius - depth / 3.0)};
}

SphereForce sphere_plane_contact(double radius, double depth, double stiffness) {
  check::positive("radius", radius);
  check::within("depth", depth, 0.0, radius);
  check::positive("stiffness", stiffness);
  const double square = pi * stiffness * depth * depth;
  return {square * (radius - depth), square * depth * (radius / 3.0 - 0.25 * depth)};
}

double sphere_plane_sliding(double radius, double depth, double stiffness, double friction) {
  check::positive("radius", radius);
  check::within("depth", depth, 0.0, radius * (1.0 - 1e-9));
  check::positive("stiffness", stiffness);
  check::non_negative("friction", friction);
  const double height = radius - depth;
  const auto ring = [&](double distance) {
    const double modulus = std::sqrt(std::fmax(0.0, 1.0 - std::pow(height / distance, 2)));
    return (radius - distance) * distance * gsl_sf_ellint_Ecomp(modulus, GSL_PREC_DOUBLE);
  };
  return 4.0 * friction * stiffness * quadrature::integrate(ring, height, radius, 8);
}

SphereSlip sphere_plane_slip(double radius, double depth, double stiffness, double friction,
                             double displacement) {
  check::positive("radius", radius);
  check::positive("depth", depth);
  check::positive("stiffness", stiffness);
  check::positive("friction", friction);
  check::non_negative("displacement", displacement);
  const double factor = 2.0 * pi * radius * stiffness;
  const double u = std::fmin(displacement, friction * depth), rest = displacement - u;  // rest: all slides
  SphereSlip s;
  s.force = factor * (u * depth - u * u / (2.0 * friction));
  s.energy = factor * (u * u * depth / 2.0 - u * u * u / (3.0 * friction));
  s.loss = factor * u * u * u / (6.0 * friction) + s.force * rest;
  return s;
}

double sphere_plane_slip_cycle(double radius, double depth, double stiffness, double friction,
                               double amplitude) {
  const SphereSlip whole = sphere_plane_slip(radius, depth, stiffness, friction, amplitude);
  const double u = std::fmin(amplitude, friction * depth);
  return 4.0 * pi * radius * stiffness * u * u * u / (3.0 * friction) + 4.0 * whole.force * (amplitude - u);
}

PenaltyBounce penalty_bounce(double mass, double stiffness, double speed) {
  check::positive("mass", mass);
  check::positive("stiffness", stiffness);
  check::positive("speed", speed);
  const double inverse_frequency = std::sqrt(mass / stiffness);
  return {speed * inverse_frequency, pi * inverse_frequency, speed * std::sqrt(mass * stiffness),
          2.0 * inverse_frequency};
}

}  // namespace closed_form
