// SPDX-License-Identifier: Apache-2.0
// One gas jet: outlet geometry and the options of the velocity field behind it.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "jet/visibility.hpp"

namespace jet {

/// Shape of the outlet: a round or a plane jet.
enum class OutletShape { round, rectangular };

/// Width law: conservation of axial momentum flux, or a constant half angle as drawn in the paper.
enum class Spread { momentum, cone };

/// Direction of the velocity: the axis everywhere, or away from the virtual origin (a line for a rectangular
/// outlet).
enum class Direction { axial, radial };

/// Gas jet. Members that are NaN by default have to be given where the shape or the spread reads them.
struct JetModel {
  /// Default of what has to be given.
  static constexpr double kMustBeGiven = std::numeric_limits<double>::quiet_NaN();

  OutletShape shape = OutletShape::round;  // decides which of the sizes below are read
  Eigen::Vector3d centre = Eigen::Vector3d::Constant(kMustBeGiven);  // [m] centre of the outlet
  Eigen::Vector3d axis = Eigen::Vector3d::Constant(kMustBeGiven);    // [-] into the bag; any length but 0
  Eigen::Vector3d long_direction =
      Eigen::Vector3d::Constant(kMustBeGiven);  // [-] rectangular: along the long side
  double radius = kMustBeGiven;                 // [m] round: R0
  double short_side = kMustBeGiven;             // [m] rectangular: 2 b0
  double long_side = kMustBeGiven;              // [m] rectangular: L
  double decay_coefficient = kMustBeGiven;      // [-] a of (J.3), (J.4)

  Spread spread = Spread::momentum;          // how the width grows along the axis
  double cone_initial_width = kMustBeGiven;  // [m] cone: R(0) or b(0), the 1/e half-width in the outlet
  double cone_half_angle = kMustBeGiven;     // [rad] cone: in [0, pi/2)

  Direction direction = Direction::axial;  // of the velocity
  double restitution = 1.0;  // [-] e in [0, 1]: 1 complete reflection, 0 deflection into the surface
  double cut_off = 1e-3;     // [-] in [0, 1): no candidate where (V/V_max)^2 is below it, see momentum_loss
  bool relative_to_skin = false;  // overpressure from the velocity relative to the element
};

/// The model with `axis` and `long_direction` normalised (a vector of unit length to 4 eps stays as it is).
/// Throws std::invalid_argument that names the member: zero or non-finite axis, long direction not
/// perpendicular to the axis (|cosine| > 1e-9), non-positive size, coefficient or width, restitution,
/// cut_off or angle out of range.
JetModel validated(const JetModel& model);

/// Area of the outlet [m2], pi R0^2 or 2 b0 L.
double outlet_area(const JetModel& model);

/// Share of the axial momentum flux outside the cut-off, hence of the force on an infinite plate [-]:
/// round cut_off, rectangular erfc(sqrt(ln(1/cut_off))).
double momentum_loss(const JetModel& model);

/// Where the jet's rays start: the centre (round), or the line through it along the long side (rectangular).
RaySource ray_source(const JetModel& model);

/// What the jet has become at one distance from the outlet.
struct Section {
  double decay;  // [-] V_max / V0
  double width;  // [m] R or b, where V is V_max/e
};
/// Section at the distance z >= 0 [m] from the outlet.
Section section(const JetModel& model, double z);

/// Velocity relative to the outlet's, V / V0 [-], at a point strictly downstream of the outlet's plane (z >
/// 0) and within the long side's ends (J.5); zero elsewhere. No cut-off. Precondition: the model comes from
/// validated().
Eigen::Vector3d relative_velocity(const JetModel& model, const Eigen::Vector3d& point);

}  // namespace jet
