// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/pendulum.hpp"

/// Closed forms of coupled scenes: gas on a piston, on a pendulum, in an elastic sphere; a pressed balloon
/// and cylinder.
/// All functions throw std::invalid_argument, naming the field, for a parameter that is missing or out of
/// validity.
namespace closed_form {

/// Mass on a spring and on the gas of a closed cylinder: small oscillation about equilibrium.
struct GasPiston {
  PerfectGas gas;               // in the cylinder
  double mass = kRequired;      // [kg] > 0
  double area = kRequired;      // [m2] > 0
  double volume = kRequired;    // [m3] at equilibrium, > 0
  double pressure = kRequired;  // [Pa] absolute, at equilibrium, > 0
  double stiffness = 0.0;       // [N/m] >= 0
};

/// Angular frequency sqrt((k + gamma p S^2/V)/M) [rad/s], adiabatic. Source: derived here by linearisation.
double gas_piston_frequency(const GasPiston& piston);
/// The same for isothermal gas, gamma replaced by 1 [rad/s]: the control.
double gas_piston_isothermal_frequency(const GasPiston& piston);

/// Weight on the piston of a closed cylinder of gas, all at rest, the gas at ambient pressure.
struct GasSpring {
  PerfectGas gas;                      // in the cylinder
  double mass = kRequired;             // [kg] that moves, > 0
  double area = kRequired;             // [m2] > 0
  double volume = kRequired;           // [m3] at the start, > 0
  double ambient_pressure = 101325.0;  // [Pa] > 0
};
/// The swing that follows.
struct GasSpringSwing {
  double depth = 0.0;          // [m] where the weight turns
  double period = 0.0;         // [s] until it is back
  double peak_pressure = 0.0;  // [Pa] absolute, at the depth
};
/// Swing, adiabatic, if a constant force [N] > 0 pushes the piston in: m v^2/2 = F s - int (p - p_a) S ds.
/// The period tends to 2 pi/gas_piston_frequency as the force falls. Source: derived here from the energy
/// integral.
GasSpringSwing gas_spring(const GasSpring& spring, double force);

/// Pendulum whose impactor closes a gas cylinder; area, volume and pressure as for the piston.
struct PendulumGasSpring {
  PerfectGas gas;               // in the cylinder
  Pendulum pendulum;            // hanging, its impactor on the piston
  double area = kRequired;      // [m2] > 0
  double volume = kRequired;    // [m3] > 0
  double pressure = kRequired;  // [Pa] absolute, > 0
};
/// Angular frequency sqrt((gamma p S^2 L_i^2/V + m g L_cg)/I_O) [rad/s]. Source: derived here by
/// linearisation.
double pendulum_gas_spring_frequency(const PendulumGasSpring& scene);

/// Elastic sphere that gas fills quasi-statically and adiabatically. It starts unstretched at ambient
/// pressure.
struct SphereFill {
  PerfectGas gas;                         // of the inflow, and inside at the start
  StretchedSphere sphere;                 // the skin
  double ambient_pressure = 101325.0;     // [Pa] > 0
  double inflow_temperature = kRequired;  // [K] > 0
};
/// State of the filled sphere.
struct SphereFillState {
  double inflow_mass = 0.0;    // [kg]
  double stretch = 1.0;        // [-]
  double pressure = 0.0;       // [Pa] absolute
  double volume = 0.0;         // [m3]
  double strain_energy = 0.0;  // [J]
  double ambient_work = 0.0;   // [J] p_a (V - V0)
};
/// State at stretch >= 1 [-]: m_in = (p V/(gamma-1) + U_el + p_a (V - V0) - p_a V0/(gamma-1)) / (cp T_in).
/// Source: derived here from the energy balance.
SphereFillState sphere_fill(const SphereFill& scene, double stretch);
/// State at which inflow_mass [kg] >= 0 has entered, to all digits also where the stretch rounds to 1.
SphereFillState sphere_fill_by_mass(const SphereFill& scene, double inflow_mass);

/// Elastic sphere at constant overpressure, pressed between two equal, rigid, frictionless spheres on its
/// axis.
struct PressedBalloon {
  StretchedSphere sphere;              // unstretched
  double overpressure = kRequired;     // [Pa] > 0
  double indenter_radius = kRequired;  // [m] >= sphere.radius; a very large one is a flat plate
};
/// State of the pressed balloon at one size of the patch in touch.
struct BalloonPress {
  /// [N] Of each indenter, (p + 2 T/r) pi a^2, T the tension at the patch's edge.
  double force = 0.0;
  double centre_height = 0.0;  // [m] of the indenter's centre over the balloon's equator
  double patch_area = 0.0;     // [m2] pi a^2 of the circle that bounds the patch
  double pole_stretch = 0.0;   // [-]
  double strain_energy = 0.0;  // [J] of the whole balloon
  double volume = 0.0;         // [m3] of the whole balloon
};
/// Balloon whose skin is in touch within patch_angle [rad] of the pole, measured on the unstretched sphere,
/// 0 < patch_angle <= 0.6. Axisymmetric StVK equilibrium, by shooting from the pole to the equator; refused
/// where the skin would go slack. Its force is (K.18). Source: derived here (the free skin and the patch as
/// in W. W. Feng, W.-H. Yang, J. Appl. Mech. 40, 1973).
BalloonPress pressed_balloon(const PressedBalloon& scene, double patch_angle);

/// Long elastic cylinder of fixed length at constant overpressure, pressed flat between two rigid,
/// frictionless plates.
struct PressedCylinder : StretchedCylinder {
  double overpressure = kRequired;  // [Pa] > 0
};
/// State of the pressed cylinder.
struct CylinderPress {
  double force_per_length = 0.0;   // [N/m] of each plate, p w
  double flat_width = 0.0;         // [m] w = pi (lambda R - r) of the skin in touch with a plate
  double hoop_stretch = 0.0;       // [-] lambda, the same all around
  double volume_per_length = 0.0;  // [m2] of the section, pi r^2 + 2 r w
};
/// State at half of the plates' distance, r [m] > 0: two half circles of the radius r and two flats.
/// E h lambda (lambda^2 - 1)/(2 (1 - nu^2)) = p r. Refused if the plates do not touch. Source: derived here.
CylinderPress pressed_cylinder(const PressedCylinder& scene, double half_distance);

}  // namespace closed_form
