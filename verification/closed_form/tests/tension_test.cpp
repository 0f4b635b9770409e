// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: zeros of Bessel functions, Fourier
// series, and the lattice's discrete Fourier sums.
#include <numbers>

#include "check.hpp"
#include "closed_form/membrane.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kInverted;

constexpr TensionedMembrane kReference{1000.0, 0.31};

TEST(ClosedFormTension, drum_eq_reference) {
  struct Row {
    int m, n;
    double f;
  };
  for (const Row& r : {Row{0, 1, 72.460547106704057}, Row{1, 1, 115.45432476994033},
                       Row{2, 1, 154.74303345367379}, Row{0, 2, 166.32719103598632}})
    expect_relative(drum_frequency(kReference, 0.3, r.m, r.n), r.f, kInverted);  // GSL's Bessel zeros
  expect_relative(transverse_wave_speed(kReference), 56.796183424706481, kAlgebra);
  // Zeros of the library against the standard library's own Bessel function; slope there is about 0.5.
  for (int m = 0; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n) {
      const double zero = drum_frequency({4.0, 1.0}, 1.0, m, n) * pi;
      EXPECT_NEAR(std::cyl_bessel_j(m, zero), 0.0, 1e-13);
    }
}

TEST(ClosedFormTension, rectangle_eq_reference) {
  expect_relative(rectangle_frequency(kReference, 0.6, 0.6, 1, 1), 66.934944075208239, kAlgebra);
  expect_relative(rectangle_frequency(kReference, 0.6, 0.6, 1, 2), 105.83343916682542, kAlgebra);
  expect_relative(rectangle_frequency(kReference, 0.6, 0.6, 2, 2), 133.86988815041648, kAlgebra);
  // A long strip vibrates across: f -> c n/(2 b).
  expect_relative(rectangle_frequency({9.0, 1.0}, 1e9, 0.5, 1, 2), 6.0, kAlgebra);
}

TEST(ClosedFormTension, lattice_frequency_eq_reference_with_order_two) {
  struct Row {
    int divisions;
    double error;
  };
  const double exact = rectangle_frequency(kReference, 0.6, 0.6, 1, 1);
  for (const Row& r :
       {Row{8, -0.0064131488557942337}, Row{16, -0.0016056069643816418}, Row{32, -0.00040154685032092113}})
    EXPECT_NEAR(lattice_square_frequency(kReference, 0.6, r.divisions, 1, 1) / exact - 1.0, r.error,
                kAlgebra);
  for (const int m : {1, 3})
    for (const int n : {1, 2}) {
      const auto error = [m, n](int N) {
        return 1.0 - lattice_square_frequency({7.0, 2.0}, 0.4, N, m, n) /
                         rectangle_frequency({7.0, 2.0}, 0.4, 0.4, m, n);
      };
      for (const int N : {32, 64, 128}) {
        EXPECT_GT(std::log2(error(N) / error(2 * N)), 1.98);
        EXPECT_LT(std::log2(error(N) / error(2 * N)), 2.02);
      }
    }
}

TEST(ClosedFormTension, square_deflection_eq_reference) {
  expect_relative(square_deflection().centre_coefficient, 0.073671353281513816, kAlgebra);
  // 1/12 - (16/pi^5) sum tanh(k pi/2)/k^5 in 30 digits (a truncated sum gives ...768).
  expect_relative(square_deflection().volume_coefficient, 0.035144253738788429, kAlgebra);
  struct Row {
    int divisions;
    double centre;
  };
  for (const Row& r :
       {Row{8, 0.072782628676470588}, Row{16, 0.073445766578919745}, Row{32, 0.073614737354524424}})
    expect_relative(lattice_square_deflection(r.divisions).centre_coefficient, r.centre, kInverted);
}

// Gauss-Seidel on the 5-point equations themselves, and order 2 towards the continuum.
TEST(ClosedFormTension, lattice_deflection_eq_relaxed_equations) {
  constexpr int N = 8;
  double w[N + 1][N + 1] = {};
  for (int sweep = 0; sweep < 2000; ++sweep)  // converges by cos^2(pi/8) a sweep: 0.854^2000 is below 1e-130
    for (int i = 1; i < N; ++i)
      for (int j = 1; j < N; ++j)
        w[i][j] = 0.25 * (w[i - 1][j] + w[i + 1][j] + w[i][j - 1] + w[i][j + 1] + 1.0 / (N * N));
  double volume = 0.0;
  for (const auto& row : w)
    for (const double value : row) volume += value / (N * N);
  expect_relative(lattice_square_deflection(N).centre_coefficient, w[N / 2][N / 2], kInverted);
  expect_relative(lattice_square_deflection(N).volume_coefficient, volume, kInverted);
  const auto error = [](int n) {
    return square_deflection().volume_coefficient - lattice_square_deflection(n).volume_coefficient;
  };
  for (const int n : {16, 32, 64}) {
    EXPECT_GT(std::log2(error(n) / error(2 * n)), 1.95);
    EXPECT_LT(std::log2(error(n) / error(2 * n)), 2.05);
  }
}

TEST(ClosedFormTension, circle_deflection_satisfies_poisson) {
  expect_relative(circle_deflection(1.0, 1.0, 1.0), 0.25, kAlgebra);
  expect_relative(circle_deflection(500.0, 0.3, 40.0), 40.0 * 0.09 / 2000.0, kAlgebra);
}

