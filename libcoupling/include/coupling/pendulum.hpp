// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <limits>

namespace coupling {

/// Default of what has to be given.
inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

// What must be given of a rigid pendulum on a revolute joint with a spherical impactor. The impactor's centre
// and the centre of gravity lie on one line through the pivot. Axis and rest direction are normalised by
// PendulumModel; gravity defaults to none.
struct PendulumParameters {
  Eigen::Vector3d pivot = Eigen::Vector3d::Constant(kNotGiven);  // [m] the point of the axis next to the c.g.
  Eigen::Vector3d axis = Eigen::Vector3d::Constant(kNotGiven);   // angle grows right-handed about it
  Eigen::Vector3d rest_direction =
      Eigen::Vector3d::Constant(kNotGiven);  // pivot to c.g. at angle 0, normal to axis
  double mass = kNotGiven;                   // [kg] > 0
  double inertia_cg = kNotGiven;             // [kg m2] >= 0, about the axis direction through the c.g.
  double cg_distance = kNotGiven;            // [m] >= 0, pivot to c.g.
  double impactor_distance = kNotGiven;      // [m] > 0, pivot to the impactor's centre
  double impactor_radius = kNotGiven;        // [m] > 0, at most impactor_distance
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
};

// Motion of the pendulum in the central difference's staggering. At the start, velocity is that of t = 0 and
// the first kick is half a step (tau = dt / 2).
struct PendulumState {
  double angle = 0.0;             // [rad] theta^n, any number of turns
  double angular_velocity = 0.0;  // [rad/s] omega^{n-1/2}
};

// Acceleration of the centre of gravity at level n, in the pendulum's own directions.
struct CgAcceleration {
  double tangential = 0.0;  // [m/s2] along growing angle: alpha L
  double radial = 0.0;      // [m/s2] towards the pivot: omega^2 L
  double resultant = 0.0;   // [m/s2] >= 0
};

// The pendulum's constants and the relations between them, (K.1) to (K.8). Immutable.
class PendulumModel {
 public:
  // Throws std::invalid_argument naming field, value and what is allowed.
  explicit PendulumModel(const PendulumParameters& parameters);

  const PendulumParameters& parameters() const { return parameters_; }  // directions normalised

  // (K.2) I = I_cg + m L_cg^2 [kg m2], about the axis.
  double axis_inertia() const { return axis_inertia_; }
  // (K.3) m_eff = I / L_i^2 [kg], the mass that a force along the path of the impactor's centre sees.
  double effective_mass() const { return effective_mass_; }

  // Centre of gravity [m] at an angle [rad].
  Eigen::Vector3d cg_position(double angle) const;
  // Centre of the impactor [m] at an angle [rad].
  Eigen::Vector3d impactor_centre(double angle) const;
  // Velocity of that centre [m/s] at an angle [rad] and angular velocity [rad/s].
  Eigen::Vector3d impactor_velocity(double angle, double angular_velocity) const;

  // Moment of gravity about the axis [N m] at an angle [rad].
  double gravity_moment(double angle) const;
  // Moment about the axis [N m] of a force [N] acting at a point [m].
  double moment(const Eigen::Vector3d& force, const Eigen::Vector3d& point) const;

  // (K.7) Energy of gravity [J], -m g . (x_cg(angle) - x_cg(0)).
  double potential_energy(double angle) const;
  // (K.7) I omega^2 / 2 [J].
  double kinetic_energy(double angular_velocity) const;

  // (K.4) omega^{n+1/2} = omega^{n-1/2} + tau alpha, theta^{n+1} = theta^n + dt_after omega^{n+1/2}, with
  // I alpha = moment^n (K.1), the sum of all moments about the axis [N m]; tau = (dt_before + dt_after)/2
  // [s], dt_before = 0 at the start. Kick form: the kinetic energy changes by tau moment (omega_- +
  // omega_+)/2 exactly. Throws ContactError when the result is not finite.
  PendulumState advance(const PendulumState& state, double moment, double tau, double dt_after) const;

  // (K.25) Throws ContactError when a step's turn [rad] takes the impactor's centre farther than r/2 along
  // its arc. Contact tests the chord: up to there it is off the arc by r/32 at most, and no turn is left out.
  void require_followed(double turn) const;

  // omega^n = omega^{n-1/2} + (dt_before/2) alpha [rad/s], second order.
  double angular_velocity_at_level(const PendulumState& state, double moment, double dt_before) const;

  // (K.5) From moment [N m] and angular velocity [rad/s] of the same level n.
  CgAcceleration cg_acceleration(double moment, double angular_velocity) const;

  // (K.6) R = m a_cg - m g - F [N], the joint's force on the pendulum; applied_force F [N] is the sum of the
  // other forces, and `moment` the sum of all moments about the axis.
  Eigen::Vector3d joint_reaction(double angle, double angular_velocity, double moment,
                                 const Eigen::Vector3d& applied_force) const;

  // (K.8) Bound of the rotational stiffness over inertia [1/s2] that gravity and the turning of a contact
  // force F [N] about the pivot add to the contact's own: (m |g| L_cg + |F| L_i) / I.
  double omega_squared(const Eigen::Vector3d& contact_force) const;

 private:
  Eigen::Vector3d radial_direction(double angle) const;
  Eigen::Vector3d tangential_direction(double angle) const;

  PendulumParameters parameters_;
  Eigen::Vector3d side_direction_;  // axis x rest_direction
  double axis_inertia_;
  double effective_mass_;
};

}  // namespace coupling
