// SPDX-License-Identifier: Apache-2.0
#include "closed_form/weave.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "check.hpp"

namespace closed_form {
namespace {

void check_sheet(const WovenSheet& s) {
  check::positive("warp_modulus", s.warp_modulus, "weft_modulus", s.weft_modulus, "shear_modulus",
                  s.shear_modulus);
  check::finite("poisson_ratio", s.poisson_ratio);
  if (!(s.poisson_ratio * s.poisson_ratio * s.weft_modulus < s.warp_modulus))
    check::refuse("poisson_ratio", s.poisson_ratio, "its square must be < warp_modulus / weft_modulus");
}

struct Direction {
  double strain, strain_slope;          // along it, and d/d angle
  double compliance, compliance_slope;  // 1/E, and d/d angle
  // Rises where half its product E <strain>^2 does.
  double slope() const { return strain_slope * compliance - 0.5 * strain * compliance_slope; }
  double energy() const { return strain > 0.0 ? 0.5 * strain * strain / compliance : 0.0; }
};

Direction direction(const WovenSheet& sheet, double e11, double e22, double e12, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double a1 = 1.0 / sheet.warp_modulus, a2 = 1.0 / sheet.weft_modulus;
  const double mixed = 1.0 / sheet.shear_modulus - 2.0 * sheet.poisson_ratio * a1;
  return {e11 * c * c + e22 * s * s + 2.0 * e12 * c * s, 2.0 * ((e22 - e11) * c * s + e12 * (c * c - s * s)),
          a1 * c * c * c * c + a2 * s * s * s * s + mixed * c * c * s * s,
          4.0 * c * s * (a2 * s * s - a1 * c * c) + 2.0 * mixed * c * s * (c * c - s * s)};
}

WovenState taut_state(const WovenSheet& sheet, double e11, double e22, double e12) {
  const double nu21 = sheet.poisson_ratio * sheet.weft_modulus / sheet.warp_modulus;
  const double reciprocal = 1.0 - sheet.poisson_ratio * nu21;
  WovenState s;
  s.s11 = sheet.warp_modulus * (e11 + nu21 * e22) / reciprocal;
  s.s22 = sheet.weft_modulus * (e22 + sheet.poisson_ratio * e11) / reciprocal;
  s.s12 = 2.0 * sheet.shear_modulus * e12;
  s.energy_density = 0.5 * (s.s11 * e11 + s.s22 * e22) + s.s12 * e12;
  s.tension_angle = std::numeric_limits<double>::quiet_NaN();
  return s;
}

// Angle of the greatest energy: the best of a scan, then the sign change of the slope next to it.
double tension_angle(const WovenSheet& sheet, double e11, double e22, double e12) {
  constexpr int scan = 2000;
  const double spacing = std::numbers::pi / scan;
  const auto at = [&](double angle) { return direction(sheet, e11, e22, e12, angle); };
  double best = 0.0;
  for (int i = 1; i < scan; ++i)
    if (at(i * spacing).energy() > at(best).energy()) best = i * spacing;
  double low = best - spacing, high = best + spacing;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).slope() > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double off_axis_modulus(const WovenSheet& sheet, double angle) {
  check_sheet(sheet);
  check::finite("angle", angle);
  return 1.0 / direction(sheet, 0.0, 0.0, 0.0, angle).compliance;
}

WovenState woven_tension_field(const WovenSheet& sheet, double e11, double e22, double e12) {
  check_sheet(sheet);
  check::finite("e11", e11, "e22", e22, "e12", e12);
  const WovenState taut = taut_state(sheet, e11, e22, e12);
  if (taut.s11 + taut.s22 >= 0.0 && taut.s11 * taut.s22 >= taut.s12 * taut.s12) return taut;
  const double angle = tension_angle(sheet, e11, e22, e12);
  const Direction d = direction(sheet, e11, e22, e12, angle);
  const double c = std::cos(angle), s = std::sin(angle);
  const double tension = d.strain > 0.0 ? d.strain / d.compliance : 0.0;
  const double turned = angle < 0.0 ? angle + std::numbers::pi : angle;
  return {tension * c * c, tension * s * s, tension * c * s, d.energy(),
          tension > 0.0 ? turned : std::numeric_limits<double>::quiet_NaN()};
}

double cylinder_by_curve(const StripCurve& curve, double thickness, double radius, double overpressure) {
  check::positive("thickness", thickness, "radius", radius);
  check::non_negative("overpressure", overpressure);
  if (curve.strain.size() < 2 || curve.strain.size() != curve.stress.size())
    check::refuse("curve", static_cast<double>(curve.strain.size()), "2 points or more, a stress for each");
  const double pull = overpressure * radius / thickness;  // of the stress over the stretch
  for (std::size_t i = 1; i < curve.strain.size(); ++i) {
    if (!(curve.strain[i] > curve.strain[i - 1] && curve.stress[i] > curve.stress[i - 1]))
      check::refuse("curve", curve.strain[i], "must rise strictly");
    if (curve.stress[i] < pull * (1.0 + curve.strain[i])) continue;
    const double slope = (curve.stress[i] - curve.stress[i - 1]) / (curve.strain[i] - curve.strain[i - 1]);
    return (slope * (1.0 + curve.strain[i - 1]) - curve.stress[i - 1]) / (slope - pull);
  }
  check::refuse("overpressure", overpressure, "the curve ends before its equilibrium");
}

}  // namespace closed_form
