// SPDX-License-Identifier: Apache-2.0
#include "engine/impactor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <variant>

namespace driver {
namespace {

using coupling::Pose, Eigen::Matrix3d, Eigen::Vector3d;

// Rotation about a unit vector; the same bits everywhere.
Matrix3d rotation(const Vector3d& axis, double angle) {
  Matrix3d cross;
  cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
  return Matrix3d::Identity() + elementary::sin(angle) * cross +
         (1.0 - elementary::cos(angle)) * cross * cross;
}

// A sphere needs no axes.
Pose on_pendulum(const Scene& scene, double angle) {
  const PendulumPart& part = *scene.pendulum;
  Pose pose{part.model.impactor_centre(angle)};
  if (!std::holds_alternative<coupling::Sphere>(scene.impactor))
    pose.axes = rotation(part.model.parameters().axis, angle) * part.axes;
  return pose;
}

}  // namespace

Matrix3d turned(const Matrix3d& axes, const Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0.0 ? Matrix3d(rotation(turn / angle, angle) * axes) : axes;
}

Vector3d turn_between(const Matrix3d& before, const Matrix3d& after) {
  const Matrix3d r = after * before.transpose();
  const Vector3d axial(0.5 * (r(2, 1) - r(1, 2)), 0.5 * (r(0, 2) - r(2, 0)), 0.5 * (r(1, 0) - r(0, 1)));
  const double sine = axial.norm();
  if (!(sine > 0.0)) return Vector3d::Zero();
  return elementary::atan2(sine, 0.5 * (r.trace() - 1.0)) / sine * axial;
}

double turning_reach(const coupling::Impactor& shape) {
  return std::holds_alternative<coupling::Sphere>(shape) ? 0.0 : coupling::reach_of(shape);
}

Pose impactor_start(const Scene& scene) {
  if (scene.pendulum) return on_pendulum(scene, scene.pendulum->initial.angle);
  const coupling::RigidBodyParameters& body = scene.body->model.parameters();
  return {body.centre, body.axes};
}

ImpactorMotion impactor_motion(const Scene& scene, const State& state) {
  if (scene.pendulum) {
    // The central difference turned the pendulum by this since the last level.
    const coupling::PendulumState& motion = state.pendulum->motion;
    return {on_pendulum(scene, motion.angle),
            state.step.before * motion.angular_velocity * scene.pendulum->model.parameters().axis};
  }
  const coupling::RigidBodyState& motion = state.body->motion;
  if (state.body->driven)
    return {{motion.centre, motion.axes}, turn_between(state.body->last_pose.axes, motion.axes)};
  return {{motion.centre, motion.axes}, state.step.before * scene.body->model.angular_velocity(motion)};
}

std::pair<Vector3d, Vector3d> impactor_speeds(const Scene& scene, const State& state) {
  if (scene.pendulum) {
    const coupling::PendulumModel& model = scene.pendulum->model;
    const double rate = state.pendulum->motion.angular_velocity;
    return {model.impactor_velocity(state.level.pendulum_angle, rate), rate * model.parameters().axis};
  }
  return {state.body->motion.velocity, scene.body->model.angular_velocity(state.body->motion)};
}

double impactor_speed(const Scene& scene, const State& state) {
  const double reach = turning_reach(scene.impactor);
  if (scene.pendulum)
    return (scene.pendulum->model.parameters().impactor_distance + reach) *
           std::abs(state.pendulum->motion.angular_velocity);
  const coupling::RigidBodyState& motion = state.body->motion;
  return motion.velocity.norm() + reach * scene.body->model.angular_velocity(motion).norm();
}

double impactor_mass(const Scene& scene) {
  if (scene.pendulum) {
    // At the point farthest from the pivot; friction of a sphere has a factor of its own.
    const coupling::PendulumModel& model = scene.pendulum->model;
    const double arm = model.parameters().impactor_distance + turning_reach(scene.impactor);
    return model.axis_inertia() / (arm * arm);
  }
  return scene.body->model.effective_mass(coupling::reach_of(scene.impactor));
}

double impactor_omega_squared(const Scene& scene, const Vector3d& force) {
  if (scene.pendulum)
    return scene.pendulum->model.omega_squared(force) +
           force.norm() * turning_reach(scene.impactor) / scene.pendulum->model.axis_inertia();
  return scene.body->model.omega_squared(force.norm(), coupling::reach_of(scene.impactor));
}

Vector3d impactor_path(const Scene& scene, const State& state) {
  if (scene.pendulum)
    return scene.pendulum->model.impactor_velocity(state.level.pendulum_angle, 1.0).normalized();
  const coupling::RigidBodyParameters& body = scene.body->model.parameters();
  return body.rail ? body.rail->direction : body.velocity.stableNormalized();
}

double impactor_weight(const Scene& scene, const State& state) {
  if (state.pendulum) return scene.pendulum->model.potential_energy(state.level.pendulum_angle);
  return state.body ? state.body->gravity_energy : 0.0;
}

}  // namespace driver
