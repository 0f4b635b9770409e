// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: the formulas of closed_form/jet.hpp;
// Tollmien by Taylor series and beta functions; inclined plate by quadrature of the profile; lattice by its
// sum.
#include "closed_form/jet.hpp"

#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kDegree;

TEST(ClosedFormJet, centreline_eq_reference) {
  struct Row {
    double a, z, ratio;
  };
  for (const Row& r :
       {Row{0.066, 10, 1.0}, Row{0.066, 20, 0.59627329192546584}, Row{0.076, 100, 0.12167300380228137},
        Row{0.08, 10, 0.88073394495412844}, Row{0.08, 20, 0.50793650793650794},
        Row{0.08, 40, 0.27507163323782235}, Row{0.089, 40, 0.24935064935064935}})
    expect_relative(round_centreline_ratio(r.a, r.z), r.ratio, kAlgebra);
  for (const Row& r :
       {Row{0.1, 10, 1.0}, Row{0.108, 20, 0.74853943386216641}, Row{0.11, 20, 0.74278135270820745},
        Row{0.11, 40, 0.54715290310506384}, Row{0.12, 100, 0.34063977348219572}})
    expect_relative(plane_centreline_ratio(r.a, r.z), r.ratio, kAlgebra);
}

TEST(ClosedFormJet, core_ends_where_the_decay_starts) {
  expect_relative(round_core_length(0.08), 8.375, kAlgebra);
  expect_relative(plane_core_length(0.11), 9.3636363636363636, kAlgebra);
  for (const double a : {0.066, 0.09, 0.12}) {
    EXPECT_EQ(round_centreline_ratio(a, 0.999 * round_core_length(a)), 1.0);
    EXPECT_LT(round_centreline_ratio(a, 1.001 * round_core_length(a)), 1.0);
    expect_relative(round_centreline_ratio(a, round_core_length(a)), 1.0, kAlgebra);
    EXPECT_EQ(plane_centreline_ratio(a, 0.999 * plane_core_length(a)), 1.0);
    EXPECT_LT(plane_centreline_ratio(a, 1.001 * plane_core_length(a)), 1.0);
    expect_relative(plane_centreline_ratio(a, plane_core_length(a)), 1.0, kAlgebra);
  }
}

TEST(ClosedFormJet, section_eq_reference) {
  const JetSection round = round_jet_section({1.0}, 40.0);
  expect_relative(round.width, 5.1412555548771893, kAlgebra);
  expect_relative(round.volume_flux_ratio, 7.2708333333333333, kAlgebra);
  expect_relative(round.energy_flux_ratio, 0.1833810888252149, kAlgebra);
  const JetSection plane = plane_jet_section({1.0}, 40.0);
  expect_relative(plane.width, 5.3303121353635866, kAlgebra);
  expect_relative(plane.volume_flux_ratio, 2.5846770698784704, kAlgebra);
  expect_relative(plane_jet_section({0.01, 0.2, 0.11, 400.0, 1.0}, 0.3).momentum_flux, 640.0, kAlgebra);
}

// Momentum, volume and energy of the velocity profile itself, by quadrature over 8 widths.
TEST(ClosedFormJet, fluxes_eq_quadrature_of_the_profile) {
  const RoundJet round{0.04, 0.07, 350.0, 1.3};
  const PlaneJet plane{0.015, 0.3, 0.1, 250.0, 0.8};
  for (const double z : {0.0, 0.2, 1.5}) {
    const auto integral = [z](const auto& velocity, double width, int power, bool axial) {
      return test::integrate(
          [&](double r) { return std::pow(velocity(z, r), power) * (axial ? 2 * pi * r : 1.0); },
          axial ? 0.0 : -8 * width, 8 * width);
    };
    const auto v_round = [&round](double at, double r) { return round_jet_velocity(round, at, r); };
    const JetSection s = round_jet_section(round, z);
    const double area = pi * 0.04 * 0.04;
    expect_relative(1.3 * integral(v_round, s.width, 2, true), s.momentum_flux, 1e-12);
    expect_relative(s.momentum_flux, 1.3 * 350.0 * 350.0 * area, kAlgebra);
    expect_relative(integral(v_round, s.width, 1, true) / (350.0 * area), s.volume_flux_ratio, 1e-12);
    expect_relative(integral(v_round, s.width, 3, true) / (std::pow(350.0, 3) * area), s.energy_flux_ratio,
                    1e-12);

    const auto v_plane = [&plane](double at, double r) { return plane_jet_velocity(plane, at, r); };
    const JetSection p = plane_jet_section(plane, z);
    expect_relative(0.8 * 0.3 * integral(v_plane, p.width, 2, false), p.momentum_flux, 1e-12);
    expect_relative(p.momentum_flux, 0.8 * 250.0 * 250.0 * 0.03 * 0.3, kAlgebra);
    expect_relative(integral(v_plane, p.width, 1, false) / (250.0 * 0.03), p.volume_flux_ratio, 1e-12);
    expect_relative(integral(v_plane, p.width, 3, false) / (std::pow(250.0, 3) * 0.03), p.energy_flux_ratio,
                    1e-12);
  }
}