TEST(ClosedFormTension, force_of_a_dent_eq_slope_of_its_energy) {
  const MembraneDent dent{2e3, 0.3, 10.0};
  for (const double a : {1e-3, 0.05, 0.2}) {
    const double h = 1e-4 * a;
    const DentState less = membrane_dent(dent, a - h), more = membrane_dent(dent, a + h);
    // Central difference: 1e-8 of the curves' bend; cancellation leaves 1e-16/4e-4.
    expect_relative(membrane_dent(dent, a).force, (more.energy - less.energy) / (more.depth - less.depth),
                    1e-7);
  }
  // The membrane meets the sphere's foot at its own slope: depth less the sagitta is the logarithmic funnel.
  const DentState s = membrane_dent(dent, 0.05);
  expect_relative(s.depth - 0.05 * 0.05 / 20.0, s.force * std::log(6.0) / (2 * pi * 2e3), kAlgebra);
}

// Second route to the duration: energies E_max sin^2(phi), so dt = M v sin(phi)/F dphi.
TEST(ClosedFormTension, rebound_eq_integral_over_the_energy) {
  const MembraneDent dent{2e3, 0.3, 10.0};
  const double mass = 40.0, speed = 0.02;
  const MembraneRebound bounce = membrane_rebound(dent, mass, speed);
  expect_relative(bounce.turn.energy, 0.5 * mass * speed * speed, kAlgebra);
  const auto rate = [&](double phi) {
    const double part = membrane_rebound(dent, mass, speed * std::sin(phi)).turn.force;
    return mass * speed * std::sin(phi) / part;
  };
  // Both integrands bend like a logarithm where the patch begins: panels, and what is cut off, leave 1e-6.
  expect_relative(bounce.duration, 2.0 * test::integrate(rate, 1e-6, pi / 2), 1e-5);
  expect_refused([&] { membrane_rebound(dent, mass, 1.0); }, "speed");
  expect_refused([&] { membrane_rebound(dent, 0.0, speed); }, "mass");
  expect_refused([&] { membrane_dent({2e3, 0.3, 0.1}, 0.01); }, "sphere_radius");
  expect_refused([&] { membrane_dent(dent, 0.3); }, "patch_radius");
  expect_refused([&] { membrane_dent({}, 0.1); }, "tension");
}

TEST(ClosedFormTension, wave_speeds_eq_reference) {
  const WaveSpeeds w = wave_speeds(paper_fabric());
  expect_relative(w.plane, 326.1062213997001, kAlgebra);
  expect_relative(w.bar, 311.08550841912758, kAlgebra);
  expect_relative(w.shear, 192.92704235657731, kAlgebra);
  const StretchedWaveSpeeds s = stretched_wave_speeds(paper_fabric(), 1.1);
  expect_relative(s.longitudinal, 373.9572528255083, kAlgebra);
  expect_relative(s.transverse, 105.67049305145203, kAlgebra);
  expect_relative(stretched_wave_speeds(paper_fabric(), 1.0).longitudinal, w.plane, kAlgebra);
  EXPECT_EQ(stretched_wave_speeds(paper_fabric(), 1.0).transverse, 0.0);
  Sheet heavy = paper_fabric();
  heavy.density *= 9.0;
  expect_relative(wave_speeds(heavy).shear, w.shear / 3.0, kAlgebra);
}

TEST(ClosedFormTension, bad_parameters_are_refused_by_name) {
  expect_refused([] { drum_frequency(kReference, 0.3, 0, 0); }, "order");
  expect_refused([] { drum_frequency({}, 0.3, 0, 1); }, "tension");
  expect_refused([] { lattice_square_deflection(7); }, "divisions");
  expect_refused([] { lattice_square_frequency(kReference, 0.6, 8, 8, 1); }, "m");
}

// The shape by its two pieces: value and slope are continuous, the clamp is at rest, and forces balance.
TEST(ClosedFormTension, pressed_strips_keep_the_balance_of_forces_and_the_clamp) {
  const PressedStrips strips{200.0, 0.15, 1.6e-3, 1e6};
  const double layer = std::sqrt(200.0 / 2e6);
  for (const double pressure : {80.0, 100.0, 180.0}) {
    const StripPress press = pressed_strips(strips, pressure);
    const double a = press.contact_half_width, apart = strips.half_width - a;
    // In contact w = H + (p/kappa)/2 (1 - cosh(x/lambda)/cosh(a/lambda)).
    const double slope = -0.5 * press.closing / layer * std::tanh(a / layer);
    EXPECT_NEAR(strips.approach + slope * apart - 0.5 * pressure / strips.tension * apart * apart, 0.0,
                1e-5 * strips.approach);
    expect_relative(press.force, pressure * 2.0 * (a - layer * std::tanh(a / layer)), 1e-5);
    expect_relative(press.force + 2.0 * strips.tension * (-slope + pressure / strips.tension * apart),
                    2.0 * pressure * strips.half_width, 1e-5);
  }
  expect_refused([&] { pressed_strips(strips, 20.0); }, "pressure");
  expect_refused([] { pressed_strips({0.0, 0.15, 1.6e-3, 1e6}, 100.0); }, "tension");
}

}  // namespace
