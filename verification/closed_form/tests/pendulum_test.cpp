// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: elliptic integrals and Jacobi
// functions, and the explicit formulas.
#include "closed_form/pendulum.hpp"

#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kDegree;
using test::kIntegrated;

constexpr Pendulum kOtherPendulum{3.0, 0.4, 0.5, 0.9, 1.62};

std::vector<double> swing_rate(const Pendulum& p, const std::vector<double>& y, double force) {
  const double inertia = p.cg_inertia + p.mass * p.cg_arm * p.cg_arm;
  const double moment =
      force * p.impactor_arm * std::cos(y[0]) - p.mass * p.gravity * p.cg_arm * std::sin(y[0]);
  return {y[1], moment / inertia};
}

TEST(ClosedFormPendulum, constants_eq_reference) {
  const PendulumConstants c = pendulum_constants(paper_pendulum());
  expect_relative(c.axis_inertia, 14.4330525, kAlgebra);
  expect_relative(c.angular_frequency, 2.8084668044552369, kAlgebra);
  expect_relative(c.small_swing_period, 2.2372296860380184, kAlgebra);
  expect_relative(c.angular_acceleration_per_force, 0.090763890729282666, kAlgebra);
  expect_relative(c.cg_acceleration_per_force, 0.096663543626686039, kAlgebra);
  expect_relative(c.impactor_acceleration_per_force, 0.11890069685536029, kAlgebra);
  expect_relative(c.effective_mass, 8.4103796398811258, kAlgebra);
  expect_relative(c.centre_of_percussion, 1.2433176120945859, kAlgebra);
  expect_relative(c.pivot_impulse_ratio, -0.053632625530877824, 1e-13);  // a difference of 1 and 1.05
  Pendulum other = paper_pendulum();
  other.gravity = 9.81;
  expect_relative(pendulum_constants(other).small_swing_period, 2.236847659565174, kAlgebra);
  // A push at the centre of percussion leaves the pivot free.
  other.impactor_arm = c.centre_of_percussion;
  EXPECT_NEAR(pendulum_constants(other).pivot_impulse_ratio, 0.0, kAlgebra);
}

TEST(ClosedFormPendulum, period_eq_reference_and_standard_library) {
  struct Row {
    double degrees, period;
  };
  for (const Row& r : {Row{10, 2.2414965039688823}, Row{30, 2.2761771648179185}, Row{45, 2.3266592360880939},
                       Row{60, 2.4009546449164229}, Row{90, 2.6406930277547075}, Row{120, 3.0714490113661091},
                       Row{170, 5.4574146914688503}})
    expect_relative(pendulum_period(paper_pendulum(), r.degrees * kDegree), r.period, kAlgebra);
  const PendulumConstants c = pendulum_constants(kOtherPendulum);
  expect_relative(pendulum_period(kOtherPendulum, 0.0), c.small_swing_period, kAlgebra);
  for (const double amplitude : {1e-3, 0.7, 2.9})
    expect_relative(pendulum_period(kOtherPendulum, amplitude),
                    4 * std::comp_ellint_1(std::sin(amplitude / 2)) / c.angular_frequency, 1e-13);
}

TEST(ClosedFormPendulum, swing_eq_reference_and_period) {
  expect_relative(pendulum_swing(paper_pendulum(), 60 * kDegree, 0.3).angle, 0.74969713861709801, 1e-13);
  expect_relative(pendulum_swing(paper_pendulum(), 60 * kDegree, 1.0).angle, -0.91181648631676731, 1e-13);
  expect_relative(pendulum_swing(paper_pendulum(), 90 * kDegree, 0.3).angle, 1.2173406486533704, 1e-13);
  for (const double amplitude : {-1.0, 0.2, 2.5}) {
    const double T = pendulum_period(kOtherPendulum, std::abs(amplitude));
    expect_relative(pendulum_swing(kOtherPendulum, amplitude, 0.0).angle, amplitude, 1e-13);
    EXPECT_NEAR(pendulum_swing(kOtherPendulum, amplitude, T / 4).angle, 0.0, 1e-13);
    expect_relative(pendulum_swing(kOtherPendulum, amplitude, 7.5 * T).angle, -amplitude, 1e-12);
    const double k = std::sin(amplitude / 2);
    expect_relative(pendulum_swing(kOtherPendulum, amplitude, T / 4).angular_velocity,
                    -2 * k * pendulum_constants(kOtherPendulum).angular_frequency, 1e-13);
  }
}

