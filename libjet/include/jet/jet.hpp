// SPDX-License-Identifier: Apache-2.0
// One gas jet: geometry of the outlet, and options of the velocity field downstream.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "jet/visibility.hpp"

namespace jet {

/// Shape of the outlet. The jet is round or plane accordingly.
enum class OutletShape { round, rectangular };

/// Width law: conservation of axial momentum flux, or a constant half angle (as drawn in the paper).
enum class Spread { momentum, cone };

/// Direction of the velocity: along the axis, or away from the virtual origin (a line for a rectangular
/// outlet).
enum class Direction { axial, radial };

/// Gas jet. Members that are NaN by default must be given if the shape or the spread uses them.
struct JetModel {
  /// Default of members that must be given.
  static constexpr double kMustBeGiven = std::numeric_limits<double>::quiet_NaN();

  OutletShape shape = OutletShape::round;  // decides which of the sizes below are used
  Eigen::Vector3d centre = Eigen::Vector3d::Constant(kMustBeGiven);  // [m] centre of the outlet
  Eigen::Vector3d axis = Eigen::Vector3d::Constant(kMustBeGiven);    // [-] into the bag; any length > 0
  /// [-] rectangular: direction of the long side.
  Eigen::Vector3d long_direction = Eigen::Vector3d::Constant(kMustBeGiven);
  double radius = kMustBeGiven;             // [m] round: R0
  double short_side = kMustBeGiven;         // [m] rectangular: 2 b0
  double long_side = kMustBeGiven;          // [m] rectangular: L
  double decay_coefficient = kMustBeGiven;  // [-] a of (J.3), (J.4)

  Spread spread = Spread::momentum;  // how the width grows along the axis
  /// [m] cone: R(0) or b(0), the half-width in the outlet at which V = V_max/e.
  double cone_initial_width = kMustBeGiven;
  double cone_half_angle = kMustBeGiven;  // [rad] cone: 0 <= angle < pi/2

  Direction direction = Direction::axial;  // direction of the velocity
  /// [-] e in [-0.5, 4], at the start: 1 is complete reflection, 0 deflection along the surface. Beyond 1 the
  /// gas that circulates in a closed bag pushes as well.
  double restitution = 1.0;
  /// [-] in [0, 1): elements with (V/V_max)^2 below this are not candidates; see momentum_loss.
  double cut_off = 1e-3;
  /// True: the overpressure follows from the velocity relative to the element. Such a jet damps the skin,
  /// half a step late, at up to c = damping_rate (J.9). The stable step is then less than the skin's own:
  /// omega^2 dt^2 + 2 c dt <= 4.
  bool relative_to_skin = false;
};

/// The model with `axis` and `long_direction` normalised. A vector of unit length to 4 eps keeps its bits.
/// Throws std::invalid_argument, naming the member, for
/// - an axis that is zero or not finite,
/// - a long direction that is not perpendicular to the axis (|cosine| > 1e-9),
/// - a size, coefficient or width that is not positive, and a short side longer than the long side,
/// - a restitution, cut_off or angle out of range.
JetModel validated(const JetModel& model);

/// Bound [m] of the motion, seen from an outlet that goes from one place to another, of points that rest
/// within `reach` [m] of its first centre. Both models come from validated().
double outlet_motion(const JetModel& from, const JetModel& to, double reach);

/// The model of a jet whose outlet has `area_ratio` > 0 times the area: a larger radius, or a larger short
/// side. A cone begins wider by the same factor.
JetModel widened(const JetModel& model, double area_ratio);

/// Area of the outlet [m2], pi R0^2 or 2 b0 L.
double outlet_area(const JetModel& model);

/// Share [-] of the axial momentum flux, and so of the force on an infinite plane, outside the cut-off.
/// Round: cut_off; rectangular: erfc(sqrt(ln(1/cut_off))).
double momentum_loss(const JetModel& model);

/// Source of the jet's rays: the centre (round), or the line through it along the long side (rectangular).
RaySource ray_source(const JetModel& model);

/// State of the jet at one distance from the outlet.
struct Section {
  double decay;  // [-] V_max / V0
  double width;  // [m] R or b, the half-width at which V = V_max/e
};
/// Section at distance z >= 0 [m] from the outlet.
Section section(const JetModel& model, double z);

/// V / V0 [-] by (J.5), without cut-off, at a point strictly downstream of the outlet's plane (z > 0) and
/// between the ends of the long side; zero elsewhere. Precondition: the model comes from validated().
Eigen::Vector3d relative_velocity(const JetModel& model, const Eigen::Vector3d& point);

}  // namespace jet
