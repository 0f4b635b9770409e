// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/membrane.hpp"

/// Inflated bags of a sheet whose Cauchy stress is linear in logarithmic (Hencky) strain and whose thickness
/// h stays. With the mean m and half the difference r of the logarithmic strains, K = E/(1 - nu) and G = E/(1
/// + nu), it has
///   W = K (exp(2m) (m - 1/2) + 1/2) + G r^2 exp(2m) per reference volume,
///   sigma = K m + G r^2 +- G r.
/// All functions throw std::invalid_argument, naming the field, for a parameter that is missing or out of
/// validity, and for an overpressure that stretches beyond exp(1/2).
namespace closed_form {

/// State of a bag under pressure.
struct LogarithmicBag {
  double hoop_stretch = 0.0;   // [-] along the circumference
  double axial_stretch = 0.0;  // [-] across; the same for a sphere
  double hoop_stress = 0.0;    // [Pa] Cauchy
  double axial_stress = 0.0;   // [Pa] Cauchy
  /// [J/m3] W, per reference volume of the sheet.
  double energy_density = 0.0;
};

/// Sphere at overpressure [Pa] >= 0: 2 h K ln(lambda)/lambda = p R0. Source: derived here.
LogarithmicBag logarithmic_sphere(const StretchedSphere& sphere, double overpressure);
/// Cylinder of fixed length: h (K m + G m^2 + G m) = p R0 lambda, m = r = ln(lambda)/2. Source: derived here.
LogarithmicBag logarithmic_fixed_cylinder(const StretchedCylinder& cylinder, double overpressure);
/// Long cylinder with closed, free ends: sigma_h = 2 sigma_z = p R0 lambda_h/h, hence K m = 3 G r - G r^2.
/// Source: derived here.
LogarithmicBag logarithmic_closed_cylinder(const StretchedCylinder& cylinder, double overpressure);

/// Strip pulled along one axis, free to contract and to wrinkle.
struct LogarithmicStrip {
  double transverse_stretch = 0.0;  // [-] of the strip as long as it is smooth
  double stress = 0.0;              // [Pa] Cauchy, 2 G r
  double energy_density = 0.0;      // [J/m3] as above
};
/// Strip at a stretch from 1 to exp(1/2): K m + G r^2 = G r with m + r = ln(stretch), hence
///   stress = E ln(stretch) 2/(1 + sqrt(1 - (1 - nu^2) ln(stretch))).
/// Source: derived here.
LogarithmicStrip logarithmic_strip(const Sheet& sheet, double stretch);

}  // namespace closed_form
