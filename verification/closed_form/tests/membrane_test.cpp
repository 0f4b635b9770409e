// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: the formulas; Hencky's series of 80
// terms and its root b_0; icospheres by midpoint subdivision of the vertices.
#include "closed_form/membrane.hpp"

#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kInverted;

constexpr Sheet kOtherSheet{2e8, 0.45, 2e-4, 900.0};

TEST(ClosedFormMembrane, icosphere_ratios_eq_reference) {
  struct Row {
    int level;
    double volume, area;
  };
  for (const Row& r :
       {Row{0, 0.60546138291252558, 0.76191779449298032}, Row{1, 0.87345320000306316, 0.92834532338144213},
        Row{2, 0.96616074859858712, 0.98117817575312962}, Row{3, 0.99139384262975479, 0.99523506967709317},
        Row{4, 0.99783917161059816, 0.99880500625646807}, Row{5, 0.99945921008289917, 0.99970101579715391}}) {
    const IcosphereRatios ratios = icosphere_ratios(r.level);
    EXPECT_EQ(ratios.faces, 20u << (2 * r.level));
    expect_relative(ratios.volume_ratio, r.volume, kInverted);  // sums of up to 20480 terms
    expect_relative(ratios.area_ratio, r.area, kInverted);
  }
  // The icosahedron's edge is 4/sqrt(10 + 2 sqrt 5) circumradii.
  const double edge = 4.0 / std::sqrt(10.0 + 2.0 * std::sqrt(5.0));
  expect_relative(icosahedron_volume(edge), icosphere_ratios(0).volume_ratio * 4.0 / 3.0 * pi, kAlgebra);
  expect_relative(icosahedron_volume(1.0), 2.1816949906249124, kAlgebra);
  expect_relative(icosahedron_volume(0.2), 0.008 * 2.1816949906249124, kAlgebra);
}

TEST(ClosedFormMembrane, stretched_sphere_eq_reference) {
  struct Row {
    double p, stretch, stress, volume;
  };
  const StretchedSphere sphere{paper_fabric(), 0.3};
  for (const Row& r : {Row{100.0, 1.0003500612499981, 30010.501837499944, 0.11321615009584384},
                       Row{20000.0, 1.0724470060806207, 6434682.0364837242, 0.13950182747624023},
                       Row{100000.0, 1.4094810050208545, 42284430.150625636, 0.31668686862937881}}) {
    const SphereStretch s = stretched_sphere(sphere, r.p);
    expect_relative(s.stretch, r.stretch, kAlgebra);
    expect_relative(s.stress, r.stress, kAlgebra);
    expect_relative(s.volume, r.volume, kAlgebra);
    // stretch - 1 carries the pressure: relative error of 1e-16/3.5e-4 at 100 Pa.
    expect_relative(stretched_sphere_pressure(sphere, s.stretch), r.p, 1e-12);
  }
}

TEST(ClosedFormMembrane, sphere_strain_energy_eq_pressure_work) {
  for (const StretchedSphere& sphere :
       {StretchedSphere{paper_fabric(), 0.3}, StretchedSphere{kOtherSheet, 0.1}}) {
    const SphereStretch s = stretched_sphere(sphere, 3e4);
    const auto power = [&sphere](double stretch) {  // p dV/dlambda
      return stretched_sphere_pressure(sphere, stretch) * 4 * pi * std::pow(sphere.radius, 3) * stretch *
             stretch;
    };
    expect_relative(s.strain_energy, test::integrate(power, 1.0, s.stretch), 1e-12);
  }
}

TEST(ClosedFormMembrane, sphere_breathing_eq_reference_and_second_difference) {
  Sheet sheet = paper_fabric();
  const StretchedSphere sphere{sheet, 0.30598317419458695};
  expect_relative(sphere_breathing_frequency(sphere, 0.0, 101325.0, 0.0), 1718.4947617911246, kAlgebra);
  expect_relative(sphere_breathing_frequency(sphere, 0.0, 121325.0, 1.4), 2885.355786795367, kAlgebra);
  expect_relative(2 * pi / sphere_breathing_frequency(sphere, 20000.0, 101325.0, 1.4), 0.0021003621894567881,
                  kAlgebra);
  // Force on the wall per area, gas along its adiabat: slope by a central difference of step 1e-5.
  const StretchedSphere other{kOtherSheet, 0.1};
  const double p = 5e4;
  const double stretch = stretched_sphere(other, p).stretch;
  const auto force = [&](double x) {
    const double gas = (9e4 + p) * std::pow(stretch / x, 3 * 1.3) - 9e4;
    return (gas - stretched_sphere_pressure(other, x)) * x * x;
  };
  const double slope = (force(stretch + 1e-5) - force(stretch - 1e-5)) / 2e-5;
  const double omega = std::sqrt(-slope / (kOtherSheet.density * kOtherSheet.thickness * other.radius));
  expect_relative(sphere_breathing_frequency(other, p, 9e4, 1.3), omega, 1e-8);
}

