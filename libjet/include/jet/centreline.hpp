// SPDX-License-Identifier: Apache-2.0
// Free turbulent jets: decay and width along the centreline, pointwise. Source: Abramovich, The Theory of
// Turbulent Jets, 1963 (main region of submerged jets).
#pragma once

namespace jet {

/// Outlets with a tabulated decay coefficient a, of slow jets. The first three are round, the others plane.
enum class OutletType {
  contracting_nozzle,  // 0.066 (to 0.071)
  cylindrical_tube,    // 0.08 (from 0.076)
  guide_vane_fan,      // 0.12, axial fan with guide vanes
  plane_nozzle,        // 0.108, well contracted
  sharp_slot,          // 0.118, sharp-edged slot in a plane wall
  rounded_slot         // 0.155, slot along a duct, vanes and rounded edges
};

/// Decay coefficient a [-] of (J.3) or (J.4). Source: Abramovich's turbulence coefficients as tabulated in
/// Cai and Long, Fluid Mechanics, Pumps and Fans (gas jets), and in Idelchik, Handbook of Hydraulic
/// Resistance. For the spread angles, which are Tollmien's, see docs/theory/jet.md.
double decay_coefficient(OutletType type);

/// Decay of a round jet, V_max / V0 = min(1, 0.96 / (a z/R0 + 0.29)) [-] (J.3). `distance` = z/R0 >= 0 [-],
/// R0 the radius of the outlet.
double round_decay(double distance, double decay_coefficient);

/// Decay of a plane jet, V_max / V0 = min(1, 1.2 / sqrt(a z/b0 + 0.41)) [-] (J.4). `distance` = z/b0 >= 0
/// [-], b0 half the short side.
double plane_decay(double distance, double decay_coefficient);

/// Length of a round jet's core, where V_max = V0: 0.67/a, in outlet radii [-].
double round_core_length(double decay_coefficient);
/// Length of a plane jet's core: 1.03/a, in half short sides [-].
double plane_core_length(double decay_coefficient);

/// Distance of a round jet's virtual origin upstream of the outlet, in outlet radii [-]: 0.29/a. The decay
/// law is singular there.
double round_virtual_origin(double decay_coefficient);
/// The same for a plane jet, in half short sides [-]: 0.41/a.
double plane_virtual_origin(double decay_coefficient);

/// Width of a round jet, R / R0 = sqrt(2) V0/V_max [-]. It conserves the axial momentum flux for V = V_max
/// exp(-(r/R)^2) (J.5). `decay` = V_max / V0 in (0, 1].
double round_momentum_width(double decay);
/// The same for a plane jet, b / b0 = 2 sqrt(2/pi) (V0/V_max)^2 [-].
double plane_momentum_width(double decay);

}  // namespace jet
