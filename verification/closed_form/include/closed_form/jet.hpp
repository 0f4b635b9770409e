// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

/// Closed forms of free jets with a Gaussian profile that conserves axial momentum, and of their forces on
/// targets. All functions throw std::invalid_argument, naming the field, for a parameter that is missing or
/// out of validity.
namespace closed_form {

/// Jet from a round outlet.
struct RoundJet {
  double radius = kRequired;     // [m] R0 > 0
  double spread = 0.08;          // [-] a > 0, turbulence structure coefficient
  double outlet_velocity = 1.0;  // [m/s] V0 > 0
  double outlet_density = 1.0;   // [kg/m3] rho0 > 0
};
/// Jet from a slit; it is uniform along the long side.
struct PlaneJet {
  double half_width = kRequired;  // [m] b0 > 0
  double length = 1.0;            // [m] long side of the outlet, > 0
  double spread = 0.11;           // [-] a > 0
  double outlet_velocity = 1.0;   // [m/s] V0 > 0
  double outlet_density = 1.0;    // [kg/m3] rho0 > 0
};

/// Cross-section of the jet at one axial distance z.
struct JetSection {
  double centreline_velocity = 0.0;  // [m/s]
  double width = 0.0;                // [m] R or b, as in exp(-(r/R)^2)
  double momentum_flux = 0.0;        // [N] rho0 int V^2 dA; rho0 V0^2 A0 at every z
  double volume_flux_ratio = 0.0;    // [-] Q/Q0
  double energy_flux_ratio = 0.0;    // [-] K/K0
};

/// Centreline velocity Vm/V0 = min(1, 0.96/(a z/R0 + 0.29)) [-], z/R0 >= 0. Source: G. N. Abramovich, The
/// Theory of Turbulent Jets (textbook result).
double round_centreline_ratio(double spread, double distance_over_radius);
/// Centreline velocity Vm/V0 = min(1, 1.2/sqrt(a z/b0 + 0.41)) [-], z/b0 >= 0. Source: as above.
double plane_centreline_ratio(double spread, double distance_over_half_width);
/// Core length over R0 [-], (0.96 - 0.29)/a = 0.67/a.
double round_core_length(double spread);
/// Core length over b0 [-], (1.44 - 0.41)/a = 1.03/a.
double plane_core_length(double spread);

/// Section at z = `distance` [m] >= 0: R = sqrt 2 R0 V0/Vm, Q/Q0 = 2 V0/Vm, K/K0 = (2/3) Vm/V0. Source:
/// derived here.
JetSection round_jet_section(const RoundJet& jet, double distance);
/// Section at z = `distance` [m] >= 0: b = 2 sqrt(2/pi) b0 (V0/Vm)^2, Q/Q0 = sqrt 2 V0/Vm, K/K0 = sqrt(2/3)
/// Vm/V0. Source: derived here.
JetSection plane_jet_section(const PlaneJet& jet, double distance);
/// Velocity [m/s] at axial distance z >= 0 [m] and distance r [m] from the axis.
double round_jet_velocity(const RoundJet& jet, double distance, double r);
/// Velocity [m/s] at axial distance z >= 0 [m] and distance r [m] from the mid plane.
double plane_jet_velocity(const PlaneJet& jet, double distance, double r);

/// Far-field constants [-] that experiments report.
struct RoundFarField {
  double decay_constant = 0.0;     // B = 0.48/a in Vm/V0 = B D/(z + z0)
  double half_width_slope = 0.0;   // S = sqrt(2 ln 2) a/0.96
  double entrainment_slope = 0.0;  // d(Q/Q0)/d(z/D) = 4 a/0.96
};
/// The same for a plane jet.
struct PlaneFarField {
  double decay_constant = 0.0;    // K = 2 a/1.44 in (V0/Vm)^2 = K z/h + ..., h = 2 b0
  double half_width_slope = 0.0;  // 2 sqrt(2/pi) sqrt(ln 2) a/1.44
};
/// Constants of a round jet, a > 0. Source: the sections above far from the outlet, derived here.
RoundFarField round_far_field(double spread);
/// Constants of a plane jet, a > 0. Source: as above.
PlaneFarField plane_far_field(double spread);

/// Round jet of a compressible gas, at or below the speed of sound and not underexpanded.
struct CompressibleJet {
  double mach = kRequired;     // [-] of the outlet, 0 to 1
  double density_ratio = 1.0;  // [-] outlet over surroundings, > 0
};
/// Centreline velocity Vm/V0 [-] at `distance_over_diameter` >= 0: 1 - exp(-1/t), or 1 in the core t <= 0;
/// t = 2 kappa (z/D) / sqrt(density_ratio) - 0.70, kappa = 0.08 (1 - 0.16 mach) density_ratio^0.22.
/// Source: P. O. Witze, AIAA J. 12(4), 1974, pp. 417-418, at second hand: form and constants as E. Franquet,
/// V. Perrier, S. Gibout and P. Bruel print them (Prog. Aerosp. Sci. 77, 2015, pp. 25-53); they give this
/// branch to mach = 0.81. The sign of 0.22 is from a published program alone, and three measured jets do not
/// confirm it. They agree with the law to 4 to 10 % (r.m.s. over 6 to 20 diameters), one of them at 0.985.
double witze_centreline_ratio(const CompressibleJet& jet, double distance_over_diameter);
/// Core length over D [-], 0.35 sqrt(density_ratio)/kappa, where the ratio leaves 1; it has fallen to 0.99
/// at 1.3 times that length.
double witze_core_length(const CompressibleJet& jet);
/// B [-] in Vm/V0 = B D/z far from the outlet, sqrt(density_ratio)/(2 kappa).
double witze_decay_constant(const CompressibleJet& jet);

/// Constants of Tollmien's mixing-length similarity solution, phi = r/(a z).
struct TollmienConstants {
  double edge = 0.0;               // [-] phi_e where the velocity is 0
  double half_velocity = 0.0;      // [-] phi where V = Vm/2
  double momentum_integral = 0.0;  // [-] int f^2 phi dphi (round), int f^2 dphi (plane)
  double flux_integral = 0.0;      // [-] int f phi dphi (round), int f dphi (plane)
  double decay_constant = 0.0;     // C in Vm/V0 = C/(a z/R0) or C/sqrt(a z/b0)
};
/// Constants of the round jet, by its ODE (Taylor start, Runge-Kutta). Source: W. Tollmien (1926); derived
/// here.
TollmienConstants tollmien_round();
/// Constants of the plane jet, by Beta functions. Source: as above.
TollmienConstants tollmien_plane();

/// Sonic outlet. With a static temperature it is the formula printed in "Gas Jet Model for Airbag Inflators".
struct SonicOutlet {
  PerfectGas gas;                  // of the inflator
  double temperature = kRequired;  // [K] > 0, static or stagnation
  bool stagnation = false;         // true: `temperature` is the stagnation temperature
  double mass_flow = kRequired;    // [kg/s] > 0
  double area = kRequired;         // [m2] > 0
};
/// State of the gas in the outlet.
struct OutletState {
  double velocity = 0.0;       // [m/s] sqrt(gamma R T), times sqrt(2/(gamma+1)) for stagnation
  double density = 0.0;        // [kg/m3] mdot/(A V0)
  double momentum_flux = 0.0;  // [N] mdot V0
  /// [Pa] rho0 R T_static; the formula does not tie it to the bag's pressure.
  double static_pressure = 0.0;
};
/// State of uniform flow at the speed of sound. Source: static temperature as printed there; stagnation
/// temperature: isentropic flow, textbook result.
OutletState sonic_outlet(const SonicOutlet& outlet);

/// Sonic outlet with gas from rest, at a pressure above that around it.
struct ExpandedOutlet {
  PerfectGas gas;                             // of the inflator
  double stagnation_temperature = kRequired;  // [K] T_s > 0
  double area = kRequired;                    // [m2] A > 0
  double bag_pressure = kRequired;            // [Pa] p > 0, around the outlet
  double pressure_ratio = kRequired;          // [-] n = pe/p >= 1, pe in the outlet
};
/// Uniform flow at bag pressure with the outlet's mass, momentum and stagnation enthalpy.
struct NotionalNozzle {
  double mass_flow = 0.0;    // [kg/s] mdot
  double velocity = 0.0;     // [m/s] V
  double density = 0.0;      // [kg/m3] p/(R T)
  double temperature = 0.0;  // [K] static
  double area_ratio = 0.0;   // [-] over the outlet's area
  double thrust = 0.0;       // [N] mdot V0 + (pe - p) A
};
/// State of the notional nozzle: V/V0 = 1 + (1 - 1/n)/gamma, T/T_s = 1 - (gamma-1)/(gamma+1) (V/V0)^2, area
/// ratio n (T/T0) V0/V, thrust p A (n (1 + gamma) - 1); V0 and T0 are the sonic outlet's. Source: balances of
/// mass, momentum and energy between outlet and nozzle, p on all other sides; derived here.
NotionalNozzle expanded_outlet(const ExpandedOutlet& outlet);
/// Force [N] of that jet on an unbounded plate normal to it: thrust + e mdot V0 with the restitution
/// e >= -1 [-]. Source: definition.
double plate_load(const ExpandedOutlet& outlet, double restitution);

/// Force [N] on an unbounded plate normal to the jet, c J with J = rho0 V0^2 A [N]. c = 1 is deflection,
/// c = 2 complete reflection.
double plate_force(double reflection, double momentum_flux);
/// Plate force over c J [-] for a jet of constant width: cos theta, where theta [rad] is the angle between
/// plate normal and axis, |theta| < pi/2. Source: momentum normal to the plate, textbook result.
double inclined_plate_fraction(double theta);
/// The same for a width that grows by width_slope = dR/dz (sqrt 2 a/0.96 for the round jet). p = c rho0
/// (V.n)^2 acts on the part |x| <= extent R(z) of the plate; by quadrature. Needs |s| extent < 1,
/// s = width_slope tan theta. Equals cos(theta) (1 + s^2/4 + 3 s^4/16 + ...) for a wide extent. Source:
/// derived here.
double inclined_plate_fraction(double theta, double width_slope, double extent);

/// Fraction [-] of a round Gaussian jet's momentum on a disc normal to the axis, centred: 1 - exp(-2
/// rho^2/R^2). Here and below the width is R > 0 [m].
double disc_fraction(double disc_radius, double width);
/// On a square, centred: erf(sqrt 2 L/R)^2.
double square_fraction(double half_side, double width);
/// On a half plane: Phi(2 d/R), where d > 0 [m] if the axis is inside.
double half_plane_fraction(double edge_distance, double width);
/// On a disc off the axis by d: 1 - Q1(2 d/R, 2 rho/R), with the Marcum Q function.
double off_axis_disc_fraction(double disc_radius, double offset,
                              double width);  // 1 - Q1(2 d/R, 2 rho/R), Marcum Q

/// Relative error [-] of the centre-of-element rule on a square lattice of spacing h over an unbounded plate,
/// with one corner of the lattice on the axis. A theta-function sum, leading -4 exp(-pi^2 R^2/(2 h^2)).
/// spacing_over_width = h/R > 0.
double lattice_quadrature_error(double spacing_over_width);

}  // namespace closed_form
