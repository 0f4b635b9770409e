// SPDX-License-Identifier: Apache-2.0
#include "jet/jet.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <elementary/error_function.hpp>
#include <elementary/trigonometric.hpp>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "field/outline.hpp"
#include "field/profile.hpp"
#include "jet/centreline.hpp"
#include "refuse.hpp"

namespace jet {
namespace {

void require_positive(const char* name, double value) {
  if (!(value > 0.0) || !std::isfinite(value))
    refuse_value(std::string("jet ") + name, value, "finite and > 0");
}

void require_range(const char* name, double value, bool inside, const char* allowed) {
  if (!inside) refuse_value(std::string("jet ") + name, value, allowed);
}

Eigen::Vector3d unit(const char* name, const Eigen::Vector3d& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!vector.allFinite() || largest == 0.0) {
    std::ostringstream message;
    message << "jet " << name << " is (" << vector.transpose() << "), allowed: finite and not zero";
    throw std::invalid_argument(message.str());
  }
  // A unit vector keeps its bits, because the exact visibility uses them.
  if (std::abs(vector.squaredNorm() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) return vector;
  return (vector / largest).normalized();
}

void check_sizes(const JetModel& model) {
  const auto enumerator = [](const char* name, auto value, auto last) {
    require_range(name, static_cast<double>(value), static_cast<int>(value) >= 0 && value <= last,
                  "an enumerator");
  };
  enumerator("shape", model.shape, OutletShape::rectangular);
  enumerator("spread", model.spread, Spread::cone);
  enumerator("direction", model.direction, Direction::radial);
  if (model.shape == OutletShape::round) {
    require_positive("radius", model.radius);
  } else {
    require_positive("short_side", model.short_side);
    require_positive("long_side", model.long_side);
    if (model.short_side > model.long_side)
      refuse_value("jet short_side", model.short_side, "at most long_side");
  }
  require_positive("decay_coefficient", model.decay_coefficient);
}

void check_options(const JetModel& model) {
  const double angle = model.cone_half_angle;
  if (model.spread == Spread::cone) {
    require_positive("cone_initial_width", model.cone_initial_width);
    require_range("cone_half_angle", angle, angle >= 0.0 && angle < 0.5 * std::numbers::pi, "[0, pi/2) rad");
  }
  require_range("restitution", model.restitution,
                model.restitution >= kLeastRestitution && model.restitution <= kMostRestitution,
                kRestitutionRange);
  require_range("cut_off", model.cut_off, model.cut_off >= 0.0 && model.cut_off < 1.0, "[0, 1)");
}

void copy(const Eigen::Vector3d& from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

double profile::exp(double x) {
  return elementary::exp(x);
}

JetModel validated(const JetModel& model) {
  check_sizes(model);
  check_options(model);
  if (!model.centre.allFinite())
    throw std::invalid_argument("jet centre is not finite, allowed: finite coordinates");
  JetModel result = model;
  result.axis = unit("axis", model.axis);
  if (model.shape == OutletShape::rectangular) {
    result.long_direction = unit("long_direction", model.long_direction);
    const double cosine = result.axis.dot(result.long_direction);
    require_range("long_direction . axis", cosine, std::abs(cosine) <= 1e-9,
                  "perpendicular (|cosine| <= 1e-9)");
  }
  return result;
}

// The outlet turns by the smallest rotation that does it: a round one by that of its axis.
double outlet_motion(const JetModel& from, const JetModel& to, double reach) {
  double turn = (to.axis - from.axis).squaredNorm();
  if (from.shape == OutletShape::rectangular)
    turn += (to.long_direction - from.long_direction).squaredNorm() +
            (to.axis.cross(to.long_direction) - from.axis.cross(from.long_direction)).squaredNorm();
  return (to.centre - from.centre).norm() + reach * std::sqrt(turn);
}

JetModel widened(const JetModel& model, double area_ratio) {
  JetModel result = model;
  const double larger = model.shape == OutletShape::round ? std::sqrt(area_ratio) : area_ratio;
  result.radius *= larger;
  result.short_side *= larger;
  result.cone_initial_width *= larger;
  return result;
}

double outlet_area(const JetModel& model) {
  if (model.shape == OutletShape::round) return std::numbers::pi * model.radius * model.radius;
  return model.short_side * model.long_side;
}

double momentum_loss(const JetModel& model) {
  if (model.shape == OutletShape::round || model.cut_off == 0.0) return model.cut_off;
  return elementary::erfc(std::sqrt(-elementary::log(model.cut_off)));
}

RaySource ray_source(const JetModel& model) {
  RaySource source;
  source.centre = model.centre;
  source.axis = model.axis;
  if (model.shape == OutletShape::rectangular) {
    source.long_direction = model.long_direction;
    source.half_long = 0.5 * model.long_side;
  }
  return source;
}

JetShape outline(const JetModel& model) {
  JetShape shape{};
  shape.round = model.shape == OutletShape::round;
  shape.momentum = model.spread == Spread::momentum;
  shape.axial = model.direction == Direction::axial;
  copy(model.centre, shape.centre);
  copy(model.axis, shape.axis);
  shape.size = shape.round ? model.radius : 0.5 * model.short_side;
  shape.decay_coefficient = model.decay_coefficient;
  shape.origin = shape.size * (shape.round ? round_virtual_origin(model.decay_coefficient)
                                           : plane_virtual_origin(model.decay_coefficient));
  if (!shape.round) {
    copy(model.axis.cross(model.long_direction), shape.across);
    copy(model.long_direction, shape.along);
    shape.half_long = 0.5 * model.long_side;
  }
  if (!shape.momentum) {
    shape.cone_width = model.cone_initial_width;
    shape.cone_slope = elementary::tan(model.cone_half_angle);
  }
  return shape;
}

Section section(const JetModel& model, double z) {
  const auto at = profile::section(outline(model), z);
  return {at.decay, at.width};
}

Eigen::Vector3d relative_velocity(const JetModel& model, const Eigen::Vector3d& point) {
  const JetShape shape = outline(model);
  const auto at = profile::local(shape, Vec3<double>{point[0], point[1], point[2]});
  if (at.z <= 0.0 || std::abs(at.along) > shape.half_long) return Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity;
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> unit{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    velocity[i] = profile::velocity_along(shape, at, unit);
  }
  return velocity;
}

}  // namespace jet
