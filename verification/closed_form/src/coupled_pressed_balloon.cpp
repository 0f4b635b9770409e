// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "check.hpp"
#include "closed_form/coupled.hpp"
#include "strain.hpp"

// Unknowns over the angle psi of the unstretched sphere from the pole: distance rho from the axis, height z,
// angle phi of the meridian below the horizontal, meridional stretch l1; and two integrals.
namespace closed_form {
namespace {

using std::numbers::pi;

constexpr double kSmallestPatch = 1e-4;  // [rad]

enum Unknown { kRho, kHeight, kSlope, kStretch, kStrainEnergy, kVolume, kUnknowns };
using Meridian = std::array<double, kUnknowns>;

struct Skin {
  double modulus, poisson, radius;  // [N/m] E h/(1 - nu^2), [-], [m]
  double pressure, indenter;        // [Pa], [m]
  bool in_patch = true;
  bool taut = true;  // so far
};

struct Tensions {
  double hoop_stretch, first, second;  // [-], [N/m] per unstretched length: P1, P2
  double energy;                       // [J/m2] per unstretched area
  double slope1, slope2;               // dP1/dl1, dP1/dl2
};

Tensions tensions(const Skin& skin, double psi, const double y[]) {
  const double l1 = y[kStretch], l2 = y[kRho] / (skin.radius * std::sin(psi)), nu = skin.poisson;
  const double e1 = green_lagrange(l1), e2 = green_lagrange(l2), d = skin.modulus;
  return {l2,
          d * l1 * (e1 + nu * e2),
          d * l2 * (e2 + nu * e1),
          0.5 * d * (e1 * e1 + e2 * e2 + 2.0 * nu * e1 * e2),
          d * (e1 + nu * e2 + l1 * l1),
          d * nu * l1 * l2};
}

// d(P1 sin psi)/dpsi = P2 cos phi along the meridian; across it the skin follows the indenter in the patch,
// and P1 sin psi dphi/dpsi = p rho l1 - P2 sin phi beyond.
int meridian_slopes(double psi, const double y[], double dydpsi[], void* given) {
  Skin& skin = *static_cast<Skin*>(given);
  const Tensions t = tensions(skin, psi, y);
  if (!(std::isfinite(t.energy) && t.slope1 > 0.0)) return GSL_EBADFUNC;
  skin.taut = skin.taut && t.first > 0.0 && t.second > 0.0;
  const double sine = std::sin(psi), cosine = std::cos(psi), l1 = y[kStretch];
  const double across = std::cos(y[kSlope]), down = std::sin(y[kSlope]);
  dydpsi[kRho] = skin.radius * l1 * across;
  dydpsi[kHeight] = -skin.radius * l1 * down;
  dydpsi[kSlope] = skin.in_patch ? -l1 * skin.radius / skin.indenter
                                 : (skin.pressure * y[kRho] * l1 - t.second * down) / (t.first * sine);
  const double hoop_rate = (l1 * across - t.hoop_stretch * cosine) / sine;
  dydpsi[kStretch] = ((t.second * across - t.first * cosine) / sine - t.slope2 * hoop_rate) / t.slope1;
  dydpsi[kStrainEnergy] = 2.0 * pi * skin.radius * skin.radius * sine * t.energy;
  dydpsi[kVolume] = -pi * y[kRho] * y[kRho] * dydpsi[kHeight];
  return 0;
}

struct Shot {
  bool arrived = false, taut = false;
  double miss = 0.0;  // [rad] of the equator's vertical meridian
  Meridian equator{};
  double force = 0.0, patch_area = 0.0;
};

Shot shoot(Skin skin, double pole_stretch, double patch_angle) {
  gsl_odeiv2_system system{meridian_slopes, nullptr, kUnknowns, &skin};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver{
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-6, 1e-14, 1e-13),
      &gsl_odeiv2_driver_free};
  gsl_odeiv2_driver_set_nmax(driver.get(), 5000);
  // The pole is a regular point: off by the square of this angle, which shifts the stretch there, no more.
  double psi = 0.1 * kSmallestPatch;
  Meridian y{pole_stretch * skin.radius * psi, 0.0, -pole_stretch * skin.radius * psi / skin.indenter,
             pole_stretch};
  Shot shot;
  skin.in_patch = true;
  if (gsl_odeiv2_driver_apply(driver.get(), &psi, patch_angle, y.data()) != 0) return shot;
  shot.patch_area = pi * y[kRho] * y[kRho];
  const double pull = tensions(skin, psi, y.data()).first * skin.radius * std::sin(psi);
  shot.force = skin.pressure * shot.patch_area - 2.0 * pi * pull * std::sin(y[kSlope]);
  skin.in_patch = false;
  gsl_odeiv2_driver_reset(driver.get());
  if (gsl_odeiv2_driver_apply(driver.get(), &psi, 0.5 * pi, y.data()) != 0) return shot;
  shot.arrived = std::isfinite(y[kSlope]);
  shot.taut = skin.taut;
  shot.miss = y[kSlope] - 0.5 * pi;
  shot.equator = y;
  return shot;
}

// The pole's stretch by the secant rule from a guess near it; 0 if there is none.
double aim(const Skin& skin, double guess, double patch_angle) {
  double last = guess, next = guess * (1.0 + 1e-6);
  Shot before = shoot(skin, last, patch_angle);
  for (int i = 0; i < 50 && before.arrived; ++i) {
    const Shot now = shoot(skin, next, patch_angle);
    if (!now.arrived) return 0.0;
    if (std::abs(now.miss) < 1e-12 || now.miss == before.miss) return next;
    const double step = -now.miss * (next - last) / (now.miss - before.miss);
    last = next;
    before = now;
    next += std::clamp(step, -0.01, 0.01);
  }
  return 0.0;
}

}  // namespace

