// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits, by root finding in both strains.
#include "closed_form/logarithmic.hpp"

#include <cmath>

#include "check.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;

constexpr Sheet kStiffSheet{2e8, 0.45, 2e-4, 900.0};
// A strain e is known to eps, so its stress to eps / e; the smallest below is 3.5e-4.
double digits_of(double strain) {
  return test::kAlgebra + 4.0 * 2.2e-16 / strain;
}

TEST(ClosedFormLogarithmic, sphere_eq_reference) {
  struct Row {
    double p, stretch, stress, energy;
  };
  for (const Row& r : {Row{100.0, 1.0003501838644115, 30010.505515932346, 10.512261586553259},
                       Row{20000.0, 1.0784111266541744, 6470466.7599250462, 540509.84926588078},
                       Row{60000.0, 1.319211874743782, 23745813.745388077, 9597315.1418268052}}) {
    const LogarithmicBag s = logarithmic_sphere({paper_fabric(), 0.3}, r.p);
    const double tolerance = digits_of(std::log(r.stretch));
    expect_relative(s.hoop_stretch, r.stretch, test::kAlgebra);
    EXPECT_EQ(s.axial_stretch, s.hoop_stretch);
    expect_relative(s.hoop_stress, r.stress, tolerance);
    expect_relative(s.energy_density, r.energy, 4.0 * tolerance / std::log(r.stretch));
  }
}

TEST(ClosedFormLogarithmic, cylinders_eq_reference) {
  struct Row {
    double p, hoop, axial, stress, energy;
  };
  const StretchedCylinder cylinder{paper_fabric(), 0.15};
  for (const Row& r : {Row{100.0, 1.0004552744992922, 1.0, 30013.658234978767, 6.8325635252016744},
                       Row{20000.0, 1.1037766051539809, 1.0, 6622659.6309238857, 347347.33723828352},
                       Row{60000.0, 1.4502489354015819, 1.0, 26104480.837228474, 6120644.6994851218}}) {
    const LogarithmicBag s = logarithmic_fixed_cylinder(cylinder, r.p);
    expect_relative(s.hoop_stretch, r.hoop, test::kAlgebra);
    EXPECT_EQ(s.axial_stretch, r.axial);
    expect_relative(s.hoop_stress, r.stress, digits_of(std::log(r.hoop)));
    expect_relative(s.energy_density, r.energy, 4.0 * digits_of(std::log(r.hoop)) / std::log(r.hoop));
  }
  expect_relative(logarithmic_fixed_cylinder(cylinder, 60000.0).axial_stress, 8947470.6240964581, 1e-14);
  for (const Row& r :
       {Row{100.0, 1.0004252568994249, 1.0001000332978408, 30012.757706982747, 7.1331312472701365},
        Row{20000.0, 1.0969775073778329, 1.0214826388051594, 6581865.0442669976, 365300.36829814092},
        Row{60000.0, 1.4224217206564847, 1.0778718852371352, 25603590.971816725, 6590415.5128269075}}) {
    const LogarithmicBag s = logarithmic_closed_cylinder(cylinder, r.p);
    expect_relative(s.hoop_stretch, r.hoop, test::kAlgebra);
    expect_relative(s.axial_stretch, r.axial, test::kAlgebra);
    expect_relative(s.hoop_stress, r.stress, digits_of(std::log(r.hoop)));
    expect_relative(s.axial_stress, 0.5 * s.hoop_stress, 4.0 * digits_of(std::log(r.axial)));
    expect_relative(s.energy_density, r.energy, 4.0 * digits_of(std::log(r.hoop)) / std::log(r.hoop));
  }
}

TEST(ClosedFormLogarithmic, strip_eq_reference) {
  const LogarithmicStrip a = logarithmic_strip(paper_fabric(), 1.07),
                         b = logarithmic_strip(paper_fabric(), 1.3);
  expect_relative(a.transverse_stretch, 0.97853883819813878, test::kAlgebra);
  expect_relative(a.stress, 4124005.3772623757, test::kAlgebra);
  expect_relative(a.energy_density, 143139.75799343075, 20 * test::kAlgebra);
  expect_relative(b.transverse_stretch, 0.90308905649532825, test::kAlgebra);
  expect_relative(b.stress, 16813771.014329932, test::kAlgebra);
  expect_relative(b.energy_density, 2411997.3290662415, 20 * test::kAlgebra);
}

