// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/membrane.hpp"
#include "strain.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

const Sheet& check_balloon(const Sheet& sheet, double radius, double overpressure) {
  check::sheet(sheet, false);
  check::positive("radius", radius);
  check::non_negative("overpressure", overpressure);
  return sheet;
}

// Biaxial modulus E/(1 - nu).
double biaxial_modulus(const Sheet& sheet) {
  return sheet.young_modulus / (1.0 - sheet.poisson_ratio);
}

}  // namespace

SphereStretch stretched_sphere(const StretchedSphere& sphere, double overpressure) {
  const Sheet& sheet = check_balloon(sphere.sheet, sphere.radius, overpressure);
  const double modulus = biaxial_modulus(sheet);
  const double q = overpressure * sphere.radius / (modulus * sheet.thickness);
  const double stretch = 0.5 * (q + std::sqrt(q * q + 4.0));
  const double strain = 0.5 * q * stretch;  // lambda^2 - 1 = q lambda
  const double radius = stretch * sphere.radius;
  return {stretch, modulus * strain, 4.0 / 3.0 * pi * radius * radius * radius,
          4.0 * pi * sphere.radius * sphere.radius * sheet.thickness * modulus * strain * strain};
}

double stretched_sphere_pressure(const StretchedSphere& sphere, double stretch) {
  check_balloon(sphere.sheet, sphere.radius, 0.0);
  if (!(std::isfinite(stretch) && stretch >= 1.0))
    check::refuse("stretch", stretch, "must be finite and >= 1");
  return biaxial_modulus(sphere.sheet) * sphere.sheet.thickness / sphere.radius * 2.0 *
         green_lagrange(stretch) / stretch;
}

double sphere_breathing_frequency(const StretchedSphere& sphere, double overpressure, double ambient_pressure,
                                  double heat_capacity_ratio) {
  const double stretch = stretched_sphere(sphere, overpressure).stretch;
  check::sheet(sphere.sheet, true);
  check::non_negative("ambient_pressure", ambient_pressure);
  check::within("heat_capacity_ratio", heat_capacity_ratio, 0.0, 3.0);
  const double radius = sphere.radius;
  const double modulus = biaxial_modulus(sphere.sheet) * (3.0 * stretch * stretch - 1.0) / 2.0;
  const double gas = 3.0 * heat_capacity_ratio * (ambient_pressure + overpressure) * stretch / radius;
  const double stiffness = 2.0 * sphere.sheet.thickness * modulus / (radius * radius) -
                           2.0 * overpressure * stretch / radius + gas;
  return std::sqrt(stiffness / (sphere.sheet.density * sphere.sheet.thickness));
}

double sphere_breathing_decay(const StretchedSphere& sphere, double overpressure, double beta) {
  const double stretch = stretched_sphere(sphere, overpressure).stretch;
  check::sheet(sphere.sheet, true);
  check::non_negative("beta", beta);
  const double length = sphere.radius / stretch;
  return beta * biaxial_modulus(sphere.sheet) / (sphere.sheet.density * length * length);
}

double damped_swing(double omega, double beta, double time) {
  check::positive("omega", omega);
  check::non_negative("time", time, "beta", beta);
  const double ratio = 0.5 * beta * omega;
  if (!(ratio < 1.0)) check::refuse("beta", beta, "must be below 2 / omega");
  const double root = std::sqrt((1.0 - ratio) * (1.0 + ratio)), phase = root * omega * time;
  return std::exp(-ratio * omega * time) * (std::cos(phase) + ratio / root * std::sin(phase));
}

CylinderStretch fixed_length_cylinder(const StretchedCylinder& cylinder, double overpressure) {
  const Sheet& sheet = check_balloon(cylinder.sheet, cylinder.radius, overpressure);
  const double stress = overpressure * cylinder.radius / sheet.thickness;
  const double nu = sheet.poisson_ratio;
  const double strain = (1.0 - nu * nu) * stress / sheet.young_modulus;
  return {std::sqrt(1.0 + 2.0 * strain), 1.0, stress, nu * stress};
}

CylinderStretch closed_cylinder(const StretchedCylinder& cylinder, double overpressure) {
  const Sheet& sheet = check_balloon(cylinder.sheet, cylinder.radius, overpressure);
  const double nu = sheet.poisson_ratio;
  const double modulus = sheet.young_modulus / (1.0 - nu * nu);
  const double whole_load = overpressure * cylinder.radius / (sheet.thickness * modulus);
  double u = 0.0, w = 0.0;  // lambda_h - 1, lambda_z - 1
  // Newton follows the load, so that it stays on the branch of the unstretched cylinder.
  const int stages = 1 + static_cast<int>(std::fmin(8.0 * whole_load, 800.0));
  for (int iteration = 0; iteration < 50 + stages; ++iteration) {
    const double load = whole_load * std::fmin(1.0, (iteration + 1.0) / stages);
    const double h = 1.0 + u, z = 1.0 + w, eh = u * (1.0 + 0.5 * u), ez = w * (1.0 + 0.5 * w);
    const double f1 = eh + nu * ez - load * z;  // hoop: S_h = p R lambda_z / h
    const double f2 =
        z * (ez + nu * eh) - 0.5 * load * h * h;  // axial: lambda_z S_z = p R lambda_h^2 / (2 h)
    const double a11 = h;
    const double a12 = nu * z - load;
    const double a21 = z * nu * h - load * h;
    const double a22 = ez + nu * eh + z * z;
    const double det = a11 * a22 - a12 * a21;
    const double du = (f1 * a22 - f2 * a12) / det;
    const double dw = (f2 * a11 - f1 * a21) / det;
    u -= du;
    w -= dw;
    if (iteration >= stages && std::abs(du) + std::abs(dw) <= 1e-16 * (std::abs(u) + std::abs(w))) break;
  }
  if (!(u >= 0.0 && u < 9.0 && w > -1.0 && w < 9.0))
    check::refuse("overpressure", overpressure, "the closed cylinder has no moderate equilibrium at it");
  const double eh = u * (1.0 + 0.5 * u), ez = w * (1.0 + 0.5 * w);
  return {1.0 + u, 1.0 + w, modulus * (eh + nu * ez), modulus * (ez + nu * eh)};
}

}  // namespace closed_form