BalloonPress pressed_balloon(const PressedBalloon& scene, double patch_angle) {
  check::positive("overpressure", scene.overpressure);
  const double free_stretch = stretched_sphere(scene.sphere, scene.overpressure).stretch;
  check::positive("indenter_radius", scene.indenter_radius);
  if (scene.indenter_radius < scene.sphere.radius)
    check::refuse("indenter_radius", scene.indenter_radius, "must be at least the radius of the sphere");
  // A skin as good as rigid leaves the shooting nothing to find; one that is so soft bursts.
  if (!(free_stretch > 1.0001 && free_stretch < 10.0))
    check::refuse("overpressure", scene.overpressure,
                  "must stretch the free balloon by more than 1.0001 and less than 10");
  check::within("patch_angle", patch_angle, kSmallestPatch, 0.6);
  const Sheet& sheet = scene.sphere.sheet;
  const double nu = sheet.poisson_ratio;
  const Skin skin{sheet.young_modulus * sheet.thickness / (1.0 - nu * nu), nu, scene.sphere.radius,
                  scene.overpressure, scene.indenter_radius};
  // The patch grows from nothing, so that each root is near the one before.
  const int stages = 1 + static_cast<int>(patch_angle / 0.05);
  double stretch = free_stretch;
  for (int i = 1; i <= stages && stretch > 0.0; ++i) stretch = aim(skin, stretch, patch_angle * i / stages);
  const Shot shot = shoot(skin, stretch > 0.0 ? stretch : free_stretch, patch_angle);
  if (!(stretch > 0.0 && shot.arrived && shot.taut && std::abs(shot.miss) < 1e-9))
    check::refuse("patch_angle", patch_angle, "the skin has no taut equilibrium at it");
  return {shot.force,
          scene.indenter_radius - shot.equator[kHeight],
          shot.patch_area,
          stretch,
          2.0 * shot.equator[kStrainEnergy],
          2.0 * shot.equator[kVolume]};
}

}  // namespace closed_form