TEST(ClosedFormJet, far_field_eq_reference_and_centreline) {
  expect_relative(round_far_field(0.08).decay_constant, 6.0, kAlgebra);
  expect_relative(round_far_field(0.08).half_width_slope, 0.098117501876289558, kAlgebra);
  expect_relative(round_far_field(0.08).entrainment_slope, 1.0 / 3.0, kAlgebra);
  expect_relative(plane_far_field(0.11).decay_constant, 0.15277777777777778, kAlgebra);
  expect_relative(plane_far_field(0.11).half_width_slope, 0.10148759962427167, kAlgebra);
  for (const double a : {0.066, 0.1}) {  // slopes of the sections far downstream, per diameter and per height
    const auto q = [a](double z) { return round_jet_section({0.5, a}, z).volume_flux_ratio; };
    expect_relative(q(101.0) - q(100.0), round_far_field(a).entrainment_slope, 1e-11);
    const auto inverse = [a](double z) { return std::pow(plane_centreline_ratio(a, 2 * z), -2); };
    expect_relative(inverse(101.0) - inverse(100.0), plane_far_field(a).decay_constant, 1e-11);
  }
}

TEST(ClosedFormJet, tollmien_eq_reference) {
  const TollmienConstants round = tollmien_round();
  expect_relative(round.edge, 3.4006340691270658, 1e-12);  // integrated at a relative tolerance of 1e-14
  expect_relative(round.half_velocity, 1.2277643545945179, 1e-12);
  expect_relative(round.momentum_integral, 0.54006462457367114, 1e-12);
  expect_relative(round.flux_integral, 1.1379580391092946, 1e-12);
  expect_relative(round.decay_constant, 0.96219287509005739, 1e-12);
  const TollmienConstants plane = tollmien_plane();
  expect_relative(plane.edge, 2.4183991523122905, kAlgebra);
  expect_relative(plane.half_velocity, 0.95549855408353808, 1e-13);
  expect_relative(plane.momentum_integral, 0.68446340597972573, kAlgebra);
  expect_relative(plane.decay_constant, 1.2087177032733153, kAlgebra);
}

TEST(ClosedFormJet, sonic_outlet_eq_reference) {
  const OutletState s = sonic_outlet({{}, 406.0, false, 2.0, 5e-3});
  expect_relative(s.velocity, 410.73241897858513, kAlgebra);
  expect_relative(s.density, 0.9738700465736923, kAlgebra);
  expect_relative(s.momentum_flux, 821.46483795717026, kAlgebra);
  expect_relative(s.static_pressure, 117352.11970816718, kAlgebra);
  const OutletState stagnation = sonic_outlet({{}, 406.0, true, 2.0, 5e-3});
  expect_relative(stagnation.velocity, 374.94568495539013, kAlgebra);
  expect_relative(stagnation.static_pressure, 107127.33855868289, kAlgebra);
  expect_relative(sonic_outlet({{}, 1200.0, false, 1.0, 1e-2}).velocity, 706.13313192343553, kAlgebra);
  expect_relative(plate_force(2.0, s.momentum_flux), 1642.9296759143405, kAlgebra);
  expect_relative(plate_force(1.0, s.momentum_flux), s.momentum_flux, kAlgebra);
}

// Of all states on an isentrope from rest, the throat's carries the largest mass per area: no speed of sound
// is used. d ln(rho V)/dT = 1/((gamma-1) T) - 1/(2 (1-T)) falls from plus to minus over 0 < T/T0 < 1.
double throat_temperature_ratio(double gamma) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    (1.0 / ((gamma - 1.0) * t) > 0.5 / (1.0 - t) ? low : high) = t;
  }
  return low;
}

TEST(ClosedFormJet, sonic_outlet_is_the_throat_of_an_isentrope) {
  for (const PerfectGas& gas :
       {PerfectGas{296.8, 1.4}, PerfectGas{2077.0, 5.0 / 3.0}, PerfectGas{188.9, 1.3}})
    for (const bool stagnation : {false, true}) {
      const double given = 900.0, mass_flow = 1.7, area = 4e-3;
      const OutletState s = sonic_outlet({gas, given, stagnation, mass_flow, area});
      const double ratio = throat_temperature_ratio(gas.heat_capacity_ratio);
      const double rest = stagnation ? given : given / ratio, throat = ratio * rest;
      const double cp = gas.heat_capacity_ratio / (gas.heat_capacity_ratio - 1.0) * gas.gas_constant;
      // The bisection's ratio is known to eps; rest - throat loses a digit of it.
      const double tolerance = 10 * kAlgebra;
      expect_relative(s.velocity, std::sqrt(2.0 * cp * (rest - throat)), tolerance);
      expect_relative(s.density * s.velocity * area, mass_flow, kAlgebra);
      expect_relative(s.momentum_flux, s.density * s.velocity * s.velocity * area, kAlgebra);
      expect_relative(s.static_pressure, s.density * gas.gas_constant * throat, tolerance);
    }
}

