// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "closed_form/common.hpp"

/// Woven (orthotropic) sheet in plane stress, with and without compression. Axes: 1 along the warp, 2 along
/// the weft. All functions throw std::invalid_argument, naming the field, for a parameter that is missing or
/// out of validity.
namespace closed_form {

/// Fabric of warp and weft.
struct WovenSheet {
  double warp_modulus = kRequired;  // E1 [Pa] > 0
  double weft_modulus = kRequired;  // E2 [Pa] > 0
  /// nu_12 [-], nu_12^2 < E1/E2: contraction of the weft in tension along the warp.
  double poisson_ratio = kRequired;
  double shear_modulus = kRequired;  // G [Pa] > 0
};

/// Modulus [Pa], stress over strain, of a strip cut at `angle` [rad] to the warp:
///   1/E(a) = c^4/E1 + s^4/E2 + (1/G - 2 nu/E1) c^2 s^2.
/// Source: textbooks of composite laminates (Jones, Mechanics of Composite Materials, section 2.6).
double off_axis_modulus(const WovenSheet& sheet, double angle);

/// Stress and energy of a sheet without compression.
struct WovenState {
  double s11 = 0.0;             // [Pa] along the warp
  double s22 = 0.0;             // [Pa] along the weft
  double s12 = 0.0;             // [Pa] shear
  double energy_density = 0.0;  // [J/m3]
  /// [rad] Of the line of tension to the warp, 0 to pi; NaN unless wrinkled.
  double tension_angle = 0.0;
};
/// State of the sheet at a strain (e12: tensor component). It is taut if the stress of the strain has no
/// compression. Else the tension is one-dimensional. By duality W = max over angles of E(a) max(t.Et, 0)^2 /
/// 2, found here by a scan of 2000 directions and bisection of the derivative; 0 if no direction is
/// stretched. Source: relaxed energy of Pipkin 1986; the dual form derived here.
WovenState woven_tension_field(const WovenSheet& sheet, double e11, double e22, double e12);

/// Measured curve of a strip: nominal stress [Pa] over strain [-], both rising strictly from 0.
struct StripCurve {
  std::vector<double> strain;  // [-] of each point
  std::vector<double> stress;  // [Pa] of each point
};
/// Hoop stretch of a long cylinder of fixed length, of threads along the hoop with that curve and nothing
/// else: h P(lambda - 1) = p R lambda, piece by piece. Thickness h and radius R > 0 [m], overpressure p >= 0
/// [Pa]. Refused if the curve ends before. Source: derived here.
double cylinder_by_curve(const StripCurve& curve, double thickness, double radius, double overpressure);

}  // namespace closed_form
