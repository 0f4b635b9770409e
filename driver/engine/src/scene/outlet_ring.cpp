// SPDX-License-Identifier: Apache-2.0
#include "scene/outlet_ring.hpp"

#include <Eigen/Geometry>
#include <elementary/trigonometric.hpp>
#include <numbers>

namespace driver {
namespace {

const Bounds ring_angle{0.0, std::numbers::pi, true, "above 0, at most pi", "rad"};

}  // namespace

std::vector<jet::JetModel> read_ring(TableReader& outlet, const jet::JetModel& model) {
  if (!outlet.has("ring")) return {model};
  if (model.shape != jet::OutletShape::round)
    outlet.fail("ring", "is of round holes: shape is \"rectangular\"");
  TableReader table = outlet.table("ring");
  const int holes = table.at("holes").integer(2, 64, 8);
  const double radius = table.at("radius").number(non_negative.in("m"), 0.0);
  const double angle = table.at("angle").number(ring_angle, 0.5 * std::numbers::pi, "pi/2");
  const Eigen::Vector3d axis = model.axis.normalized();
  const Eigen::Vector3d first = table.at("first").vector("", axis.unitOrthogonal(), "any across the axis");
  const Eigen::Vector3d across = first - first.dot(axis) * axis;
  if (!(across.norm() > 1e-6 * first.norm())) table.fail("first", "is along the axis");
  table.finish();
  std::vector<jet::JetModel> ring;
  for (int k = 0; k < holes; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / holes;
    const Eigen::Vector3d outward =
        elementary::cos(turn) * across.normalized() + elementary::sin(turn) * axis.cross(across.normalized());
    ring.push_back(model);
    ring.back().centre = model.centre + radius * outward;
    ring.back().axis = elementary::cos(angle) * axis + elementary::sin(angle) * outward;
  }
  return ring;
}

}  // namespace driver
