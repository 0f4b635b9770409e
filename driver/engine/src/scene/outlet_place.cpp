// SPDX-License-Identifier: Apache-2.0
// Where an outlet is to the bag that it is to blow into.
#include "scene/outlet_place.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "base/number_text.hpp"
#include "coupling/side.hpp"

namespace driver {
namespace {

// A line across an outlet: from a point that must be inside, half a width to either side.
struct Across {
  Eigen::Vector3d middle, direction;
  double half;  // [m]
};

// Four diameters (round), or the short side at three places of the long one (rectangular): the jet comes from
// the centre, or from the line between the middles of the short sides.
std::vector<Across> lines_across(const jet::JetModel& model) {
  std::vector<Across> lines;
  if (model.shape == jet::OutletShape::rectangular) {
    for (const double l : {0.0, -0.5, 0.5})
      lines.push_back({model.centre + l * model.long_side * model.long_direction,
                       model.axis.cross(model.long_direction), 0.5 * model.short_side});
    return lines;
  }
  const Eigen::Vector3d first = model.axis.unitOrthogonal(), second = model.axis.cross(first);
  for (int i = 0; i < 4; ++i) {
    const double angle = i * std::numbers::pi / 4.0;
    lines.push_back(
        {model.centre, elementary::cos(angle) * first + elementary::sin(angle) * second, model.radius});
  }
  return lines;
}

// An element that a ray meets, and the way to it [m].
struct Hit {
  double way = std::numeric_limits<double>::infinity();
  Eigen::Index element = -1;
};

// Where an outlet's points are to a bag, each moved along the axis by a millionth of the bag's size.
class OutletPlace {
 public:
  OutletPlace(const jet::JetModel& model, const Eigen::Matrix3Xi& elements, const Eigen::Matrix3Xd& nodes)
      : axis_(model.axis), lines_(lines_across(model)), elements_(elements), nodes_(nodes) {
    size_ = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm();
  }
  /// The first point that is where it may not be, none if the outlet is within the bag, moved along the axis
  /// by `way` [m]. A rim may be outside in a bag that is thinner than the outlet.
  std::optional<Eigen::Vector3d> outside(double way = 0.0) const {
    for (const Across& line : lines_) {
      if (is_outside(line.middle, way)) return line.middle;
      const auto rim = rim_outside(line, way);
      if (rim && !thickness(line, way)) return rim;
    }
    return {};
  }
  /// The outlet's centre if it is outside, and so is the point a hundredth of the outlet's width before it: a
  /// skin on which it lies may tremble, and a layer may lie close before it.
  std::optional<Eigen::Vector3d> centre_outside() const {
    const Across& line = lines_.front();
    const bool is_out = is_outside(line.middle, 0.0) && is_outside(line.middle, 0.02 * line.half);
    return is_out ? std::optional(line.middle) : std::nullopt;
  }
  /// Least thickness [m] of the bag where the outlet's rim is outside; none if it is inside.
  std::optional<double> thin_bag() const {
    std::optional<double> least;
    for (const Across& line : lines_)
      if (rim_outside(line, 0.0)) least = std::min(least.value_or(2.0 * line.half), *thickness(line, 0.0));
    return least;
  }
  /// The shortest way along the axis into the bag [m], none if there is none.
  std::optional<double> way_inside() const {
    std::vector<double> ways;
    for (const Across& line : lines_)
      for (const Eigen::Vector3d& point :
           {Eigen::Vector3d(line.middle - line.half * line.direction), line.middle,
            Eigen::Vector3d(line.middle + line.half * line.direction)})
        for (Eigen::Index e = 0; e < elements_.cols(); ++e)
          if (const double way = way_to(e, point, axis_); way > 0.0) ways.push_back(way);
    std::ranges::sort(ways);
    for (const double way : ways)
      if (const double digits = three_digits_above(way); !outside(digits)) return digits;
    return std::nullopt;
  }

