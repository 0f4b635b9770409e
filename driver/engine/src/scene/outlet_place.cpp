// SPDX-License-Identifier: Apache-2.0
// Where an outlet is to the bag that it is to blow into.
#include "scene/outlet_place.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "base/number_text.hpp"
#include "coupling/side.hpp"

namespace driver {
namespace {

// The outlet's centre and its corners (rectangular) or eight points of its rim (round).
std::vector<Eigen::Vector3d> outlet_points(const jet::JetModel& model) {
  std::vector<Eigen::Vector3d> points{model.centre};
  if (model.shape == jet::OutletShape::rectangular) {
    const Eigen::Vector3d across = model.axis.cross(model.long_direction);
    for (const double l : {-0.5, 0.5})
      for (const double s : {-0.5, 0.5})
        points.push_back(model.centre + l * model.long_side * model.long_direction +
                         s * model.short_side * across);
    return points;
  }
  const Eigen::Vector3d first = model.axis.unitOrthogonal(), second = model.axis.cross(first);
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::numbers::pi / 4.0;
    points.push_back(model.centre +
                     model.radius * (elementary::cos(angle) * first + elementary::sin(angle) * second));
  }
  return points;
}

// Where an outlet's points are to a bag, each moved along the axis by a millionth of the bag's size.
class OutletPlace {
 public:
  OutletPlace(const jet::JetModel& model, const BagPart& bag)
      : axis_(model.axis), points_(outlet_points(model)), bag_(bag) {
    const auto& nodes = bag.initial_position;
    size_ = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm();
  }
  /// The first point outside the bag, none if the outlet is within it, moved along the axis by `way` [m].
  const Eigen::Vector3d* outside(double way = 0.0) const {
    for (const Eigen::Vector3d& point : points_)
      if (!(coupling::winding_number(bag_.mesh.elements, bag_.initial_position,
                                     point + (way + 1e-6 * size_) * axis_) > 0.5))
        return &point;
    return nullptr;
  }
  /// The shortest way along the axis into the bag [m], none if there is none.
  std::optional<double> way_inside() const {
    std::vector<double> ways;
    for (const Eigen::Vector3d& point : points_)
      for (Eigen::Index e = 0; e < bag_.mesh.elements.cols(); ++e)
        if (const double way = way_to(e, point); way > 0.0) ways.push_back(way);
    std::ranges::sort(ways);
    for (const double way : ways)
      if (const double digits = three_digits_above(way); !outside(digits)) return digits;
    return std::nullopt;
  }

 private:
  // Along the axis from a point to an element [m]; not a number if it passes beside it.
  double way_to(Eigen::Index e, const Eigen::Vector3d& point) const {
    const auto corner = [&](int i) -> Eigen::Vector3d {
      return bag_.initial_position.col(bag_.mesh.elements(i, e)) - point;
    };
    Eigen::Matrix3d edges;
    edges << corner(1) - corner(0), corner(2) - corner(0), -axis_;
    const Eigen::Vector3d at = -edges.inverse() * corner(0);
    return at.x() >= 0.0 && at.y() >= 0.0 && at.x() + at.y() <= 1.0 ? at.z() : std::nan("");
  }

  Eigen::Vector3d axis_;
  std::vector<Eigen::Vector3d> points_;
  const BagPart& bag_;
  double size_ = 0.0;  // [m] of the bag
};

}  // namespace

void require_outlet_inside(const jet::JetModel& model, const BagPart& bag) {
  const OutletPlace place(model, bag);
  const Eigen::Vector3d* point = place.outside();
  if (!point) return;
  std::string advice;
  if (const auto way = place.way_inside()) {
    const Eigen::Vector3d centre = model.centre + *way * model.axis;
    advice = fmt::format("; moved {:.3g} m along its axis it is inside: centre = [{:.6g}, {:.6g}, {:.6g}]",
                         *way, centre.x(), centre.y(), centre.z());
  }
  throw std::invalid_argument(fmt::format(
      "the outlet's point [{:.3g}, {:.3g}, {:.3g}] m is outside the bag{}; allowed: an outlet inside it, or "
      "flat on its skin with the axis inwards{}",
      point->x(), point->y(), point->z(),
      *point == model.centre ? "" : " (the centre is inside, but the rim is outside the skin)", advice));
}

}  // namespace driver
