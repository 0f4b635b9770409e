// SPDX-License-Identifier: Apache-2.0
#include "closed_form/weave.hpp"

#include <array>
#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

constexpr WovenSheet kSheet{60e6, 24e6, 0.2, 2e6};
constexpr WovenSheet kIsotropic{60e6, 60e6, 0.3, 60e6 / 2.6};

TEST(ClosedFormWeave, off_axis_modulus_eq_textbook_values) {
  expect_relative(off_axis_modulus(kSheet, 0.0), 60e6, kAlgebra);
  expect_relative(off_axis_modulus(kSheet, 0.5 * std::numbers::pi), 24e6, kAlgebra);
  // 45 degrees: 4 / (1/E1 + 1/E2 + 1/G - 2 nu/E1)
  expect_relative(off_axis_modulus(kSheet, 0.25 * std::numbers::pi),
                  4.0 / (1.0 / 60e6 + 1.0 / 24e6 + 1.0 / 2e6 - 0.4 / 60e6), kAlgebra);
  for (const double angle : {0.1, 0.7, 2.0})
    expect_relative(off_axis_modulus(kIsotropic, angle), 60e6, kAlgebra);
}

// An isotropic sheet wrinkles along its principal strain: S = E e1 there.
TEST(ClosedFormWeave, isotropic_tension_field_is_principal) {
  const double e1 = 0.05, e2 = -0.1, a = 0.4, c = std::cos(a), s = std::sin(a);
  const auto state =
      woven_tension_field(kIsotropic, e1 * c * c + e2 * s * s, e1 * s * s + e2 * c * c, (e1 - e2) * c * s);
  // The angle by bisection to rounding; the stress is stationary in it but for the turn of its axes.
  EXPECT_NEAR(state.tension_angle, a, 1e-14);
  expect_relative(state.s11 + state.s22, 60e6 * e1, kAlgebra);
  expect_relative(state.energy_density, 0.5 * 60e6 * e1 * e1, kAlgebra);
}

// The state found satisfies the optimality conditions of the primal problem min W(E + P), P >= 0: E + P is
// the elastic strain of S, P is one-dimensional across the tension.
TEST(ClosedFormWeave, wrinkle_strain_is_across_the_tension) {
  for (const auto& [e11, e22, e12] :
       {std::array{0.05, -0.03, 0.02}, {0.01, -0.1, -0.03}, {-0.02, 0.04, 0.01}, {-0.01, -0.01, 0.03}}) {
    const auto st = woven_tension_field(kSheet, e11, e22, e12);
    ASSERT_FALSE(std::isnan(st.tension_angle));
    const double p11 = st.s11 / 60e6 - 0.2 / 60e6 * st.s22 - e11,
                 p22 = st.s22 / 24e6 - 0.2 / 60e6 * st.s11 - e22;
    const double p12 = 0.5 * st.s12 / 2e6 - e12;
    const double c = std::cos(st.tension_angle), s = std::sin(st.tension_angle);
    // Strains of order 0.1 and a compliance ratio of 30: rounding below 1e-14.
    EXPECT_NEAR(p11 * c + p12 * s, 0.0, 1e-14);
    EXPECT_NEAR(p12 * c + p22 * s, 0.0, 1e-14);
    EXPECT_GT(p11 + p22, 0.0);
    expect_relative(st.energy_density, 0.5 * (st.s11 * e11 + st.s22 * e22) + st.s12 * e12, 1e-13);
  }
}

TEST(ClosedFormWeave, taut_and_slack_states) {
  const auto taut = woven_tension_field(kSheet, 0.02, 0.01, 0.001);
  EXPECT_TRUE(std::isnan(taut.tension_angle));
  expect_relative(taut.s12, 4e3, kAlgebra);
  expect_relative(taut.s11 / 60e6 - 0.2 / 60e6 * taut.s22, 0.02, kAlgebra);
  EXPECT_EQ(woven_tension_field(kSheet, -0.02, -0.01, 0.001).energy_density, 0.0);
}

TEST(ClosedFormWeave, bad_sheets_are_refused) {
  expect_refused([] { off_axis_modulus({0.0, 1.0, 0.1, 1.0}, 0.0); }, "warp_modulus");
  expect_refused([] { off_axis_modulus({1.0, -1.0, 0.1, 1.0}, 0.0); }, "weft_modulus");
  expect_refused([] { off_axis_modulus({1.0, 4.0, 0.5, 1.0}, 0.0); }, "poisson_ratio");
  expect_refused([] { off_axis_modulus({1.0, 1.0, 0.5, 0.0}, 0.0); }, "shear_modulus");
  expect_refused([] { off_axis_modulus(kSheet, NAN); }, "angle");
  expect_refused([] { woven_tension_field(kSheet, 0.0, INFINITY, 0.0); }, "e22");
}

// Equilibrium at the stretch found, and the linear cylinder: h E (lambda - 1) = p R lambda.
TEST(ClosedFormWeave, cylinder_by_curve_is_in_equilibrium) {
  const StripCurve curve{{0.0, 0.05, 0.1, 1.0}, {0.0, 1e6, 4e6, 4e7}};
  const double h = 0.5e-3, radius = 0.15;
  for (const double p : {0.0, 1e3, 3e3, 1e4, 3e4}) {
    const double stretch = cylinder_by_curve(curve, h, radius, p), strain = stretch - 1.0;
    std::size_t i = 1;
    while (strain > curve.strain[i]) ++i;
    const double stress = curve.stress[i - 1] + (curve.stress[i] - curve.stress[i - 1]) *
                                                    (strain - curve.strain[i - 1]) /
                                                    (curve.strain[i] - curve.strain[i - 1]);
    EXPECT_NEAR(h * stress, p * radius * stretch, 1e-12 * h * 4e7) << p;
  }
  test::expect_relative(cylinder_by_curve({{0.0, 1.0}, {0.0, 6e7}}, h, radius, 1e4), 1.0 / (1.0 - 0.05),
                        test::kAlgebra);
  test::expect_refused([&] { cylinder_by_curve(curve, h, radius, 1e5); }, "overpressure");
  test::expect_refused(
      [&] {
        cylinder_by_curve({{0.0, 0.1, 0.1}, {0.0, 1.0, 2.0}}, h, radius, 1e5);
      },
      "curve");
}

}  // namespace