 private:
  Eigen::Vector3d moved(const Eigen::Vector3d& point, double way) const {
    return point + (way + 1e-6 * size_) * axis_;
  }
  bool is_outside(const Eigen::Vector3d& point, double way) const {
    return !(coupling::winding_number(elements_, nodes_, moved(point, way)) > 0.5);
  }
  std::optional<Eigen::Vector3d> rim_outside(const Across& line, double way) const {
    for (const double sign : {-1.0, 1.0})
      if (const Eigen::Vector3d rim = line.middle + sign * line.half * line.direction; is_outside(rim, way))
        return rim;
    return {};
  }
  // Thickness [m] of the bag along a line across the outlet, if it is less than the outlet's width and the
  // skin on both sides runs along the jet, which then blows between two sheets. None otherwise: the outlet
  // would fit, or the jet would meet the skin from outside.
  std::optional<double> thickness(const Across& line, double way) const {
    const Eigen::Vector3d middle = moved(line.middle, way);
    const Hit ahead = first_hit(middle, line.direction), behind = first_hit(middle, -line.direction);
    const double whole = ahead.way + behind.way;
    const bool between = whole > 1e-6 * size_;  // of two sheets: in one, it is met both ways
    if (!between || !(whole < 2.0 * line.half) || !is_along_axis(ahead.element) ||
        !is_along_axis(behind.element))
      return {};
    return whole;
  }
  bool is_along_axis(Eigen::Index e) const {
    constexpr double most = 0.5;  // sine of the angle between skin and axis: 30 degrees
    const Eigen::Matrix3d x = nodes_(Eigen::all, elements_.col(e));
    const Eigen::Vector3d normal = (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0));
    return std::abs(normal.dot(axis_)) <= most * normal.norm();
  }
  Hit first_hit(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const {
    Hit first;
    for (Eigen::Index e = 0; e < elements_.cols(); ++e)
      if (const double way = way_to(e, point, direction); way >= 0.0 && way < first.way) first = {way, e};
    return first;
  }
  // From a point to an element [m]; not a number if the way passes beside it.
  double way_to(Eigen::Index e, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const {
    const auto corner = [&](int i) -> Eigen::Vector3d { return nodes_.col(elements_(i, e)) - point; };
    Eigen::Matrix3d edges;
    edges << corner(1) - corner(0), corner(2) - corner(0), -direction;
    const Eigen::Vector3d at = -edges.inverse() * corner(0);
    constexpr double slack = 1e-9;  // a way along an edge meets one of its elements
    const bool is_met = at.x() >= -slack && at.y() >= -slack && at.x() + at.y() <= 1.0 + slack;
    return is_met ? at.z() : std::nan("");
  }

  Eigen::Vector3d axis_;
  std::vector<Across> lines_;
  const Eigen::Matrix3Xi& elements_;
  const Eigen::Matrix3Xd& nodes_;
  double size_ = 0.0;  // [m] of the bag
};

[[noreturn]] void refuse(const jet::JetModel& model, const OutletPlace& place, const Eigen::Vector3d& point) {
  std::string advice;
  if (const auto way = place.way_inside()) {
    const Eigen::Vector3d centre = model.centre + *way * model.axis;
    advice = fmt::format("; moved {:.3g} m along its axis it is inside: centre = [{:.6g}, {:.6g}, {:.6g}]",
                         *way, centre.x(), centre.y(), centre.z());
  }
  throw std::invalid_argument(fmt::format(
      "the outlet's point [{:.3g}, {:.3g}, {:.3g}] m is outside the bag{}; allowed: an outlet inside it, "
      "flat "
      "on its skin with the axis inwards, or between two sheets along the axis that are closer than the "
      "outlet is wide{}",
      point.x(), point.y(), point.z(),
      point == model.centre ? "" : " (the centre is inside, but the rim is outside the skin)", advice));
}

}  // namespace

std::optional<double> require_outlet_inside(const jet::JetModel& model, const BagPart& bag) {
  const OutletPlace place(model, bag.mesh.elements, bag.initial_position);
  if (const auto point = place.outside()) refuse(model, place, *point);
  return place.thin_bag();
}

void require_centre_inside(const jet::JetModel& model, const Eigen::Matrix3Xi& elements,
                           const Eigen::Matrix3Xd& nodes) {
  const OutletPlace place(model, elements, nodes);
  if (const auto point = place.centre_outside()) refuse(model, place, *point);
}

}  // namespace driver
