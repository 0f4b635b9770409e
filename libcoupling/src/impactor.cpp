// SPDX-License-Identifier: Apache-2.0
#include "coupling/impactor.hpp"

#include <Eigen/LU>

#include "check.hpp"
#include "placed_body.hpp"

namespace coupling {
namespace {

void require_valid_shape(const Sphere& sphere) {
  detail::require_positive("impactor.radius", sphere.radius);
}

void require_valid_shape(const Ellipsoid& ellipsoid) {
  for (const double half_axis : ellipsoid.half_axes)
    detail::require_positive("impactor.half_axes", half_axis);
}

void require_valid_shape(const Cylinder& cylinder) {
  detail::require_positive("impactor.radius", cylinder.radius);
  detail::require_not_negative("impactor.half_length", cylinder.half_length);
}

void require_valid_shape(const Disc& disc) {
  detail::require_not_negative("impactor.radius", disc.radius);
  detail::require_positive("impactor.rim_radius", disc.rim_radius);
}

}  // namespace

void detail::require_axes(const Eigen::Matrix3d& axes) {
  const Eigen::Matrix3d error = axes.transpose() * axes - Eigen::Matrix3d::Identity();
  if (error.cwiseAbs().maxCoeff() <= 1e-9 && axes.determinant() > 0.0) return;
  std::string columns;
  for (const auto& axis : axes.colwise()) columns += (columns.empty() ? "[" : ", ") + text(axis);
  reject("pose.axes", columns + "]", "orthonormal and right-handed within 1e-9");
}

void require_valid(const Impactor& impactor) {
  std::visit([](const auto& shape) { require_valid_shape(shape); }, impactor);
}

double size_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).size(); }, impactor);
}

double reach_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).reach(); }, impactor);
}

double section_of(const Impactor& impactor) {
  return std::visit([](const auto& shape) { return detail::body_of(shape).section(); }, impactor);
}

SignedDistance signed_distance(const Impactor& impactor, const Pose& pose, const Eigen::Vector3d& point) {
  require_valid(impactor);
  return std::visit(
      [&](const auto& shape) { return detail::place(shape, pose.axes).signed_distance(point - pose.centre); },
      impactor);
}

}  // namespace coupling
