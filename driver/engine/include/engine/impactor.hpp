// SPDX-License-Identifier: Apache-2.0
// The impactor of a scene, whatever carries it: a pendulum, a rail, or nothing.
#pragma once

#include <utility>

#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// Its place at the start.
coupling::Pose impactor_start(const Scene& scene);

/// A body's axes after a rotation vector `turn` [rad]; the same bits everywhere.
Eigen::Matrix3d turned(const Eigen::Matrix3d& axes, const Eigen::Vector3d& turn);

/// Rotation vector [rad] that turns axes into others, by less than half a turn; the same bits everywhere.
Eigen::Vector3d turn_between(const Eigen::Matrix3d& before, const Eigen::Matrix3d& after);

/// Where it is, and how far it has turned.
struct ImpactorMotion {
  coupling::Pose pose;                             // at level n
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();  // [rad] since the last level
};
ImpactorMotion impactor_motion(const Scene& scene, const State& state);
/// Velocity [m/s] of its centre and angular velocity [rad/s], at n-1/2.
std::pair<Eigen::Vector3d, Eigen::Vector3d> impactor_speeds(const Scene& scene, const State& state);
/// [m/s] Speed of its fastest point, at n-1/2.
double impactor_speed(const Scene& scene, const State& state);

/// [m] Farthest point of the shape from its centre; 0 for what looks the same however it turns.
double turning_reach(const coupling::Impactor& shape);

/// [kg] Mass that a force at the impactor feels at least.
double impactor_mass(const Scene& scene);
/// Bound of omega^2 [1/s2] of what carries it, under that contact force.
double impactor_omega_squared(const Scene& scene, const Eigen::Vector3d& force);
/// [-] Direction of its path at level n; zero if it has none.
Eigen::Vector3d impactor_path(const Scene& scene, const State& state);
/// [J] Potential energy of its weight at level n, less that at the start.
double impactor_weight(const Scene& scene, const State& state);

}  // namespace driver
