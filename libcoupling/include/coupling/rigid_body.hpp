// SPDX-License-Identifier: Apache-2.0
// A rigid body on a rail, or free: (K.53) to (K.57). It does not know its shape.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace coupling {

/// A spring with a damper between a body and its rail. A stop is one that acts on one side.
struct RailSpring {
  double stiffness = 0.0;  // [N/m] >= 0
  double damping = 0.0;    // [N s/m] >= 0
  double at = 0.0;         // [m] displacement without force
  bool one_sided = false;  // acts beyond `at` only: on the side away from the start
};

/// A rail along which a body moves without turning.
struct Rail {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // [-] of any length > 0
  /// Between it and the body.
  std::vector<RailSpring> springs{};
};

/// Data of a rigid body. Without a rail it is free to move and turn.
struct RigidBodyParameters {
  double mass = 0.0;                                           // [kg] > 0
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();            // [m] of gravity, at the start
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();          // columns: the body's axes, at the start
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // [m/s] at the start; along the rail
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // [rad/s] at the start; of a free body
  Eigen::Matrix3d inertia =
      Eigen::Matrix3d::Zero();  // [kg m2] about the centre, in the body's axes; of a free body
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  std::optional<Rail> rail{};                         // none: a free body
};

/// Motion of a body, staggered as in the central difference: place at level n, speeds at n-1/2. At the start
/// these are those at t = 0, and the first kick is half a step.
struct RigidBodyState {
  Eigen::Vector3d centre;            // [m]
  Eigen::Matrix3d axes;              // columns: the body's axes
  Eigen::Vector3d velocity;          // [m/s]
  Eigen::Vector3d angular_momentum;  // [kg m2/s] in space; zero on a rail
};

/// What acts on a body at level n.
struct RigidBodyLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // [N]
  Eigen::Vector3d couple = Eigen::Vector3d::Zero();  // [N m] about the centre
};

/// What a kick did, the change of speeds by the load.
struct RigidBodyKick {
  double work = 0.0;       // [J] of the load and of all that is the body's own; the change of kinetic energy
  double load_work = 0.0;  // [J] of the load alone
  double damping_loss = 0.0;    // [J]
  double kinetic_before = 0.0;  // [J] at n-1/2
  double kinetic_after = 0.0;   // [J] at n+1/2
  double kinetic_mixed = 0.0;   // [J] product of both speeds in place of a square
};

/// Constants of the body and its motion. Immutable.
class RigidBodyModel {
 public:
  /// Throws std::invalid_argument that names the field, its value and its range.
  explicit RigidBodyModel(const RigidBodyParameters& parameters);

  const RigidBodyParameters& parameters() const { return parameters_; }  // direction of the rail normalised
  /// True without a rail.
  bool is_free() const { return !parameters_.rail; }
  /// State at the start.
  RigidBodyState initial() const;

  /// Displacement [m] from the start: along the rail, or the length of that of a free body.
  double displacement(const RigidBodyState& state) const;
  /// Speed [m/s] along the rail, or the length of the velocity of a free body.
  double speed(const Eigen::Vector3d& velocity) const;
  /// Angular velocity [rad/s] in space.
  Eigen::Vector3d angular_velocity(const RigidBodyState& state) const;

  /// Force [N] of gravity and, on a rail, of the springs, without what the rail takes (K.53).
  Eigen::Vector3d own_force(const RigidBodyState& state) const;
  /// Energy [J] of gravity, less that at the start (K.54).
  double gravity_energy(const RigidBodyState& state) const;
  /// Energy [J] of the springs (K.54).
  double spring_energy(const RigidBodyState& state) const;
  /// Kinetic energy [J] of the state's speeds.
  double kinetic_energy(const RigidBodyState& state) const;

  /// One step of the central difference: a kick by load and own force over tau = (dt_before + dt_after)/2
  /// [s], then the motion of dt_after [s] (K.55), (K.56). dt_before = 0 at the start. Throws
  /// std::invalid_argument for a step that is negative or NaN, and ContactError if the result is not finite.
  RigidBodyKick advance(RigidBodyState& state, const RigidBodyLoad& load, double tau, double dt_after) const;

  /// Mass [kg] that a contact up to `reach` [m] from the centre feels at least (K.57).
  double effective_mass(double reach) const;
  /// Bound of omega^2 [1/s2] of the springs and of a contact force that turns a free body (K.57).
  double omega_squared(double contact_force, double reach) const;

 private:
  Eigen::Vector3d along_rail(const Eigen::Vector3d& v) const;
  double damping_at(const RigidBodyState& state) const;
  double kinetic(const Eigen::Matrix3d& axes, const Eigen::Vector3d& velocity_a,
                 const Eigen::Vector3d& velocity_b, const Eigen::Vector3d& momentum_a,
                 const Eigen::Vector3d& momentum_b) const;
  Eigen::Vector3d turned(const Eigen::Matrix3d& axes, const Eigen::Vector3d& momentum) const;
  void turn(RigidBodyState& state, double dt) const;

  RigidBodyParameters parameters_;
  Eigen::Matrix3d principal_axes_ = Eigen::Matrix3d::Identity();  // in the body's axes
  Eigen::Vector3d moments_ = Eigen::Vector3d::Zero();             // [kg m2] principal ones, ascending
};

}  // namespace coupling
