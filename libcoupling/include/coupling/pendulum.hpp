// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <limits>

namespace coupling {

/// Default of members that must be given.
inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

/// Data of a rigid pendulum with a revolute joint and a spherical impactor. The centre of gravity and the
/// impactor's centre lie on one line through the pivot. PendulumModel normalises axis and rest direction.
/// Gravity is zero by default; all other members must be given.
struct PendulumParameters {
  /// [m] point of the axis closest to the centre of gravity.
  Eigen::Vector3d pivot = Eigen::Vector3d::Constant(kNotGiven);
  Eigen::Vector3d axis =
      Eigen::Vector3d::Constant(kNotGiven);  // [-] of any length > 0; the angle grows right-handed about it
  /// [-] from the pivot to the c.g. at angle 0; any length > 0; perpendicular to the axis within 1e-6 rad.
  Eigen::Vector3d rest_direction = Eigen::Vector3d::Constant(kNotGiven);
  double mass = kNotGiven;               // [kg] > 0
  double inertia_cg = kNotGiven;         // [kg m2] >= 0, about an axis through the c.g. parallel to `axis`
  double cg_distance = kNotGiven;        // [m] >= 0, pivot to c.g.; > 0 if inertia_cg is 0
  double impactor_distance = kNotGiven;  // [m] > 0, pivot to the impactor's centre
  double impactor_radius = kNotGiven;    // [m] > 0, at most impactor_distance
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
};

/// Motion of the pendulum, staggered as in the central difference. At the start, the velocity is that at
/// t = 0 and the first kick is half a step (tau = dt / 2).
struct PendulumState {
  double angle = 0.0;             // [rad] theta^n, any number of turns
  double angular_velocity = 0.0;  // [rad/s] omega^{n-1/2}
};

/// Acceleration of the centre of gravity at level n, in directions fixed to the pendulum.
struct CgAcceleration {
  double tangential = 0.0;  // [m/s2] towards growing angle: alpha L
  double radial = 0.0;      // [m/s2] towards the pivot: omega^2 L
  double resultant = 0.0;   // [m/s2] >= 0
};

/// Constants of the pendulum and the relations between them, (K.1) to (K.8). Immutable.
class PendulumModel {
 public:
  /// Throws std::invalid_argument that names the field, its value and its range.
  explicit PendulumModel(const PendulumParameters& parameters);

  const PendulumParameters& parameters() const { return parameters_; }  // directions normalised

  /// Moment of inertia about the axis, I = I_cg + m L_cg^2 [kg m2] (K.2).
  double axis_inertia() const { return axis_inertia_; }
  /// Effective mass m_eff = I / L_i^2 [kg] for a force along the path of the impactor's centre (K.3).
  double effective_mass() const { return effective_mass_; }

  /// Centre of gravity [m] at `angle` [rad].
  Eigen::Vector3d cg_position(double angle) const;
  /// Centre of the impactor [m] at `angle` [rad].
  Eigen::Vector3d impactor_centre(double angle) const;
  /// Velocity of the impactor's centre [m/s] at `angle` [rad] and `angular_velocity` [rad/s].
  Eigen::Vector3d impactor_velocity(double angle, double angular_velocity) const;

  /// Moment of gravity about the axis [N m] at `angle` [rad].
  double gravity_moment(double angle) const;
  /// Moment about the axis [N m] of `force` [N] at `point` [m].
  double moment(const Eigen::Vector3d& force, const Eigen::Vector3d& point) const;

  /// Potential energy of gravity [J], -m g . (x_cg(angle) - x_cg(0)) (K.7).
  double potential_energy(double angle) const;
  /// Kinetic energy I omega^2 / 2 [J] (K.7).
  double kinetic_energy(double angular_velocity) const;

  /// One step of the central difference (K.4):
  ///   omega^{n+1/2} = omega^{n-1/2} + tau alpha,  theta^{n+1} = theta^n + dt_after omega^{n+1/2},  I alpha =
  ///   moment^n.
  /// `moment` [N m] is the sum of all moments about the axis (K.1). tau = (dt_before + dt_after)/2 [s], with
  /// dt_before = 0 at the start. The kinetic energy changes by exactly tau moment (omega_- + omega_+)/2 (kick
  /// form). Throws std::invalid_argument for a step that is negative or NaN, and ContactError if the result
  /// is not finite.
  PendulumState advance(const PendulumState& state, double moment, double tau, double dt_after) const;

  /// Throws ContactError if `turn` [rad], the rotation of one step, moves the impactor's centre by more than
  /// r/2 along its arc (K.25). Contact tests the chord; for an arc of r/2 the chord is off by at most r/32.
  void require_followed(double turn) const;

  /// Angular velocity at level n, omega^{n-1/2} + (dt_before/2) alpha [rad/s], of second order.
  double angular_velocity_at_level(const PendulumState& state, double moment, double dt_before) const;

  /// Acceleration from moment [N m] and angular velocity [rad/s] at the same level n (K.5).
  CgAcceleration cg_acceleration(double moment, double angular_velocity) const;

  /// Force of the joint on the pendulum, R = m a_cg - m g - F [N] (K.6). `applied_force` F [N] is the sum of
  /// the other forces, `moment` [N m] the sum of all moments about the axis.
  Eigen::Vector3d joint_reaction(double angle, double angular_velocity, double moment,
                                 const Eigen::Vector3d& applied_force) const;

  /// Bound of omega^2 [1/s2] due to gravity and to the rotation of a contact force F [N] about the pivot, in
  /// addition to the contact's own: (m |g| L_cg + |F| L_i) / I (K.8).
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