TEST(ClosedFormMembrane, sphere_breathing_decay_eq_stress_rate_by_difference) {
  const StretchedSphere sphere{kOtherSheet, 0.1};
  const double beta = 3e-5, omega = sphere_breathing_frequency(sphere, 0.0, 0.0, 0.0);
  expect_relative(sphere_breathing_decay(sphere, 0.0, beta), 0.5 * beta * omega * omega, kAlgebra);
  // 2 S h lambda / R is the pull per area, so that of beta dS/dt is 2 beta S' h lambda / R per rate; half of
  // it over the mass rho h R is the rate.
  const double p = 5e4, step = 1e-2 * p;
  const SphereStretch low = stretched_sphere(sphere, p - step), high = stretched_sphere(sphere, p + step);
  const double slope = (high.stress - low.stress) / (high.stretch - low.stretch);
  const double stretch = stretched_sphere(sphere, p).stretch;
  const double rate = beta * slope * stretch / (kOtherSheet.density * 0.1 * 0.1);
  expect_relative(sphere_breathing_decay(sphere, p, beta), rate, 1e-6);  // the step's square
  expect_refused([&] { sphere_breathing_decay(sphere, p, -1.0); }, "beta");
}

TEST(ClosedFormMembrane, damped_swing_solves_its_equation) {
  const double omega = 1700.0, beta = 2e-4, h = 1e-6;
  expect_relative(damped_swing(omega, 0.0, 1e-3), std::cos(1.7), kAlgebra);
  EXPECT_EQ(damped_swing(omega, beta, 0.0), 1.0);
  EXPECT_NEAR(damped_swing(omega, beta, h) - 1.0, -0.5 * omega * omega * h * h, 1e-9);  // at rest
  for (const double t : {1e-4, 1e-3, 4e-3}) {
    const double left = damped_swing(omega, beta, t - h), middle = damped_swing(omega, beta, t),
                 right = damped_swing(omega, beta, t + h);
    const double acceleration = (left - 2.0 * middle + right) / (h * h), speed = (right - left) / (2.0 * h);
    const double size = omega * omega;
    EXPECT_NEAR(acceleration + beta * omega * omega * speed + omega * omega * middle, 0.0, 1e-3 * size) << t;
  }
  expect_refused([&] { damped_swing(omega, 2.1 / omega, 1.0); }, "beta");
}

TEST(ClosedFormMembrane, cylinders_eq_reference_and_equilibrium) {
  const StretchedCylinder cylinder{paper_fabric(), 0.15};
  const CylinderStretch fixed = fixed_length_cylinder(cylinder, 20000.0);
  expect_relative(fixed.hoop_stretch, 1.0871982339941507, kAlgebra);
  expect_relative(fixed.axial_stress, 1.8e6, kAlgebra);
  EXPECT_EQ(fixed.axial_stretch, 1.0);
  const CylinderStretch small = closed_cylinder(cylinder, 2.0);  // linear strains .085 and .020 at 20 kPa
  expect_relative(small.hoop_stretch - 1.0, 0.085e-4, 1e-4);     // next order: a few times the load 1e-5
  expect_relative(small.axial_stretch - 1.0, 0.020e-4, 1e-4);
  for (const StretchedCylinder& c : {cylinder, StretchedCylinder{kOtherSheet, 0.08}}) {
    const CylinderStretch s = closed_cylinder(c, 2e4);
    const double load = 2e4 * c.radius / c.sheet.thickness;
    expect_relative(s.hoop_stress, load * s.axial_stretch, kAlgebra * 10);  // strains of 0.1: a digit is lost
    expect_relative(s.axial_stretch * s.axial_stress, 0.5 * load * s.hoop_stretch * s.hoop_stretch,
                    kAlgebra * 10);
    // Hooke back: E E_h = S_h - nu S_z.
    const double eh = 0.5 * (s.hoop_stretch * s.hoop_stretch - 1.0);
    expect_relative(c.sheet.young_modulus * eh, s.hoop_stress - c.sheet.poisson_ratio * s.axial_stress,
                    1e-13);
  }
}

CircularMembrane circular(double poisson_ratio, double q) {
  return {{1e6, poisson_ratio, 1e-3}, 0.5, 2e3 * q};
}

TEST(ClosedFormMembrane, hencky_eq_reference) {
  struct Row {
    double nu, b0, w0, volume, centre, edge;
  };
  for (const Row& r : {Row{0.2, 1.6827323617377306, 0.6774353258045668, 1.1143779534149061,
                           0.42068309043443265, 0.31610928852072364},
                       Row{0.3, 1.7244040644388306, 0.65344334469270258, 1.0703166865020039,
                           0.43110101610970764, 0.33295680687217958}})
    for (const double q : {1e-3, 1e-2}) {
      const HenckyMembrane h = hencky_membrane(circular(r.nu, q));
      expect_relative(h.coefficients.front(), r.b0, kAlgebra);
      expect_relative(h.centre_deflection, r.w0 * 0.5 * std::cbrt(q), kAlgebra);
      expect_relative(h.volume, r.volume * 0.125 * std::cbrt(q), kAlgebra);
      expect_relative(h.centre_resultant, r.centre * 1e3 * std::cbrt(q * q), kAlgebra);
      expect_relative(h.edge_resultant, r.edge * 1e3 * std::cbrt(q * q), kAlgebra);
    }
  const std::vector<double> b = hencky_membrane(circular(0.3, 1e-3)).coefficients;
  const double exact[] = {1.7244040644388306,     -0.33629617239887405,   -0.043723362330370265,
                          -0.0092375870642046253, -0.0023558465573159138, -0.00066664009457604887};
  for (std::size_t n = 0; n < 6; ++n) expect_relative(b[n], exact[n], 1e-13);  // b_0 to the power 1 - 3 n
}