TEST(ClosedFormPendulum, swing_eq_integrated_motion) {
  for (const Pendulum& p : {paper_pendulum(), kOtherPendulum})
    for (const double amplitude : {0.1, 1.5, 3.0}) {
      const test::Rate rate = [&p](double, const std::vector<double>& y) { return swing_rate(p, y, 0.0); };
      const std::vector<double> y = test::integrate_ode(rate, {amplitude, 0.0}, 0.0, 1.7);
      expect_relative(pendulum_swing(p, amplitude, 1.7).angle, y[0], 1e-10);  // sensitive near the top
      expect_relative(pendulum_swing(p, amplitude, 1.7).angular_velocity, y[1], 1e-10);
    }
}

TEST(ClosedFormPendulum, impulse_eq_reference_and_swing) {
  const ImpulseResponse r = pendulum_impulse(paper_pendulum(), 20.0);
  expect_relative(r.angular_velocity, 1.8152778145856533, kAlgebra);
  expect_relative(r.kinetic_energy, 23.780139371072058, kAlgebra);
  expect_relative(r.maximum_angle, 0.6581747325953754, kAlgebra);
  expect_relative(r.time_of_maximum, 0.5748373083340303, kAlgebra);
  const ImpulseResponse o = pendulum_impulse(kOtherPendulum, 1.1);
  expect_relative(o.time_of_maximum, pendulum_period(kOtherPendulum, o.maximum_angle) / 4, kAlgebra);
  expect_relative(
      o.kinetic_energy,
      kOtherPendulum.mass * kOtherPendulum.gravity * kOtherPendulum.cg_arm * (1 - std::cos(o.maximum_angle)),
      kAlgebra);
}

TEST(ClosedFormPendulum, constant_force_eq_reference_and_energy) {
  expect_relative(constant_force_maximum_angle(paper_pendulum(), 100.0), 1.7107363399699255, kAlgebra);
  for (const double force : {0.1, 2.0, 50.0}) {
    const double a = constant_force_maximum_angle(kOtherPendulum, force);
    expect_relative(force * kOtherPendulum.impactor_arm * std::sin(a),
                    kOtherPendulum.mass * kOtherPendulum.gravity * kOtherPendulum.cg_arm * (1 - std::cos(a)),
                    kAlgebra);
  }
}

TEST(ClosedFormPendulum, half_sine_eq_reference_and_nonlinear_pendulum) {
  const PendulumState s = half_sine_response(paper_pendulum(), 2000.0, 0.02, 0.02);
  expect_relative(s.angle, 0.023108070327049722, 1e-13);
  expect_relative(s.angular_velocity, 2.3101994521677704, 1e-13);
  // Angles of 1e-4 rad: the nonlinear terms are theta^2, 1e-8.
  for (const double t : {0.1, 0.3, 0.8}) {
    const double force = 1e-3;
    const double duration = 0.3;
    const test::Rate rate = [&](double time, const std::vector<double>& y) {
      return swing_rate(kOtherPendulum, y, time < duration ? force * std::sin(pi * time / duration) : 0.0);
    };
    std::vector<double> y = test::integrate_ode(rate, {0.0, 0.0}, 0.0, std::fmin(t, duration));
    if (t > duration) y = test::integrate_ode(rate, y, duration, t);
    const PendulumState linear = half_sine_response(kOtherPendulum, force, duration, t);
    expect_relative(linear.angle, y[0], 1e-7);
    expect_relative(linear.angular_velocity, y[1], 1e-7);
  }
}

TEST(ClosedFormPendulum, sphere_cut_eq_reference) {
  const SphereContact c = sphere_plane_cut(0.041, 0.01);
  expect_relative(c.patch_area, 0.0022619467105846511, kAlgebra);
  expect_relative(20000.0 * c.patch_area, 45.238934211693023, kAlgebra);
  expect_relative(c.cap_volume, 1.1833332328521555e-5, kAlgebra);
  const auto area = [](double d) { return sphere_plane_cut(0.7, d).patch_area; };
  expect_relative(sphere_plane_cut(0.7, 1.3).cap_volume, test::integrate(area, 0.0, 1.3), 1e-12);
  expect_relative(sphere_plane_cut(0.7, 1.4).cap_volume, 4.0 / 3.0 * pi * 0.343, kAlgebra);
}

TEST(ClosedFormPendulum, sphere_contact_eq_surface_quadrature) {
  for (const double radius : {0.041, 0.3})
    for (const double part : {0.05, 0.4, 0.9}) {
      const double depth = part * radius;
      const double h = radius - depth;
      const double kappa = 3e6;
      const SphereForce f = sphere_plane_contact(radius, depth, kappa);
      const double edge = std::sqrt(radius * radius - h * h);
      const auto energy = [&](double s) {
        return kappa / 2 * std::pow(radius - std::hypot(h, s), 2) * 2 * pi * s;
      };
      const auto force = [&](double s) { return kappa * (radius / std::hypot(h, s) - 1) * h * 2 * pi * s; };
      expect_relative(f.energy, test::integrate(energy, 0.0, edge), 1e-11);
      expect_relative(f.force, test::integrate(force, 0.0, edge), 1e-11);
    }
}

