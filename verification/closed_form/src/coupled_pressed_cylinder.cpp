// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/coupled.hpp"

namespace closed_form {
namespace {

// Stretch at the tension over E h/(1 - nu^2): lambda (lambda^2 - 1)/2 = tension >= 0. Newton's iteration
// falls to the root from the right, as the left side is convex.
double stretch_at(double tension) {
  double stretch = 1.0 + std::fmin(tension, std::cbrt(2.0 * tension));
  for (int iteration = 0; iteration < 60; ++iteration)
    stretch -= (0.5 * stretch * (stretch * stretch - 1.0) - tension) / (1.5 * stretch * stretch - 0.5);
  return stretch;
}

}  // namespace

// (K.61)
CylinderPress pressed_cylinder(const PressedCylinder& scene, double half_distance) {
  const Sheet& sheet = check::sheet(scene.sheet, false);
  check::positive("radius", scene.radius, "overpressure", scene.overpressure, "half_distance", half_distance);
  const double nu = sheet.poisson_ratio;
  const double tension = scene.overpressure * half_distance * (1.0 - nu * nu);
  const double stretch = stretch_at(tension / (sheet.young_modulus * sheet.thickness));
  const double width = std::numbers::pi * (stretch * scene.radius - half_distance);
  if (width < 0.0) check::refuse("half_distance", half_distance, "must be at most the inflated radius");
  return {scene.overpressure * width, width, stretch,
          half_distance * (std::numbers::pi * half_distance + 2.0 * width)};
}

}  // namespace closed_form