// The same boundary-value problem by integration in rho, N' and w' from the centre.
TEST(ClosedFormMembrane, hencky_eq_integrated_equation) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    const CircularMembrane membrane = circular(nu, 0.01);
    const HenckyMembrane h = hencky_membrane(membrane);
    // y = B, B' (in x), w/(a q^(1/3)); starts at x = 1e-3 from the first three terms (tail below 1e-11).
    const auto& b = h.coefficients;
    const double x0 = 1e-3;
    const test::Rate rate = [](double x, const std::vector<double>& y) {
      return std::vector<double>{y[1], (-2.0 / (y[0] * y[0]) - 2.0 * y[1]) / x, -1.0 / y[0]};
    };
    const std::vector<double> start{
        b[0] + x0 * (b[1] + x0 * b[2]), b[1] + 2 * x0 * b[2],
        h.centre_deflection / (0.5 * std::cbrt(0.01)) - x0 / b[0] + 0.5 * x0 * x0 * b[1] / (b[0] * b[0])};
    const std::vector<double> end = test::integrate_ode(rate, start, x0, 1.0);
    EXPECT_NEAR((1.0 - nu) * end[0] + 2.0 * end[1], 0.0, 1e-8);  // no radial displacement at the edge
    EXPECT_NEAR(end[2], 0.0, 1e-9);                              // nor deflection
    EXPECT_NEAR(hencky_deflection(membrane, 0.5), 0.0, 1e-16);
    expect_relative(hencky_deflection(membrane, 0.0), h.centre_deflection, kAlgebra);
  }
}

TEST(ClosedFormMembrane, mylar_balloon_eq_reference_and_profile) {
  const MylarBalloon unit = mylar_balloon(1.0);
  expect_relative(unit.equator_radius, 0.76275976350181319, kAlgebra);
  expect_relative(unit.thickness, 0.91389316208892725, kAlgebra);
  expect_relative(unit.volume, 1.2185242161185697, kAlgebra);
  for (const double a : {0.3, 1.0}) {
    const MylarBalloon m = mylar_balloon(a);
    expect_relative(2.0 * mylar_profile(a, 0.0), m.thickness, kAlgebra);
    EXPECT_EQ(mylar_profile(a, m.equator_radius), 0.0);
    const auto shell = [a, &m](double t) {  // x = r cos(t) removes the vertical tangent at the equator
      const double x = m.equator_radius * std::cos(t);
      return 4.0 * pi * x * mylar_profile(a, x) * m.equator_radius * std::sin(t);
    };
    expect_relative(m.volume, test::integrate(shell, 0.0, 0.5 * pi), 1e-12);
  }
}

TEST(ClosedFormMembrane, element_states_eq_reference) {
  const UniaxialState u = uniaxial_tension(paper_fabric(), 1.2);
  expect_relative(u.stress, 13.2e6, kAlgebra);
  expect_relative(u.transverse_stretch, 0.93166517590816928, kAlgebra);
  expect_relative(u.nominal_stress, 15.84e6, kAlgebra);
  const PlaneStress s = simple_shear(paper_fabric(), 0.1);
  expect_relative(s.s12, 2307692.3076923077, kAlgebra);
  expect_relative(s.s11, 98901.098901098901, kAlgebra);
  expect_relative(s.s22, 329670.32967032967, kAlgebra);
  // Odd in the shear, and linear in E.
  EXPECT_EQ(simple_shear(paper_fabric(), -0.1).s12, -s.s12);
  Sheet stiff = paper_fabric();
  stiff.young_modulus *= 4.0;
  expect_relative(simple_shear(stiff, 0.1).s22, 4.0 * s.s22, kAlgebra);
}

TEST(ClosedFormMembrane, bad_parameters_are_refused_by_name) {
  expect_refused([] { stretched_sphere({paper_fabric()}, 1.0); }, "radius");
  expect_refused([] { stretched_sphere({{60e6, 0.6, 1e-3}, 0.3}, 1.0); }, "poisson_ratio");
  expect_refused([] { wave_speeds({60e6, 0.3, 1e-3}); }, "density");
  expect_refused([] { hencky_membrane(circular(0.3, 0.2)); }, "overpressure");
  expect_refused([] { icosphere_ratios(9); }, "level");
  expect_refused([] { mylar_profile(1.0, 0.8); }, "x");
  expect_refused([] { uniaxial_tension(paper_fabric(), 2.2); }, "stretch");
}

}  // namespace
