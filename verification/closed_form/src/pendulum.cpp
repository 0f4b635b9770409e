// SPDX-License-Identifier: Apache-2.0
#include "closed_form/pendulum.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cancellation.hpp"
#include "check.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

// The arithmetic-geometric mean of 1 and k' = sqrt(1 - k^2), with what Jacobi's functions need of its steps.
struct Means {
  std::vector<double> ratios;  // c/a of each step, c half the difference of the last means
  double mean = 1.0;
};

Means means_of(double complementary_modulus) {
  Means m;
  double b = complementary_modulus;
  for (int i = 0; i < 40 && std::abs(m.mean - b) > 1e-16 * m.mean; ++i) {
    const double half = 0.5 * (m.mean - b), next = 0.5 * (m.mean + b);
    b = std::sqrt(m.mean * b);
    m.mean = next;
    m.ratios.push_back(half / next);
  }
  return m;
}

// Complete elliptic integral K(k).
double complete_elliptic(double complementary_modulus) {
  return 0.5 * pi / means_of(complementary_modulus).mean;
}

// Jacobi's amplitude am(u, k): phi_N = 2^N a_N u, sin(2 phi_(n-1) - phi_n) = c_n/a_n sin phi_n.
double jacobi_amplitude(const Means& means, double u) {
  double phi = std::ldexp(means.mean * u, static_cast<int>(means.ratios.size()));
  for (std::size_t n = means.ratios.size(); n-- > 0;)
    phi = 0.5 * (phi + std::asin(means.ratios[n] * std::sin(phi)));
  return phi;
}

double check_amplitude(double amplitude) {
  if (!(std::abs(amplitude) < pi)) check::refuse("amplitude", amplitude, "must lie in (-pi, pi)");
  return amplitude;
}

}  // namespace

Pendulum paper_pendulum() {
  Pendulum pendulum;
  pendulum.mass = 10.9;
  pendulum.cg_inertia = 2.07;
  pendulum.cg_arm = 1.065;
  pendulum.impactor_arm = 1.310;
  return pendulum;
}

PendulumConstants pendulum_constants(const Pendulum& pendulum) {
  const double m = check::positive("mass", pendulum.mass);
  const double arm = check::positive("cg_arm", pendulum.cg_arm);
  const double impactor = check::positive("impactor_arm", pendulum.impactor_arm);
  PendulumConstants constants;
  const double inertia = check::non_negative("cg_inertia", pendulum.cg_inertia) + m * arm * arm;
  constants.axis_inertia = inertia;
  constants.angular_frequency = std::sqrt(m * check::positive("gravity", pendulum.gravity) * arm / inertia);
  constants.small_swing_period = 2.0 * pi / constants.angular_frequency;
  constants.angular_acceleration_per_force = impactor / inertia;
  constants.cg_acceleration_per_force = arm * impactor / inertia;
  constants.impactor_acceleration_per_force = impactor * impactor / inertia;
  constants.effective_mass = inertia / (impactor * impactor);
  constants.centre_of_percussion = inertia / (m * arm);
  // 1 - m L L_i/I_O, whose terms cancel near the centre of percussion.
  constants.pivot_impulse_ratio = (pendulum.cg_inertia + m * arm * (arm - impactor)) / inertia;
  return constants;
}

double pendulum_period(const Pendulum& pendulum, double amplitude) {
  check::from_below("amplitude", amplitude, 0.0, pi);
  return 4.0 * complete_elliptic(std::cos(0.5 * amplitude)) / pendulum_constants(pendulum).angular_frequency;
}

PendulumState pendulum_swing(const Pendulum& pendulum, double amplitude, double time) {
  check_amplitude(amplitude);
  check::finite("time", time);
  const double omega0 = pendulum_constants(pendulum).angular_frequency;
  const double k = std::sin(0.5 * amplitude), rest = std::cos(0.5 * amplitude);  // k, k'
  const Means means = means_of(rest);
  const double quarter = 0.5 * pi / means.mean;
  const double v = std::remainder(omega0 * time, 4.0 * quarter), after = std::abs(v);
  // From the turn, or from the bottom if that is nearer: k sn = sin(angle/2), so that both keep their digits.
  const double bottom = quarter - after, turn = std::min(after, 2.0 * quarter - after);
  const bool near_bottom = std::abs(bottom) < turn;
  const double phi = jacobi_amplitude(means, near_bottom ? bottom : turn);
  const double sn = std::sin(phi), cn = std::cos(phi), dn = std::hypot(rest, k * cn);
  const double half =
      near_bottom ? std::atan2(k * sn, dn) : std::copysign(1.0, bottom) * std::atan2(k * cn, rest);
  const double speed = 2.0 * k * omega0 * (near_bottom ? cn : rest * sn / dn);
  return {2.0 * half, v < 0.0 ? speed : -speed};
}

ImpulseResponse pendulum_impulse(const Pendulum& pendulum, double impulse) {
  const PendulumConstants constants = pendulum_constants(pendulum);
  check::positive("impulse", impulse);
  const double omega = impulse * constants.angular_acceleration_per_force;
  const double k = 0.5 * omega / constants.angular_frequency;
  if (k >= 1.0) check::refuse("impulse", impulse, "would carry the pendulum over the top");
  const double quarter = complete_elliptic(std::sqrt((1.0 - k) * (1.0 + k)));
  return {omega, 0.5 * impulse * impulse / constants.effective_mass, 2.0 * std::asin(k),
          quarter / constants.angular_frequency};
}

double constant_force_maximum_angle(const Pendulum& pendulum, double force) {
  pendulum_constants(pendulum);
  check::non_negative("force", force);
  return 2.0 * std::atan2(force * pendulum.impactor_arm, pendulum.mass * pendulum.gravity * pendulum.cg_arm);
}

PendulumState half_sine_response(const Pendulum& pendulum, double force, double duration, double time) {
  const PendulumConstants constants = pendulum_constants(pendulum);
  check::finite("force", force);
  check::positive("duration", duration);
  check::non_negative("time", time);
  const double w = constants.angular_frequency;
  const double forcing = pi / duration;
  if (std::abs(forcing / w - 1.0) < 1e-6)
    check::refuse("duration", duration, "pi/duration must differ from omega0 (resonance)");
  const double amplitude = force * constants.angular_acceleration_per_force / ((w - forcing) * (w + forcing));
  const double t = std::fmin(time, duration);
  // sin(f t) - f/w sin(w t) and cos(f t) - cos(w t), whose terms cancel for small t.
  const double angle = amplitude * forcing * t * (sinc_defect(w * t) - sinc_defect(forcing * t));
  const double velocity =
      2.0 * amplitude * forcing * std::sin(0.5 * (w + forcing) * t) * std::sin(0.5 * (w - forcing) * t);
  const double phase = w * (time - t);
  return {angle * std::cos(phase) + velocity / w * std::sin(phase),
          velocity * std::cos(phase) - w * angle * std::sin(phase)};
}

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
  check::positive("radius", radius, "depth", depth, "stiffness", stiffness, "friction", friction);
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
  check::positive("mass", mass, "stiffness", stiffness, "speed", speed);
  const double inverse_frequency = std::sqrt(mass / stiffness);
  return {speed * inverse_frequency, pi * inverse_frequency, speed * std::sqrt(mass * stiffness),
          2.0 * inverse_frequency};
}

}  // namespace closed_form
