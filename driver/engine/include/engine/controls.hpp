// SPDX-License-Identifier: Apache-2.0
// What the caller of a simulation sets between steps. Each value stays until it is set again. Values that
// forces feel hold from this level on, or from the next one if this is evaluated; the others from this step
// on. All throw std::invalid_argument for a part that the scene does not have and a value out of range, and
// then change nothing.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "engine/simulation.hpp"

namespace driver {

/// Area [m2] >= 0 of a vent, in place of the case's constant or curve. The vent's trigger stays.
void set_vent_area(Simulation& simulation, std::size_t vent, double area);
/// Switches a sensor of the case with `external = true`. `name`: its name.
void set_sensor(Simulation& simulation, const std::string& name, bool on);
/// Gas outside the volume: pressure [Pa] >= 0, temperature [K]. Walls that lose heat keep their outside
/// temperature.
void set_ambient(Simulation& simulation, double pressure, double temperature);
/// What an inflator delivers, whatever its trigger does: mass flow [kg/s] >= 0, temperature [K].
void set_inflow(Simulation& simulation, std::size_t inflator, double mass_flow, double temperature);
/// Place and direction of a jet's outlet: centre [m], axis [-] of any length. A slot's long side turns by the
/// smallest rotation that turns the axis. Throws in addition if its centre is outside the bag, which is
/// looked at each time it has moved by a tenth of its size or turned by 0.1 rad.
void set_outlet(Simulation& simulation, std::size_t jet, const Eigen::Vector3d& centre,
                const Eigen::Vector3d& axis);
/// Steps meet the multiples of an interval [s], a millionth of the end time or more, from now on, at which
/// the caller exchanges values, or of none if it is 0. Better than advance_exactly(), as steps between two of
/// them are equal.
void meet_every(Simulation& simulation, double interval);
/// Gravity [m/s2], or its sum with the opposite of a frame's acceleration. The case must not have a constant
/// one.
void set_gravity(Simulation& simulation, const Eigen::Vector3d& gravity);

/// Sets a value as it was set before, an outlet without a look at the bag. Throws as that function.
void apply(Simulation& simulation, const Control& control);

/// Where an impactor is and how it goes on.
struct ImpactorPlace {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();            // [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();          // columns: the body's axes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // [rad/s]
};
/// Moves the scene's impactor, on a rail or free, from now on in place of its own dynamics. It goes on at
/// these speeds until the next call. The step's bound keeps the mass of the case. Throws in addition if the
/// level is evaluated, and for a jump of more than half of what the contact may sink in.
void set_impactor(Simulation& simulation, const ImpactorPlace& place);
/// Speeds [m/s], [rad/s] with which an impactor of the caller goes on from this level; also once that is
/// evaluated, so that they may follow from its forces.
void set_impactor_speed(Simulation& simulation, const Eigen::Vector3d& velocity,
                        const Eigen::Vector3d& angular_velocity);

/// The gas of a state's level, evaluated or not, in a scene with a volume of it. Throws gas::DomainError.
gas::GasPoint gas_now(const Scene& scene, const State& state);

/// Forces [N] of the caller on the nodes of the skin, which the caller may write at any time; zero at first.
/// S8 reads them. The view is valid as long as the simulation. The step's bound does not know their
/// stiffness.
membrane::VectorsMap own_force(Simulation& simulation);

}  // namespace driver