TEST(ClosedFormPendulum, sliding_sphere_eq_surface_quadrature_and_mu_times_force_when_shallow) {
  const double radius = 0.3, kappa = 3e6, mu = 0.4;
  for (const double part : {0.05, 0.4, 0.9}) {
    const double h = radius * (1.0 - part), edge = std::sqrt(radius * radius - h * h);
    const auto ring = [&](double s) {
      const double d = std::hypot(h, s);
      const auto along = [&](double angle) { return std::sqrt(1.0 - std::pow(s / d * std::cos(angle), 2)); };
      return mu * kappa * (radius - d) * s * test::integrate(along, 0.0, 2 * pi);
    };
    expect_relative(sphere_plane_sliding(radius, part * radius, kappa, mu), test::integrate(ring, 0.0, edge),
                    1e-10);
  }
  // Shallow: tractions lie in the plane to first order in depth / radius.
  const double shallow = 1e-6 * radius;
  expect_relative(sphere_plane_sliding(radius, shallow, kappa, mu),
                  mu * sphere_plane_contact(radius, shallow, kappa).force, 1e-5);
}

// Rings of the paraboloid: each is a spring that yields at mu times its pressure.
TEST(ClosedFormPendulum, sphere_that_sticks_and_slides_eq_rings_of_yielding_springs) {
  const double radius = 0.3, depth = 2e-4, kappa = 3e6, mu = 0.4, edge = std::sqrt(2 * radius * depth);
  for (const double part : {0.1, 0.6, 1.0, 1.7}) {
    const double u = part * mu * depth;
    const auto limit = [&](double s) { return mu * (depth - s * s / (2 * radius)); };
    const auto sum = [&](const auto& of_ring) {  // in two parts: the rings that stick, those that slide
      const auto ring = [&](double s) { return kappa * 2 * pi * s * of_ring(limit(s)); };
      const double border = part < 1.0 ? std::sqrt(2 * radius * (depth - u / mu)) : 0.0;
      return test::integrate(ring, 0.0, border) + test::integrate(ring, border, edge);
    };
    const SphereSlip s = sphere_plane_slip(radius, depth, kappa, mu, u);
    expect_relative(s.force, sum([&](double most) { return std::min(u, most); }), 1e-10);
    expect_relative(s.energy, sum([&](double most) { return std::pow(std::min(u, most), 2) / 2; }), 1e-10);
    expect_relative(s.loss, sum([&](double most) { return most * std::max(0.0, u - most); }), 1e-10);
    expect_relative(sphere_plane_slip_cycle(radius, depth, kappa, mu, u),
                    sum([&](double most) { return 4 * most * std::max(0.0, u - most); }), 1e-10);
  }
  expect_relative(sphere_plane_slip(radius, 1e-7 * radius, kappa, mu, 1.0).force,
                  sphere_plane_sliding(radius, 1e-7 * radius, kappa, mu), 1e-6);
  expect_refused([] { sphere_plane_slip(0.041, 0.01, 1e6, 0.0, 1e-3); }, "friction");
}

TEST(ClosedFormPendulum, penalty_bounce_eq_reference_and_energy) {
  const PenaltyBounce b = penalty_bounce(8.4103796398811258, 1e5, 5.0);
  expect_relative(b.maximum_penetration, 0.045854060997585388, kAlgebra);
  expect_relative(b.duration, 0.028810956233454504, kAlgebra);
  expect_relative(b.critical_time_step, 0.018341624399034155, kAlgebra);
  const PenaltyBounce o = penalty_bounce(2.0, 3e4, 7.0);
  expect_relative(0.5 * 3e4 * o.maximum_penetration * o.maximum_penetration, 0.5 * 2.0 * 49.0, kAlgebra);
  expect_relative(o.maximum_force, 3e4 * o.maximum_penetration, kAlgebra);
}

TEST(ClosedFormPendulum, bad_parameters_are_refused_by_name) {
  expect_refused([] { pendulum_constants({}); }, "mass");
  expect_refused([] { pendulum_period(kOtherPendulum, pi); }, "amplitude");
  expect_refused([] { pendulum_impulse(kOtherPendulum, 1e3); }, "impulse");
  expect_refused([] { sphere_plane_contact(0.041, 0.05, 1e6); }, "depth");
  expect_refused([] { sphere_plane_sliding(0.041, 0.01, 1e6, -0.1); }, "friction");
  const double resonance = pi / pendulum_constants(kOtherPendulum).angular_frequency;
  expect_refused([&] { half_sine_response(kOtherPendulum, 1.0, resonance, 0.1); }, "duration");
}

}  // namespace