// The energy comes from a stored energy, the pressure from equilibrium: they agree if the law has that
// energy.
TEST(ClosedFormLogarithmic, stored_energy_eq_work_of_pressure) {
  for (const Sheet& sheet : {paper_fabric(), kStiffSheet}) {
    const double radius = 0.2, end = 0.3 * sheet.young_modulus * sheet.thickness / radius;
    const auto work_of = [&](const auto& bag, const auto& power_of_radius) {
      // W h = integral of p dV / (reference area), V / (reference area) = power_of_radius(state)
      const auto volume = [&](double p) { return power_of_radius(bag(p)); };
      return end * volume(end) - test::integrate(volume, 0.0, end);
    };
    const auto sphere = [&](double p) { return logarithmic_sphere({sheet, radius}, p); };
    const auto tube = [&](double p) { return logarithmic_fixed_cylinder({sheet, radius}, p); };
    const auto closed = [&](double p) { return logarithmic_closed_cylinder({sheet, radius}, p); };
    const auto of_sphere = [&](const LogarithmicBag& s) {
      return radius * std::pow(s.hoop_stretch, 3) / 3.0;
    };
    const auto of_tube = [&](const LogarithmicBag& s) {
      return 0.5 * radius * s.hoop_stretch * s.hoop_stretch * s.axial_stretch;
    };
    expect_relative(work_of(sphere, of_sphere), sheet.thickness * sphere(end).energy_density, 1e-11);
    expect_relative(work_of(tube, of_tube), sheet.thickness * tube(end).energy_density, 1e-11);
    expect_relative(work_of(closed, of_tube), sheet.thickness * closed(end).energy_density, 1e-11);
  }
}

TEST(ClosedFormLogarithmic, strip_energy_eq_work_of_the_force) {
  for (const Sheet& sheet : {paper_fabric(), kStiffSheet}) {
    const auto force = [&](double stretch) {  // per reference width and thickness
      const LogarithmicStrip s = logarithmic_strip(sheet, stretch);
      return s.stress * s.transverse_stretch;
    };
    expect_relative(logarithmic_strip(sheet, 1.4).energy_density, test::integrate(force, 1.0, 1.4), 1e-12);
  }
}

TEST(ClosedFormLogarithmic, small_pressures_give_the_linear_theory) {
  const Sheet sheet = kStiffSheet;
  const double radius = 0.1, stress = 1e-6 * sheet.young_modulus, nu = sheet.poisson_ratio;
  const double p = stress * sheet.thickness / radius;
  // Next order: a few times the strain.
  expect_relative(logarithmic_sphere({sheet, radius}, p).hoop_stretch - 1.0, 0.5e-6 * (1.0 - nu), 1e-5);
  expect_relative(logarithmic_fixed_cylinder({sheet, radius}, p).hoop_stretch - 1.0, 1e-6 * (1.0 - nu * nu),
                  1e-5);
  const LogarithmicBag closed = logarithmic_closed_cylinder({sheet, radius}, p);
  expect_relative(closed.hoop_stretch - 1.0, 1e-6 * (1.0 - 0.5 * nu), 1e-5);
  expect_relative(closed.axial_stretch - 1.0, 1e-6 * (0.5 - nu), 1e-4);
}

TEST(ClosedFormLogarithmic, refuses_what_is_out_of_validity) {
  const StretchedSphere sphere{paper_fabric(), 0.3};
  EXPECT_NO_THROW(logarithmic_sphere(sphere, 86e3));  // 2 h K / (2 R sqrt(e)) = 86.6 kPa
  expect_refused([&] { logarithmic_sphere(sphere, 87e3); }, "overpressure");
  expect_refused([&] { logarithmic_sphere(sphere, -1.0); }, "overpressure");
  expect_refused([&] { logarithmic_sphere({paper_fabric(), 0.0}, 1e3); }, "radius");
  expect_refused([&] { logarithmic_fixed_cylinder({paper_fabric(), 0.15}, 1e6); }, "overpressure");
  expect_refused([&] { logarithmic_closed_cylinder({paper_fabric(), 0.15}, 1e6); }, "overpressure");
  expect_refused([&] { logarithmic_strip(paper_fabric(), 0.99); }, "stretch");
  expect_refused([&] { logarithmic_strip(paper_fabric(), 1.7); }, "stretch");
  expect_refused([&] { logarithmic_strip({-1.0, 0.3, 1e-3, 1.0}, 1.1); }, "young_modulus");
}

}  // namespace
