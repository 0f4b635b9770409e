// SPDX-License-Identifier: Apache-2.0
#include "closed_form/disc.hpp"

#include "check.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kIntegrated;

CircularMembrane disc(double q, double poisson_ratio = 0.3, double radius = 0.5) {
  return {{1e6, poisson_ratio, 1e-3}, radius, q * 1e3 / radius};
}

// Digits of a Chebyshev collocation of the same equations with 40 digits, equal at degrees 16 and 22.
TEST(ClosedFormDisc, clamped_disc_eq_reference) {
  struct Row {
    double poisson_ratio, q, centre_stretch, height, volume;
  };
  for (const Row& r : {
           Row{0.0, 1e-6, 1.00004051139665755, 0.00718328253272954837, 0.0119092608141016092},
           Row{0.0, 0.2, 1.15086267778173395, 0.438622848509894687, 0.787933321315433},
           Row{0.3, 1e-4, 1.00065051184717671, 0.0303361483828270028, 0.0497090786073723572},
           Row{0.3, 0.01, 1.01417596787496043, 0.141384569509217491, 0.233564857461908479},
           Row{0.45, 0.08, 1.04830435256701234, 0.266985112911799817, 0.447661209823547428},
           Row{0.5, 1e-6, 1.00002306697050188, 0.0059488281832616135, 0.00965183894283522122},
           Row{0.5, 0.2, 1.08533758584717403, 0.356182001635139462, 0.609808186180030243},
       }) {
    SCOPED_TRACE(r.q);
    const InflatedDisc d = clamped_disc(disc(r.q, r.poisson_ratio));
    expect_relative(d.centre_stretch - 1.0, r.centre_stretch - 1.0, kIntegrated);
    expect_relative(d.centre_deflection, 0.5 * r.height, kIntegrated);
    expect_relative(d.volume, 0.125 * r.volume, kIntegrated);
    expect_relative(d.edge_radius, 0.5, kIntegrated);
  }
}

// Hencky's membrane leaves out terms of the strain's size, q^(2/3).
TEST(ClosedFormDisc, clamped_disc_tends_to_hencky) {
  for (const double nu : {0.1, 0.3, 0.5}) {
    std::vector<double> excess;
    for (const double q : {1e-3, 1e-4, 1e-5})
      excess.push_back(clamped_disc(disc(q, nu)).volume / hencky_membrane(disc(q, nu)).volume - 1.0);
    for (int i = 0; i < 2; ++i) {
      EXPECT_GT(std::log10(excess[i] / excess[i + 1]), 0.64) << nu;
      EXPECT_LT(std::log10(excess[i] / excess[i + 1]), 0.70) << nu;
    }
  }
}

// Its elastic terms are q log q for the balloon without hoop tension: 10 q bounds them in this range.
TEST(ClosedFormDisc, sealed_discs_tend_to_mylar_balloon) {
  const MylarBalloon mylar = mylar_balloon(0.5);
  for (const double q : {1e-6, 1e-5, 1e-4}) {
    const InflatedDisc d = sealed_disc(disc(q));
    EXPECT_NEAR(2.0 * d.volume, mylar.volume, 10.0 * q * mylar.volume);
    EXPECT_NEAR(d.edge_radius, mylar.equator_radius, 10.0 * q * mylar.equator_radius);
    EXPECT_GT(d.volume, 0.5 * mylar.volume);
  }
  // The strain at the pole falls slower than the pressure, that of the meridian with it.
  EXPECT_NEAR(2.0 * sealed_disc(disc(1e-6)).centre_deflection, mylar.thickness, 1e-4 * mylar.thickness);
}

TEST(ClosedFormDisc, inflated_discs_scale_with_their_radius) {
  const InflatedDisc small = sealed_disc(disc(0.02, 0.2, 0.1)), large = sealed_disc(disc(0.02, 0.2, 1.0));
  expect_relative(10.0 * small.centre_deflection, large.centre_deflection, kIntegrated);
  expect_relative(10.0 * small.edge_radius, large.edge_radius, kIntegrated);
  expect_relative(1000.0 * small.volume, large.volume, kIntegrated);
  EXPECT_NE(sealed_disc(disc(0.02, 0.3, 1.0)).volume, large.volume);
}

// The displacements that the stress on the rays entails, integrated from the turned edge, vanish at the other
// one; and the strain across the rays never pulls.
TEST(ClosedFormDisc, twisted_ring_is_compatible) {
  for (const double b : {0.11, 0.13, 0.15}) {
    const Sheet sheet{2e8, 0.3, 1e-3};
    const double a = 0.1, angle = 0.01;
    const RingTwist twist = twisted_ring({sheet, a, b}, angle);
    const double c = twist.ray_radius;
    const double stress = twist.torque / (2.0 * M_PI * c * sheet.thickness);  // times sqrt(r^2 - c^2)
    const auto rates = [&](double r, const std::vector<double>& y) {          // y: u_r, u_theta / r
      const double sine = c / r, cosine = std::sqrt(1.0 - sine * sine);
      const double along = stress / (sheet.young_modulus * r * cosine);
      const double across = (y[0] / r - along * sine * sine) / (cosine * cosine);
      EXPECT_LE(across, -sheet.poisson_ratio * along);
      return std::vector<double>{along * cosine * cosine + across * sine * sine,
                                 2.0 * (along - across) * sine * cosine / r};
    };
    const std::vector<double> end = test::integrate_ode(rates, {0.0, -angle}, a, b);
    EXPECT_NEAR(end[0], 0.0, 1e-11 * angle * a);
    EXPECT_NEAR(end[1], 0.0, 1e-11 * angle);
    expect_relative(twist.strain_energy, 0.5 * twist.torque * angle, kAlgebra);
    expect_relative(twist.margin, c * c / (b * b - c * c) - 0.3, kAlgebra * 10);
  }
}

// A narrow ring is a strip in shear: rays at 45 degrees, a quarter of E.
TEST(ClosedFormDisc, narrow_twisted_ring_is_a_wrinkled_strip) {
  const double a = 1.0, width = 1e-4, angle = 1e-6;
  const RingTwist twist = twisted_ring({{1e6, 0.3, 1e-3}, a, a + width}, angle);
  EXPECT_NEAR(twist.ray_radius, std::sqrt(0.5), width);
  const double shear = angle * a / width;
  EXPECT_NEAR(twist.torque, 2.0 * M_PI * 1e3 * 0.25 * shear, 3.0 * width * twist.torque);
}

TEST(ClosedFormDisc, bad_parameters_are_refused_by_name) {
  expect_refused([] { clamped_disc(disc(0.3)); }, "overpressure");
  expect_refused([] { sealed_disc(disc(1e-7)); }, "overpressure");
  expect_refused([] { sealed_disc(disc(0.01, -0.1)); }, "poisson_ratio");
  expect_refused([] { clamped_disc({paper_fabric(), -1.0, 10.0}); }, "radius");
  expect_refused([] { twisted_ring({paper_fabric(), 0.1, 0.1}, 1e-3); }, "outer_radius");
  expect_refused([] { twisted_ring({paper_fabric(), 0.1, 0.3}, 1e-3); }, "not wrinkled");
  expect_refused([] { twisted_ring({paper_fabric(), 0.1, 0.15}, 1.0); }, "angle");
}

}  // namespace
