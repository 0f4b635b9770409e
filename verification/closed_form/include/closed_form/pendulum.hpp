// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

/// Closed forms of the rigid pendulum, of its impactor sphere and of penalty contact. All functions throw
/// std::invalid_argument, naming the field, for a parameter that is missing or out of validity.
namespace closed_form {

/// Rigid body that swings about a horizontal axis. At angle 0 it hangs at rest.
struct Pendulum {
  double mass = kRequired;          // [kg] > 0
  double cg_inertia = kRequired;    // [kg m2] about the c.g., parallel to the axis, >= 0
  double cg_arm = kRequired;        // [m] axis to c.g., > 0
  double impactor_arm = kRequired;  // [m] axis to impactor centre, > 0
  double gravity = 9.80665;         // [m/s2] > 0
};

/// The pendulum of "Gas Jet Model for Airbag Inflators": 10.9 kg, 2.07 kg m2, 1.065 m, 1.310 m.
Pendulum paper_pendulum();

/// Constants that follow from the five numbers.
struct PendulumConstants {
  double axis_inertia = 0.0;        // [kg m2] I_O = I_cg + m L^2
  double angular_frequency = 0.0;   // [rad/s] omega0 = sqrt(m g L / I_O)
  double small_swing_period = 0.0;  // [s] 2 pi / omega0
  /// [rad/(s2 N)] L_i / I_O, for a horizontal force at the impactor, theta = 0.
  double angular_acceleration_per_force = 0.0;
  double cg_acceleration_per_force = 0.0;        // [m/(s2 N)] L L_i / I_O
  double impactor_acceleration_per_force = 0.0;  // [m/(s2 N)] L_i^2 / I_O
  double effective_mass = 0.0;                   // [kg] I_O / L_i^2
  double centre_of_percussion = 0.0;             // [m] I_O / (m L)
  /// [-] Impulse at the pivot over that at the impactor, 1 - m L L_i / I_O.
  double pivot_impulse_ratio = 0.0;
};
/// Constants of a pendulum. Source: rigid-body mechanics, textbook results.
PendulumConstants pendulum_constants(const Pendulum& pendulum);

/// Period T = 4 K(k)/omega0 [s], k = sin(amplitude/2); 0 <= amplitude < pi [rad]. Source: textbook result
/// (Landau and Lifshitz, Mechanics).
double pendulum_period(const Pendulum& pendulum, double amplitude);

/// Motion at one time.
struct PendulumState {
  double angle = 0.0;             // [rad]
  double angular_velocity = 0.0;  // [rad/s]
};

/// Motion at any time [s] after a release at rest from `amplitude` [rad], |amplitude| < pi: theta = 2 asin(k
/// sn(K - omega0 t)). Source: textbook result (Jacobi elliptic functions).
PendulumState pendulum_swing(const Pendulum& pendulum, double amplitude, double time);

/// Pendulum after an impulse.
struct ImpulseResponse {
  double angular_velocity = 0.0;  // [rad/s] just after the impulse, J L_i / I_O
  double kinetic_energy = 0.0;    // [J] J^2 / (2 m_eff)
  double maximum_angle = 0.0;     // [rad] acos(1 - I_O omega^2 / (2 m g L))
  double time_of_maximum = 0.0;   // [s] K(k)/omega0, k = omega/(2 omega0)
};
/// Response to an impulse [N s] > 0 at the impactor of the hanging pendulum. Refused if it would go over the
/// top (k >= 1).
ImpulseResponse pendulum_impulse(const Pendulum& pendulum, double impulse);

/// Greatest angle [rad], from rest, under a constant horizontal force [N] >= 0 at the impactor: exactly 2
/// atan(F L_i/(m g L)). Source: derived here from the energy integral.
double constant_force_maximum_angle(const Pendulum& pendulum, double force);

/// Motion of the *linearised* pendulum, at rest at t = 0, under F = F0 sin(pi t/T) for 0 <= t <= T, free
/// afterwards. Its relative error is about theta^2/6. force [N], duration [s] > 0, time [s] >= 0; omega0
/// T = pi is refused (resonance).
PendulumState half_sine_response(const Pendulum& pendulum, double force, double duration, double time);

/// Part of a sphere beyond a plane.
struct SphereContact {
  double patch_area = 0.0;  // [m2] pi (2 R delta - delta^2), cut of the sphere by the plane
  double cap_volume = 0.0;  // [m3] pi delta^2 (R - delta/3)
};
/// Cut of a rigid sphere of radius [m] > 0, pressed by 0 <= depth <= 2 radius [m] through a plane.
SphereContact sphere_plane_cut(double radius, double depth);

/// Contact of a sphere with a plane.
struct SphereForce {
  double force = 0.0;   // [N] pi kappa delta^2 (R - delta), along the plane's normal
  double energy = 0.0;  // [J] pi kappa delta^3 (R/3 - delta/4)
};
/// Contact of a sphere with an infinite plane by a surface integral. The energy per area of the plane is
/// kappa (R - d)^2/2 where the distance d to the centre is below R. stiffness kappa [N/m3] > 0,
/// 0 <= depth <= radius [m]. Source: derived here.
SphereForce sphere_plane_contact(double radius, double depth, double stiffness);

/// Friction [N] against the sliding of that sphere along the plane. Coulomb tractions of magnitude friction
/// kappa (R - d), tangential to the sphere, act against the projection of the sliding:
///   4 friction kappa int_h^R (R - d) d E(k) dd, h = R - depth, k^2 = 1 - h^2/d^2.
/// friction [-] >= 0, depth < radius. Source: derived here.
double sphere_plane_sliding(double radius, double depth, double stiffness, double friction);

/// Friction of a sphere that sticks in the middle of its patch and slides around it.
struct SphereSlip {
  double force = 0.0;   // [N] against the displacement
  double energy = 0.0;  // [J] of the stretched points
  double loss = 0.0;    // [J] of the points that slide, since the start
};
/// The plane is displaced by `displacement` u >= 0 [m] from where friction was none. Points stretch
/// elastically, kappa u per area, up to friction times the pressure, kappa (R - d). For depth/R -> 0, where
/// the depth falls by equal steps over rings of equal area:
///   force = 2 pi R kappa (u depth - u^2/(2 mu)) up to u = mu depth, from there on pi R kappa mu depth^2.
/// friction mu > 0. Source: derived here.
SphereSlip sphere_plane_slip(double radius, double depth, double stiffness, double friction,
                             double displacement);
/// Loss [J] of a whole cycle of displacement between -amplitude and amplitude [m]:
/// 4 pi R kappa u^3/(3 mu) up to u = mu depth. Source: derived here.
double sphere_plane_slip_cycle(double radius, double depth, double stiffness, double friction,
                               double amplitude);

/// Bounce off a one-sided spring.
struct PenaltyBounce {
  double maximum_penetration = 0.0;  // [m] v sqrt(m/k)
  double duration = 0.0;             // [s] pi sqrt(m/k)
  double maximum_force = 0.0;        // [N] v sqrt(m k)
  double critical_time_step = 0.0;   // [s] 2 sqrt(m/k), central difference
};
/// Bounce of a mass [kg] > 0 off a one-sided linear spring [N/m] > 0 at speed [m/s] > 0. Source: textbook
/// result.
PenaltyBounce penalty_bounce(double mass, double stiffness, double speed);

}  // namespace closed_form