TEST(ClosedFormJet, decay_is_tollmiens_to_its_digits) {
  // 1/V (round) and 1/V^2 (plane) rise by a distance over the constant: 0.96 has two digits, 1.2 has two,
  // which Abramovich rounds down.
  for (const double a : {0.066, 0.12}) {
    const double round =
        a * 50.0 / (1.0 / round_centreline_ratio(a, 150.0) - 1.0 / round_centreline_ratio(a, 100.0));
    EXPECT_NEAR(round, tollmien_round().decay_constant, 0.005);
    const auto inverse = [a](double z) { return std::pow(plane_centreline_ratio(a, z), -2); };
    EXPECT_NEAR(std::sqrt(a * 50.0 / (inverse(150.0) - inverse(100.0))), tollmien_plane().decay_constant,
                0.01);
  }
}

TEST(ClosedFormJet, target_fractions_eq_reference_and_limits) {
  struct Row {
    double ratio, fraction;
  };
  for (const Row& r : {Row{0.25, 0.1175030974154046}, Row{0.5, 0.39346934028736658},
                       Row{1.0, 0.86466471676338731}, Row{2.0, 0.99966453737209749}}) {
    expect_relative(disc_fraction(r.ratio * 0.3, 0.3), r.fraction, kAlgebra);
    expect_relative(off_axis_disc_fraction(r.ratio * 0.3, 0.0, 0.3), r.fraction, test::kInverted);
  }
  expect_relative(half_plane_fraction(0.1, 0.2), 0.84134474606854295, kAlgebra);
  EXPECT_EQ(half_plane_fraction(0.0, 0.2), 0.5);
  expect_relative(square_fraction(0.1, 0.2), std::pow(2 * half_plane_fraction(0.1, 0.2) - 1, 2), kAlgebra);
}

TEST(ClosedFormJet, off_axis_disc_eq_double_quadrature) {
  for (const double offset : {0.2, 0.7, 3.0}) {
    const double radius = 0.6;
    const auto strip = [&](double x) {  // erf in y over the chord
      const double u = std::cos(x);     // x is an angle: smooth chord ends
      const double chord = radius * std::sin(x);
      const double position = offset + radius * u;
      return std::sqrt(2 / pi) * std::exp(-2 * position * position) * std::erf(std::sqrt(2.0) * chord) *
             chord;
    };
    expect_relative(off_axis_disc_fraction(radius, offset, 1.0), test::integrate(strip, 0.0, pi), 1e-11);
  }
  // A very large disc's edge is a half plane: curvature 1/2000 against the width.
  EXPECT_NEAR(off_axis_disc_fraction(1000.0, 999.7, 1.0), half_plane_fraction(0.3, 1.0), 2e-4);
}

TEST(ClosedFormJet, inclined_plate_eq_reference_and_series) {
  const double slope = std::sqrt(2.0) * 0.08 / 0.96;
  expect_relative(inclined_plate_fraction(30 * kDegree, slope, 3.0), 0.86703124688219385, 1e-13);
  expect_relative(inclined_plate_fraction(60 * kDegree, slope, 3.0), 0.5053802530035285, 1e-13);
  for (const double theta : {0.3, -0.9}) {
    EXPECT_EQ(inclined_plate_fraction(theta), std::cos(theta));
    for (const double s : {0.02, 0.1}) {
      const double series = 1 + s * s / 4 + 3 * std::pow(s, 4) / 16;
      const double fraction = inclined_plate_fraction(theta, s / std::tan(std::abs(theta)), 6.0);
      // Next term 15 s^6/64, and erfc(6 sqrt 2) < 1e-32 of the jet beyond the extent.
      expect_relative(fraction / std::cos(theta), series, std::pow(s, 6) + kAlgebra);
    }
  }
}

TEST(ClosedFormJet, lattice_error_eq_reference_and_sum) {
  // Relative to the field: the error itself is a difference from 1, known to 1e-16 at best.
  EXPECT_NEAR(lattice_quadrature_error(1.5), -0.39595786501411772, kAlgebra);
  EXPECT_NEAR(lattice_quadrature_error(1.0), -0.028560630131261094, kAlgebra);
  EXPECT_NEAR(lattice_quadrature_error(0.75), -0.00061934864677569943, kAlgebra);
  EXPECT_NEAR(lattice_quadrature_error(0.5), -1.0701151935668295e-8, kAlgebra);
  for (const double h : {0.6, 1.2, 3.0}) {
    double line = 0.0;
    for (int i = 0; i < 60; ++i)
      line += 2 * std::exp(-2 * std::pow((i + 0.5) * h, 2)) * h * std::sqrt(2 / pi);
    EXPECT_NEAR(lattice_quadrature_error(h), line * line - 1, kAlgebra);
  }
}

TEST(ClosedFormJet, bad_parameters_are_refused_by_name) {
  expect_refused([] { round_jet_section({}, 1.0); }, "radius");
  expect_refused([] { round_centreline_ratio(0.08, -1.0); }, "distance");
  expect_refused([] { plate_force(2.5, 1.0); }, "reflection");
  expect_refused([] { inclined_plate_fraction(1.2, 0.3, 3.0); }, "width_slope");
  expect_refused([] { sonic_outlet({{}, 406.0, false, 2.0}); }, "area");
}

}  // namespace
