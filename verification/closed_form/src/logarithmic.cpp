// SPDX-License-Identifier: Apache-2.0
#include "closed_form/logarithmic.hpp"

#include <cmath>

#include "check.hpp"

namespace closed_form {
namespace {

constexpr double kLargestLogarithm = 0.5;  // logarithmic strain

struct LogarithmicLaw {
  double spherical, deviator;  // K, G
};

LogarithmicLaw logarithmic_law(const Sheet& sheet) {
  return {sheet.young_modulus / (1.0 - sheet.poisson_ratio),
          sheet.young_modulus / (1.0 + sheet.poisson_ratio)};
}

double logarithmic_energy(const LogarithmicLaw& c, double m, double r) {
  // exp(2m) (m - 1/2) + 1/2, whose terms cancel for small m: its series.
  double spherical = 0.0, power = 2.0 * m * m;
  for (int k = 2; k < 60; ++k, power *= 2.0 * m / k) spherical += 0.5 * (k - 1) * power;
  return c.spherical * spherical + c.deviator * r * r * std::exp(2.0 * m);
}

LogarithmicBag logarithmic_state(const LogarithmicLaw& c, double m, double r) {
  const double middle = c.spherical * m + c.deviator * r * r, shift = c.deviator * r;
  return {std::exp(m + r), std::exp(m - r), middle + shift, middle - shift, logarithmic_energy(c, m, r)};
}

// Root of stress(e) = load exp(e) on the rising branch, 0 <= e <= 1/2, where e is a strain and `stress` rises
// and bends little. Bisection: the branch has one root or none.
template <class Stress>
double strain_at(double load, double overpressure, const Stress& stress) {
  const auto excess = [&](double e) { return stress(e) - load * std::exp(e); };
  if (!(excess(kLargestLogarithm) >= 0.0))
    check::refuse("overpressure", overpressure, "must not stretch the bag by more than exp(1/2)");
  double low = 0.0, high = kLargestLogarithm;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (excess(middle) < 0.0 ? low : high) = middle;
  }
}

double hoop_load(const Sheet& sheet, double radius, double overpressure) {
  check::sheet(sheet, false);
  check::positive("radius", radius);
  check::non_negative("overpressure", overpressure);
  return overpressure * radius / sheet.thickness;
}

}  // namespace

LogarithmicBag logarithmic_sphere(const StretchedSphere& sphere, double overpressure) {
  const double load = hoop_load(sphere.sheet, sphere.radius, overpressure);
  const LogarithmicLaw c = logarithmic_law(sphere.sheet);
  const double m = strain_at(0.5 * load, overpressure, [&](double e) { return c.spherical * e; });
  return logarithmic_state(c, m, 0.0);
}

LogarithmicBag logarithmic_fixed_cylinder(const StretchedCylinder& cylinder, double overpressure) {
  const double load = hoop_load(cylinder.sheet, cylinder.radius, overpressure);
  const LogarithmicLaw c = logarithmic_law(cylinder.sheet);
  const double e = strain_at(load, overpressure, [&](double strain) {
    const double m = 0.5 * strain;
    return c.spherical * m + c.deviator * m * (1.0 + m);
  });
  return logarithmic_state(c, 0.5 * e, 0.5 * e);
}

LogarithmicBag logarithmic_closed_cylinder(const StretchedCylinder& cylinder, double overpressure) {
  const double load = hoop_load(cylinder.sheet, cylinder.radius, overpressure);
  const LogarithmicLaw c = logarithmic_law(cylinder.sheet);
  // r at the hoop strain m + r = e, from K m = 3 G r - G r^2.
  const auto radius_at = [&](double e) {
    const double b = c.spherical + 3.0 * c.deviator;
    return 2.0 * c.spherical * e / (b + std::sqrt(b * b - 4.0 * c.deviator * c.spherical * e));
  };
  const double e =
      strain_at(load, overpressure, [&](double strain) { return 4.0 * c.deviator * radius_at(strain); });
  return logarithmic_state(c, e - radius_at(e), radius_at(e));
}

LogarithmicStrip logarithmic_strip(const Sheet& sheet, double stretch) {
  check::sheet(sheet, false);
  const double strain = std::log(check::within("stretch", stretch, 1.0, std::exp(kLargestLogarithm)));
  const LogarithmicLaw c = logarithmic_law(sheet);
  const double nu = sheet.poisson_ratio;
  const double stress =
      2.0 * sheet.young_modulus * strain / (1.0 + std::sqrt(1.0 - (1.0 - nu * nu) * strain));
  const double r = 0.5 * stress / c.deviator;
  return {std::exp(strain - 2.0 * r), stress, logarithmic_energy(c, strain - r, r)};
}

}  // namespace closed_form
