// SPDX-License-Identifier: Apache-2.0
#include "closed_form/membrane.hpp"

#include <cmath>

#include "check.hpp"

namespace closed_form {
namespace {

double plane_stress_modulus(const Sheet& sheet) {
  return sheet.young_modulus / (1.0 - sheet.poisson_ratio * sheet.poisson_ratio);
}

}  // namespace

Sheet paper_fabric() {
  return {60e6, 0.3, 0.5e-3, 620.0};
}

WaveSpeeds wave_speeds(const Sheet& sheet) {
  check::sheet(sheet, true);
  const double shear = sheet.young_modulus / (2.0 * (1.0 + sheet.poisson_ratio));
  return {std::sqrt(plane_stress_modulus(sheet) / sheet.density),
          std::sqrt(sheet.young_modulus / sheet.density), std::sqrt(shear / sheet.density)};
}

StretchedWaveSpeeds stretched_wave_speeds(const Sheet& sheet, double stretch) {
  check::sheet(sheet, true);
  if (!(std::isfinite(stretch) && stretch >= 1.0))
    check::refuse("stretch", stretch, "must be finite and >= 1");
  const double c2 = plane_stress_modulus(sheet) / sheet.density;
  return {std::sqrt(c2 * (3.0 * stretch * stretch - 1.0) / 2.0),
          std::sqrt(c2 * (stretch - 1.0) * (stretch + 1.0) / 2.0)};
}

PlaneStress hooke_plane_stress(const Sheet& sheet, double e11, double e22, double e12) {
  check::sheet(sheet, false);
  const double modulus = plane_stress_modulus(sheet), nu = sheet.poisson_ratio;
  return {modulus * (e11 + nu * e22), modulus * (e22 + nu * e11), sheet.young_modulus / (1.0 + nu) * e12};
}

UniaxialState uniaxial_tension(const Sheet& sheet, double stretch) {
  check::sheet(sheet, false);
  check::positive("stretch", stretch);
  const double twice_strain = (stretch - 1.0) * (stretch + 1.0);
  const double across = 1.0 - sheet.poisson_ratio * twice_strain;
  if (across <= 0.0) check::refuse("stretch", stretch, "nu (stretch^2 - 1) must be < 1");
  const double stress = 0.5 * sheet.young_modulus * twice_strain;
  return {stress, std::sqrt(across), stretch * stress};
}

PlaneStress simple_shear(const Sheet& sheet, double shear) {
  check::sheet(sheet, false);
  check::finite("shear", shear);
  return hooke_plane_stress(sheet, 0.0, 0.5 * shear * shear, 0.5 * shear);
}

}  // namespace closed_form
