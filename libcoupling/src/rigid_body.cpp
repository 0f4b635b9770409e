// SPDX-License-Identifier: Apache-2.0
#include "coupling/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <elementary/trigonometric.hpp>

#include "check.hpp"
#include "coupling/error.hpp"

namespace coupling {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kTyped = 1e-9;  // of directions and moments typed by hand

void check_rail(Rail& rail) {
  const double length = rail.direction.stableNorm();
  if (!(std::isfinite(length) && length > 0.0))
    detail::reject("rail.direction", detail::text(rail.direction), "finite and not zero");
  rail.direction /= length;
  for (const RailSpring& spring : rail.springs) {
    const std::string name = spring.one_sided ? "rail.stop." : "rail.spring.";
    detail::require_not_negative(name + "stiffness", spring.stiffness);
    detail::require_not_negative(name + "damping", spring.damping);
    if (!std::isfinite(spring.at)) detail::reject(name + "at", detail::text(spring.at), "finite");
  }
}

void check_inertia(const Matrix3d& inertia, const Vector3d& moments) {
  if (!inertia.allFinite()) detail::reject("body.inertia", "a matrix with NaN or infinity", "finite");
  const double scale = inertia.cwiseAbs().maxCoeff();
  if (!((inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= kTyped * scale))
    detail::reject("body.inertia", "not symmetric", "symmetric");
  if (!(moments[0] > 0.0))
    detail::reject("body.inertia", "with principal moments " + detail::text(moments), "positive definite");
  if (!(moments[2] <= (1.0 + kTyped) * (moments[0] + moments[1])))
    detail::reject("body.inertia", "with principal moments " + detail::text(moments),
                   "that of a mass: no moment is more than the sum of the others");
}

RigidBodyParameters checked(RigidBodyParameters p) {
  detail::require_positive("body.mass", p.mass);
  detail::require_finite("body.centre", p.centre);
  detail::require_finite("body.velocity", p.velocity);
  detail::require_finite("body.angular_velocity", p.angular_velocity);
  detail::require_finite("gravity", p.gravity);
  if (!((p.axes.transpose() * p.axes - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kTyped &&
        p.axes.determinant() > 0.0))
    detail::reject("body.axes", "other columns", "three unit vectors at right angles, right-handed");
  if (!p.rail) return p;
  check_rail(*p.rail);
  const Vector3d along = p.velocity.dot(p.rail->direction) * p.rail->direction;
  if (!((p.velocity - along).norm() <= 1e-6 * p.velocity.norm()))
    detail::reject("body.velocity", detail::text(p.velocity), "along the rail");
  p.velocity = along;
  if (!p.angular_velocity.isZero(0.0))
    detail::reject("body.angular_velocity", detail::text(p.angular_velocity), "zero on a rail");
  return p;
}

// Rotation about one of the axes: by cosine and sine of our own, for the same bits everywhere.
Matrix3d about(int axis, double angle) {
  const double c = elementary::cos(angle), s = elementary::sin(angle);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Matrix3d turn = Matrix3d::Identity();
  turn(j, j) = turn(k, k) = c;
  turn(k, j) = s;
  turn(j, k) = -s;
  return turn;
}

// Removes the rounding of many products.
void make_orthonormal(Matrix3d& axes) {
  axes.col(0).normalize();
  axes.col(1) -= axes.col(1).dot(axes.col(0)) * axes.col(0);
  axes.col(1).normalize();
  axes.col(2) = axes.col(0).cross(axes.col(1));
}

bool is_loaded(const RailSpring& spring, double displacement) {
  return !spring.one_sided || (spring.at < 0.0 ? displacement < spring.at : displacement > spring.at);
}

}  // namespace

RigidBodyModel::RigidBodyModel(const RigidBodyParameters& parameters) : parameters_(checked(parameters)) {
  if (!is_free()) return;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(
      0.5 * (parameters_.inertia + parameters_.inertia.transpose()));
  moments_ = principal.eigenvalues();
  check_inertia(parameters_.inertia, moments_);
  principal_axes_ = principal.eigenvectors();
  if (principal_axes_.determinant() < 0.0) principal_axes_.col(2) *= -1.0;
}

RigidBodyState RigidBodyModel::initial() const {
  const Matrix3d& axes = parameters_.axes;
  Vector3d momentum = Vector3d::Zero();
  if (is_free()) momentum = axes * parameters_.inertia * (axes.transpose() * parameters_.angular_velocity);
  return {parameters_.centre, axes, parameters_.velocity, momentum};
}

double RigidBodyModel::displacement(const RigidBodyState& state) const {
  const Vector3d moved = state.centre - parameters_.centre;
  return parameters_.rail ? moved.dot(parameters_.rail->direction) : moved.norm();
}

double RigidBodyModel::speed(const Vector3d& velocity) const {
  return parameters_.rail ? velocity.dot(parameters_.rail->direction) : velocity.norm();
}

// Angular velocity of an angular momentum, in space.
Vector3d RigidBodyModel::turned(const Matrix3d& axes, const Vector3d& momentum) const {
  if (!is_free()) return Vector3d::Zero();
  const Matrix3d principal = axes * principal_axes_;
  return principal * (principal.transpose() * momentum).cwiseQuotient(moments_);
}

Vector3d RigidBodyModel::angular_velocity(const RigidBodyState& state) const {
  return turned(state.axes, state.angular_momentum);
}

Vector3d RigidBodyModel::along_rail(const Vector3d& v) const {
  return parameters_.rail ? (v.dot(parameters_.rail->direction) * parameters_.rail->direction).eval() : v;
}

Vector3d RigidBodyModel::own_force(const RigidBodyState& state) const {
  Vector3d force = along_rail(parameters_.mass * parameters_.gravity);
  if (!parameters_.rail) return force;
  const double s = displacement(state);
  for (const RailSpring& spring : parameters_.rail->springs)
    if (is_loaded(spring, s)) force -= spring.stiffness * (s - spring.at) * parameters_.rail->direction;
  return force;
}

double RigidBodyModel::gravity_energy(const RigidBodyState& state) const {
  return parameters_.mass * parameters_.gravity.dot(parameters_.centre - state.centre);
}

double RigidBodyModel::spring_energy(const RigidBodyState& state) const {
  double energy = 0.0;
  if (!parameters_.rail) return energy;
  const double s = displacement(state);
  for (const RailSpring& spring : parameters_.rail->springs)
    if (is_loaded(spring, s)) energy += 0.5 * spring.stiffness * (s - spring.at) * (s - spring.at);
  return energy;
}

double RigidBodyModel::damping_at(const RigidBodyState& state) const {
  double damping = 0.0;
  if (!parameters_.rail) return damping;
  const double s = displacement(state);
  for (const RailSpring& spring : parameters_.rail->springs)
    if (is_loaded(spring, s)) damping += spring.damping;
  return damping;
}

double RigidBodyModel::kinetic(const Matrix3d& axes, const Vector3d& velocity_a, const Vector3d& velocity_b,
                               const Vector3d& momentum_a, const Vector3d& momentum_b) const {
  return 0.5 * parameters_.mass * velocity_a.dot(velocity_b) + 0.5 * momentum_a.dot(turned(axes, momentum_b));
}

double RigidBodyModel::kinetic_energy(const RigidBodyState& state) const {
  return kinetic(state.axes, state.velocity, state.velocity, state.angular_momentum, state.angular_momentum);
}

// (K.56) Torque-free rotation, by turns about the principal axes: the angular momentum stays to rounding, the
// energy within an order of dt^2 for any time. R. I. McLachlan, G. R. W. Quispel, Acta Numerica 11 (2002)
// 341.
void RigidBodyModel::turn(RigidBodyState& state, double dt) const {
  Matrix3d axes = state.axes * principal_axes_;
  for (const auto& [axis, share] : {std::pair(0, 0.5), {1, 0.5}, {2, 1.0}, {1, 0.5}, {0, 0.5}}) {
    const double rate = axes.col(axis).dot(state.angular_momentum) / moments_[axis];
    axes *= about(axis, share * dt * rate);
  }
  make_orthonormal(axes);
  state.axes = axes * principal_axes_.transpose();
}

RigidBodyKick RigidBodyModel::advance(RigidBodyState& state, const RigidBodyLoad& load, double tau,
                                      double dt_after) const {
  if (!(tau >= 0.0)) detail::reject("body step tau", detail::text(tau), "0 or greater");
  if (!(dt_after >= 0.0)) detail::reject("body step dt_after", detail::text(dt_after), "0 or greater");
  const RigidBodyState before = state;
  const Vector3d push = along_rail(load.force), force = push + own_force(state);
  // (K.55) The damper follows the mean of both speeds.
  const double damping = damping_at(state), share = 0.5 * tau * damping / parameters_.mass;
  state.velocity = ((1.0 - share) * before.velocity + tau / parameters_.mass * force) / (1.0 + share);
  if (is_free()) state.angular_momentum += tau * load.couple;
  const Vector3d mean = 0.5 * (before.velocity + state.velocity);
  const Vector3d spin = 0.5 * turned(state.axes, before.angular_momentum + state.angular_momentum);
  RigidBodyKick kick;
  kick.load_work = tau * (push.dot(mean) + (is_free() ? load.couple.dot(spin) : 0.0));
  kick.damping_loss = tau * damping * mean.squaredNorm();
  kick.work = kick.load_work + tau * (force - push).dot(mean) - kick.damping_loss;
  const auto energy = [&](const RigidBodyState& a, const RigidBodyState& b) {
    return kinetic(before.axes, a.velocity, b.velocity, a.angular_momentum, b.angular_momentum);
  };
  kick.kinetic_before = energy(before, before);
  kick.kinetic_after = energy(state, state);
  kick.kinetic_mixed = energy(before, state);
  state.centre += dt_after * state.velocity;
  if (is_free()) turn(state, dt_after);
  if (!(state.centre.allFinite() && state.axes.allFinite()))
    throw ContactError("impactor: force " + detail::text(load.force) + " N, couple " +
                       detail::text(load.couple) + " N m: its place is not finite");
  return kick;
}

double RigidBodyModel::effective_mass(double reach) const {
  return is_free() ? 1.0 / (1.0 / parameters_.mass + reach * reach / moments_[0]) : parameters_.mass;
}

double RigidBodyModel::omega_squared(double contact_force, double reach) const {
  if (is_free()) return contact_force * reach / moments_[0];
  double stiffness = 0.0;
  for (const RailSpring& spring : parameters_.rail->springs) stiffness += spring.stiffness;
  return stiffness / parameters_.mass;
}

}  // namespace coupling
