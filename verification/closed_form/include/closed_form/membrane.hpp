// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "closed_form/common.hpp"

/// Closed forms of membranes: volumes, inflated shapes, vibration, waves, element states. StVK stands for St.
/// Venant-Kirchhoff: plane stress linear in Green-Lagrange strain, reference thickness. All functions throw
/// std::invalid_argument, naming the field, for a parameter that is missing or out of validity.
namespace closed_form {

/// Isotropic sheet.
struct Sheet {
  double young_modulus = kRequired;  // [Pa] > 0
  double poisson_ratio = kRequired;  // [-] -1 < nu <= 0.5
  double thickness = kRequired;      // [m] > 0
  double density = kRequired;        // [kg/m3] > 0; read only where mass matters
};

/// Fabric of "Gas Jet Model for Airbag Inflators": 60 MPa, 0.3, 0.5 mm, 620 kg/m3.
Sheet paper_fabric();

/// Volume [m3] of the regular icosahedron of edge [m] > 0: 5 (3 + sqrt 5)/12 edge^3.
double icosahedron_volume(double edge);

/// Refined icosahedron compared with its sphere.
struct IcosphereRatios {
  std::size_t faces = 0;      // 20 * 4^level
  double volume_ratio = 0.0;  // mesh volume / sphere volume
  double area_ratio = 0.0;    // mesh area / sphere area
};
/// Icosahedron refined `level` times at the midpoints, each moved to the sphere at once; 0 <= level <= 8.
/// Pure geometry, computed on the mesh. Order 2: faces (1 - volume_ratio) -> 11.08.
IcosphereRatios icosphere_ratios(int level);

/// Spherical StVK balloon.
struct StretchedSphere {
  Sheet sheet;                // its skin
  double radius = kRequired;  // [m] unstretched, > 0
};
/// State of the inflated sphere.
struct SphereStretch {
  double stretch = 0.0;        // [-] lambda = (q + sqrt(q^2 + 4))/2, q = p R0 (1 - nu)/(E h)
  double stress = 0.0;         // [Pa] second Piola-Kirchhoff, E/(1-nu) (lambda^2 - 1)/2
  double volume = 0.0;         // [m3]
  double strain_energy = 0.0;  // [J] 4 pi R0^2 h E/(1-nu) ((lambda^2-1)/2)^2
};
/// State at overpressure [Pa] >= 0. An StVK balloon has no limit point. Source: derived here.
SphereStretch stretched_sphere(const StretchedSphere& sphere, double overpressure);
/// Overpressure E h/((1-nu) R0) (lambda - 1/lambda) [Pa] at stretch lambda >= 1.
double stretched_sphere_pressure(const StretchedSphere& sphere, double stretch);
/// Angular frequency [rad/s] of small breathing about that state, with constant overpressure and enclosed
/// gas:
///   omega^2 = (2 h P'/R0^2 - 2 p lambda/R0 + 3 gamma p_abs lambda/R0)/(rho h), P' = E/(1-nu) (3 lambda^2 -
///   1)/2.
/// heat_capacity_ratio = 0 leaves out the gas. Pressures [Pa]. Needs sheet.density.
double sphere_breathing_frequency(const StretchedSphere& sphere, double overpressure, double ambient_pressure,
                                  double heat_capacity_ratio);

/// Rate [1/s] at which that breathing decays with stiffness-proportional damping beta [s] >= 0, the stress
/// beta dS/dt: beta E lambda^2/((1-nu) rho R0^2). Constant overpressure [Pa]. Needs sheet.density.
double sphere_breathing_decay(const StretchedSphere& sphere, double overpressure, double beta);
/// Swing x(t)/x(0) of one mode, let go at rest, of x'' + beta omega^2 x' + omega^2 x = 0: below critical
/// damping, 0 <= beta omega < 2; omega > 0 [rad/s], time [s] >= 0.
double damped_swing(double omega, double beta, double time);

/// StVK cylinder.
struct StretchedCylinder {
  Sheet sheet;                // its skin
  double radius = kRequired;  // [m] unstretched, > 0
};
/// State of the inflated cylinder.
struct CylinderStretch {
  double hoop_stretch = 0.0;   // [-] sqrt(1 + 2 (1-nu^2) p R/(E h))
  double axial_stretch = 0.0;  // [-] 1 for fixed length
  double hoop_stress = 0.0;    // [Pa] second Piola-Kirchhoff
  double axial_stress = 0.0;   // [Pa] second Piola-Kirchhoff
};
/// State for fixed length at overpressure [Pa] >= 0. Source: derived here.
CylinderStretch fixed_length_cylinder(const StretchedCylinder& cylinder, double overpressure);
/// State for closed, free ends: hoop S_h = p R lz/(h), axial S_z lz = p R lh^2/(2 h), solved by Newton.
/// Source: derived here.
CylinderStretch closed_cylinder(const StretchedCylinder& cylinder, double overpressure);

/// Clamped circular membrane by Hencky's series: the pressure keeps its direction; moderate rotation
/// (Foeppl).
struct CircularMembrane {
  Sheet sheet;                      // unstretched
  double radius = kRequired;        // [m] > 0
  double overpressure = kRequired;  // [Pa] > 0; q = p a/(E h) <= 0.1 (small slope)
};
/// The series and its results.
struct HenckyMembrane {
  std::vector<double> coefficients;  // b_0, b_2, b_4, ...
  double centre_deflection = 0.0;    // [m]
  double volume = 0.0;               // [m3] under the deflected surface
  double centre_resultant = 0.0;     // [N/m] N_r(0)
  double edge_resultant = 0.0;       // [N/m] N_r(a)
};
/// Series N = (E h q^(2/3)/4) sum b_2n rho^2n, with B^2 (x B'' + 2 B') = -2, x = rho^2, and sum (2n+1-nu)
/// b_2n = 0. Needs 0 <= nu <= 0.5. Source: H. Hencky (1915), textbook result; coefficients derived here.
HenckyMembrane hencky_membrane(const CircularMembrane& membrane);
/// Deflection [m] at radius r [m], 0 <= r <= a.
double hencky_deflection(const CircularMembrane& membrane, double r);

/// Inextensible balloon of two flat discs (Mylar balloon).
struct MylarBalloon {
  double equator_radius = 0.0;  // [m] r = a/A, A = Gamma(1/4)^2/(4 sqrt(2 pi))
  double thickness = 0.0;       // [m] 2 B r, B = Gamma(3/4)^2/sqrt(2 pi)
  double volume = 0.0;          // [m3] (2 pi/3) a r^2
};
/// Balloon of discs with flat radius a [m] > 0. Source: W. H. Paulsen (1994).
MylarBalloon mylar_balloon(double flat_radius);
/// Half height z [m] of the profile at radius x [m], 0 <= x <= equator_radius:
///   int_x^r s^2/sqrt(r^4 - s^4) ds.
double mylar_profile(double flat_radius, double x);

/// Membrane under uniform tension.
struct TensionedMembrane {
  double tension = kRequired;       // [N/m] > 0
  double area_density = kRequired;  // [kg/m2] rho h > 0
};
/// Wave speed sqrt(N/(rho h)) [m/s].
double transverse_wave_speed(const TensionedMembrane& membrane);
/// Frequency [Hz] of a circular drum of radius a [m] with m >= 0 nodal diameters and order n >= 1: c j_mn/(2
/// pi a). Source: textbook result (Rayleigh, The Theory of Sound).
double drum_frequency(const TensionedMembrane& membrane, double radius, int diameters, int order);
/// Frequency [Hz] of a rectangle with sides a, b [m] and m, n >= 1 half waves: (c/2) sqrt(m^2/a^2 + n^2/b^2).
double rectangle_frequency(const TensionedMembrane& membrane, double a, double b, int m, int n);
/// Exact frequency f_mn [Hz] of a square of side L [m] in N x N split squares (uniform diagonals, lumped
/// mass), 1 <= m, n < N: (c/(pi h)) sqrt(sin^2(m pi/2N) + sin^2(n pi/2N)), h = L/N. Source: derived here
/// (5-point Laplacian).
double lattice_square_frequency(const TensionedMembrane& membrane, double side, int divisions, int m, int n);

/// Two strips under uniform tension, clamped at both sides, that a pressure from outside lays on each other,
/// each over an elastic layer (K.44).
struct PressedStrips {
  double tension = kRequired;     // [N/m] T > 0
  double half_width = kRequired;  // [m] L > 0
  double approach = kRequired;    // [m] H > 0: way of each strip from its clamps until they touch
  double stiffness = kRequired;   // [N/m3] kappa > 0: pressure per metre that they come closer
};
/// What two strips do that are pressed on each other.
struct StripPress {
  double contact_half_width = 0.0;  // [m] a
  double force = 0.0;               // [N/m] of the contact, per length
  double closing = 0.0;             // [m] by which they come closer in the middle, p/kappa
};
/// At pressure p [Pa] > 0, with lambda = sqrt(T/(2 kappa)): T w'' = -p where they are apart, else T w'' =
/// -p + kappa times the closing, so that a = L + lambda - sqrt(lambda^2 + 2 T H/p), and the force is 2 p (a -
/// lambda). Small slope, and a above 6 lambda, for less than 1e-5 of neglect. Source: derived here.
StripPress pressed_strips(const PressedStrips& strips, double pressure);

/// Deflection of a tensioned square, n lap(w) = -p, side a. Dimensionless.
struct SquareDeflection {
  double centre_coefficient = 0.0;  // w_c n/(p a^2)
  double volume_coefficient = 0.0;  // V n/(p a^4)
};
/// Coefficients of the continuum (Fourier series to round-off). Source: S. P. Timoshenko, membrane analogy
/// (textbook result).
SquareDeflection square_deflection();
/// Coefficients of the 5-point lattice N x N, N even >= 2, by its exact discrete Fourier sum. The volume is
/// the sum over nodes times h^2.
SquareDeflection lattice_square_deflection(int divisions);
/// Centre deflection of a circular membrane [m], p a^2/(4 n): tension [N/m], radius [m], overpressure [Pa].
double circle_deflection(double tension, double radius, double overpressure);

/// Rigid sphere pressed without friction into the middle of a clamped circular membrane; small slope.
struct MembraneDent {
  double tension = kRequired;          // [N/m] > 0
  double membrane_radius = kRequired;  // [m] R > 0
  double sphere_radius = kRequired;    // [m] r >= R
};
/// State at one depth of the sphere.
struct DentState {
  /// [m] a^2 (1 + 2 ln(R/a))/(2 r), of the sphere below the membrane's plane.
  double depth = 0.0;
  double force = 0.0;   // [N] 2 pi N a^2/r
  double energy = 0.0;  // [J] pi N a^4 (ln(R/a) + 1/4)/r^2
};
/// State (K.19) for a patch of radius 0 <= a < R [m]. Source: derived here (Laplace equation outside the
/// patch).
DentState membrane_dent(const MembraneDent& dent, double patch_radius);

/// Impact of the sphere on the membrane.
struct MembraneRebound {
  double patch_radius = 0.0;  // [m] at the turn
  DentState turn;             // where the sphere comes to rest
  double duration = 0.0;      // [s] from first touch to release
};
/// Impact of a sphere of mass [kg] > 0 at speed [m/s] > 0 on that membrane, without mass. The sphere leaves
/// at the same speed. Refused if the patch would reach the rim.
MembraneRebound membrane_rebound(const MembraneDent& dent, double mass, double speed);

/// Speeds of small waves in a thin sheet. Source: textbook results.
struct WaveSpeeds {
  double plane = 0.0;  // [m/s] sqrt(E/(rho (1-nu^2))), thin plate, longitudinal
  double bar = 0.0;    // [m/s] sqrt(E/rho)
  double shear = 0.0;  // [m/s] sqrt(G/rho)
};
/// Speeds in the unstretched sheet; needs sheet.density.
WaveSpeeds wave_speeds(const Sheet& sheet);

/// Speeds of small waves in a stretched sheet.
struct StretchedWaveSpeeds {
  double longitudinal = 0.0;  // [m/s] referential, sqrt((E/(rho (1-nu^2))) (3 lambda^2 - 1)/2)
  double transverse = 0.0;    // [m/s] referential, sqrt(S/rho), S = E/(1-nu^2) (lambda^2-1)/2
};
/// Speeds along the stretched direction of an StVK sheet: stretch >= 1 in that direction, 1 across. Source:
/// derived here.
StretchedWaveSpeeds stretched_wave_speeds(const Sheet& sheet, double stretch);

/// Second Piola-Kirchhoff stress.
struct PlaneStress {
  double s11 = 0.0;  // [Pa]
  double s22 = 0.0;  // [Pa]
  double s12 = 0.0;  // [Pa]
};
/// Hooke's law in plane stress: S11 = E/(1-nu^2) (E11 + nu E22), S12 = E/(1+nu) E12 (e12: tensor component).
/// Source: textbook result (Timoshenko and Goodier, Theory of Elasticity, section 15).
PlaneStress hooke_plane_stress(const Sheet& sheet, double e11, double e22, double e12);
/// State of a strip in tension.
struct UniaxialState {
  double stress = 0.0;              // [Pa] S = E (lambda^2 - 1)/2
  double transverse_stretch = 0.0;  // [-] sqrt(1 - nu (lambda^2 - 1))
  double nominal_stress = 0.0;      // [Pa] P = lambda S
};
/// State in uniaxial tension, free across; refused where nu (lambda^2 - 1) >= 1. Source: derived here.
UniaxialState uniaxial_tension(const Sheet& sheet, double stretch);
/// Stress in simple shear x = X + gamma Y: E12 = gamma/2, E22 = gamma^2/2. Source: derived here.
PlaneStress simple_shear(const Sheet& sheet, double shear);

}  // namespace closed_form
