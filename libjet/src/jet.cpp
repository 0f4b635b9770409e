// SPDX-License-Identifier: Apache-2.0
#include "jet/jet.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "profile.hpp"

namespace jet {
namespace {

[[noreturn]] void refuse(const char* name, double value, const char* allowed) {
  std::ostringstream message;
  message.precision(17);
  message << "jet " << name << " is " << value << ", allowed: " << allowed;
  throw std::invalid_argument(message.str());
}

void require_positive(const char* name, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(name, value, "finite and > 0");
}

void require_range(const char* name, double value, bool inside, const char* allowed) {
  if (!inside) refuse(name, value, allowed);
}

Eigen::Vector3d unit(const char* name, const Eigen::Vector3d& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!vector.allFinite() || largest == 0.0) {
    std::ostringstream message;
    message << "jet " << name << " is (" << vector.transpose() << "), allowed: finite and not zero";
    throw std::invalid_argument(message.str());
  }
  // A unit vector stays as it was given: the exact visibility reads these very bits.
  if (std::abs(vector.squaredNorm() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) return vector;
  return (vector / largest).normalized();
}

void check_sizes(const JetModel& model) {
  if (model.shape == OutletShape::round) {
    require_positive("radius", model.radius);
  } else {
    require_positive("short_side", model.short_side);
    require_positive("long_side", model.long_side);
  }
  require_positive("decay_coefficient", model.decay_coefficient);
}

void check_options(const JetModel& model) {
  const double angle = model.cone_half_angle;
  if (model.spread == Spread::cone) {
    require_positive("cone_initial_width", model.cone_initial_width);
    require_range("cone_half_angle", angle, angle >= 0.0 && angle < 0.5 * std::numbers::pi, "[0, pi/2) rad");
  }
  require_range("restitution", model.restitution, model.restitution >= 0.0 && model.restitution <= 1.0,
                "[0, 1]");
  require_range("cut_off", model.cut_off, model.cut_off >= 0.0 && model.cut_off < 1.0, "[0, 1)");
}

double cone_width(const JetModel& model, double z) {
  return model.cone_initial_width + z * std::tan(model.cone_half_angle);
}

}  // namespace

JetModel validated(const JetModel& model) {
  check_sizes(model);
  check_options(model);
  if (!model.centre.allFinite()) throw std::invalid_argument("jet centre is not finite");
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

double outlet_area(const JetModel& model) {
  if (model.shape == OutletShape::round) return std::numbers::pi * model.radius * model.radius;
  return model.short_side * model.long_side;
}

double momentum_loss(const JetModel& model) {
  if (model.shape == OutletShape::round || model.cut_off == 0.0) return model.cut_off;
  return std::erfc(std::sqrt(-std::log(model.cut_off)));
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

Section section(const JetModel& model, double z) {
  const bool round = model.shape == OutletShape::round;
  const double size = round ? model.radius : 0.5 * model.short_side;
  const double decay =
      round ? round_decay(z / size, model.decay_coefficient) : plane_decay(z / size, model.decay_coefficient);
  if (model.spread == Spread::cone) return {decay, cone_width(model, z)};
  return {decay, size * (round ? round_momentum_width(decay) : plane_momentum_width(decay))};
}

Eigen::Vector3d relative_velocity(const JetModel& model, const Eigen::Vector3d& point) {
  const Eigen::Vector3d across = model.axis.cross(model.long_direction);
  const profile::Local local = profile::local(model, across, point);
  if (local.z < 0.0) return Eigen::Vector3d::Zero();
  if (model.shape == OutletShape::rectangular && std::abs(local.along) > 0.5 * model.long_side) {
    return Eigen::Vector3d::Zero();
  }
  return profile::speed(section(model, local.z), local.radius2) * profile::direction(model, across, point);
}

}  // namespace jet
