// SPDX-License-Identifier: Apache-2.0
#include "coupling/pendulum.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <elementary/trigonometric.hpp>

#include "check.hpp"
#include "coupling/error.hpp"

namespace coupling {
namespace {

Eigen::Vector3d unit(const std::string& field, const Eigen::Vector3d& v) {
  const double length = v.stableNorm();
  if (!(std::isfinite(length) && length > 0.0)) detail::reject(field, detail::text(v), "finite and not zero");
  return v / length;
}

// Removes round-off only: a rest direction that leans along the axis would change the given lengths.
Eigen::Vector3d rest_normal_to(const Eigen::Vector3d& axis, const Eigen::Vector3d& given) {
  const Eigen::Vector3d direction = unit("pendulum.rest_direction", given);
  constexpr double kLean = 1e-6;  // [rad] error of a direction typed by hand
  if (std::abs(direction.dot(axis)) > kLean)
    detail::reject("pendulum.rest_direction", detail::text(given), "normal to the axis (to 1e-6 rad)");
  return (direction - direction.dot(axis) * axis).normalized();
}

PendulumParameters checked(PendulumParameters p) {
  detail::require_finite("pendulum.pivot", p.pivot);
  p.axis = unit("pendulum.axis", p.axis);
  p.rest_direction = rest_normal_to(p.axis, p.rest_direction);
  detail::require_positive("pendulum.mass", p.mass);
  detail::require_not_negative("pendulum.inertia_cg", p.inertia_cg);
  detail::require_not_negative("pendulum.cg_distance", p.cg_distance);
  detail::require_positive("pendulum.impactor_distance", p.impactor_distance);
  detail::require_positive("pendulum.impactor_radius", p.impactor_radius);
  if (p.impactor_radius > p.impactor_distance)
    detail::reject("pendulum.impactor_radius", detail::text(p.impactor_radius),
                   "at most impactor_distance (the pivot lies outside the sphere)");
  detail::require_finite("gravity", p.gravity);
  return p;
}

}  // namespace

PendulumModel::PendulumModel(const PendulumParameters& parameters)
    : parameters_(checked(parameters)),
      side_direction_(parameters_.axis.cross(parameters_.rest_direction)),
      axis_inertia_(parameters_.inertia_cg +
                    parameters_.mass * parameters_.cg_distance * parameters_.cg_distance),
      effective_mass_(axis_inertia_ / (parameters_.impactor_distance * parameters_.impactor_distance)) {
  // inertia_cg and cg_distance are both zero; only one may be.
  if (!(axis_inertia_ > 0.0))
    detail::reject("pendulum.inertia_cg", "0", "greater than 0 when cg_distance = 0");
}

Eigen::Vector3d PendulumModel::radial_direction(double angle) const {
  return elementary::cos(angle) * parameters_.rest_direction + elementary::sin(angle) * side_direction_;
}

Eigen::Vector3d PendulumModel::tangential_direction(double angle) const {
  return elementary::cos(angle) * side_direction_ - elementary::sin(angle) * parameters_.rest_direction;
}

Eigen::Vector3d PendulumModel::cg_position(double angle) const {
  return parameters_.pivot + parameters_.cg_distance * radial_direction(angle);
}

Eigen::Vector3d PendulumModel::impactor_centre(double angle) const {
  return parameters_.pivot + parameters_.impactor_distance * radial_direction(angle);
}

Eigen::Vector3d PendulumModel::impactor_velocity(double angle, double angular_velocity) const {
  return angular_velocity * parameters_.impactor_distance * tangential_direction(angle);
}

double PendulumModel::gravity_moment(double angle) const {
  return parameters_.mass * parameters_.cg_distance * parameters_.gravity.dot(tangential_direction(angle));
}

double PendulumModel::moment(const Eigen::Vector3d& force, const Eigen::Vector3d& point) const {
  return parameters_.axis.dot((point - parameters_.pivot).cross(force));
}

double PendulumModel::potential_energy(double angle) const {
  // cos(a) - 1 as -2 sin^2(a/2): small angles keep their digits.
  const double half_sine = elementary::sin(0.5 * angle);
  const Eigen::Vector3d lift =
      elementary::sin(angle) * side_direction_ - 2.0 * half_sine * half_sine * parameters_.rest_direction;
  return -parameters_.mass * parameters_.cg_distance * parameters_.gravity.dot(lift);
}

double PendulumModel::kinetic_energy(double angular_velocity) const {
  return 0.5 * axis_inertia_ * angular_velocity * angular_velocity;
}

PendulumState PendulumModel::advance(const PendulumState& state, double moment, double tau,
                                     double dt_after) const {
  if (!(tau >= 0.0)) detail::reject("pendulum step tau", detail::text(tau), "0 or greater");
  if (!(dt_after >= 0.0)) detail::reject("pendulum step dt_after", detail::text(dt_after), "0 or greater");
  PendulumState next;
  next.angular_velocity = state.angular_velocity + tau * (moment / axis_inertia_);
  next.angle = state.angle + dt_after * next.angular_velocity;
  if (!(std::isfinite(next.angle) && std::isfinite(next.angular_velocity)))
    throw ContactError("pendulum: angle " + detail::text(next.angle) + " rad, moment " +
                       detail::text(moment) + " N m: not finite");
  return next;
}

void PendulumModel::require_followed(double turn) const {
  const double path = parameters_.impactor_distance * std::abs(turn),
               half = 0.5 * parameters_.impactor_radius;
  if (!(path <= half))
    throw ContactError("contact: the impactor swings " + detail::text(path) +
                       " m within one step, the limit is half its radius, " + detail::text(half) + " m");
}

double PendulumModel::angular_velocity_at_level(const PendulumState& state, double moment,
                                                double dt_before) const {
  return state.angular_velocity + 0.5 * dt_before * (moment / axis_inertia_);
}

CgAcceleration PendulumModel::cg_acceleration(double moment, double angular_velocity) const {
  const double tangential = moment / axis_inertia_ * parameters_.cg_distance;
  const double radial = angular_velocity * angular_velocity * parameters_.cg_distance;
  return {tangential, radial, std::sqrt(tangential * tangential + radial * radial)};
}

Eigen::Vector3d PendulumModel::joint_reaction(double angle, double angular_velocity, double moment,
                                              const Eigen::Vector3d& applied_force) const {
  const CgAcceleration a = cg_acceleration(moment, angular_velocity);
  const Eigen::Vector3d acceleration =
      a.tangential * tangential_direction(angle) - a.radial * radial_direction(angle);
  return parameters_.mass * (acceleration - parameters_.gravity) - applied_force;
}

double PendulumModel::omega_squared(const Eigen::Vector3d& contact_force) const {
  return (parameters_.mass * parameters_.gravity.norm() * parameters_.cg_distance +
          contact_force.norm() * parameters_.impactor_distance) /
         axis_inertia_;
}

}  // namespace coupling
