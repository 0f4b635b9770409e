// SPDX-License-Identifier: Apache-2.0
#include "ray_grid.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace jet {
namespace {

// Relative to the coordinates' size. Sources of a line lie beside it by 3e-16, so a slope at kNearest errs by
// 1e-9; a ray as long as kShortest turns from its plane by 1e-10: kMargin is ten times that or more.
constexpr double kNearest = 1e-6;
constexpr double kShortest = 1e-4;
constexpr double kMargin = 1e-8;
constexpr double kSquare = 1e-14;
constexpr double kEverywhere = 1e300;

int side_for(std::size_t ray_count) {
  return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(ray_count))), 1, 1024);
}

}  // namespace

void RayGrid::reserve(std::size_t ray_count) {
  const std::size_t side = static_cast<std::size_t>(side_for(ray_count));
  entries_.reserve(ray_count);
  sorted_.reserve(ray_count);
  wide_.reserve(ray_count);
  cell_start_.reserve(side * side + 2);
}

bool RayGrid::set_frame(const RaySource& source) {
  centre_ = source.centre;
  line_ = source.half_long > 0.0;
  forward_ = source.axis / source.axis.cwiseAbs().maxCoeff();
  if (line_) {
    along_ = source.long_direction;
    if (std::abs(along_.squaredNorm() - 1.0) > 1e-12) return false;
    forward_ -= forward_.dot(along_) * along_;  // must not cancel, to be square to a few roundings
    if (forward_.squaredNorm() < 0.01) return false;
    forward_.normalize();
  } else {
    forward_.normalize();
    along_ = forward_.unitOrthogonal();
  }
  across_ = forward_.cross(along_);
  return true;
}

// Slopes x / w enter as x / (w + |x|): the same order, but bounded, so that a few steep rays do not spoil the
// bins.
RayGrid::Place RayGrid::place(const double* x) const {
  const Eigen::Vector3d d = Eigen::Map<const Eigen::Vector3d>(x) - centre_;
  const double w = d.dot(forward_);
  if (!(w > kNearest * size_)) return {0.0, 0.0, false};
  const double across = d.dot(across_), along = d.dot(along_);
  return {across / (w + std::abs(across)), line_ ? along : along / (w + std::abs(along)), true};
}

bool RayGrid::build(const std::vector<blocking::Ray>& rays, const RaySource& source, double size) {
  size_ = size;
  if (!set_frame(source)) return false;
  entries_.clear();
  wide_.clear();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Place at = place(rays[k].target);
    const std::uint32_t index = static_cast<std::uint32_t>(k);
    // A ray from the line's end does not run square to the line: it belongs nowhere in particular.
    const Eigen::Vector3d d =
        Eigen::Map<const Eigen::Vector3d>(rays[k].target) - Eigen::Map<const Eigen::Vector3d>(rays[k].source);
    const bool square =
        !line_ || (std::abs(d.dot(along_)) <= kSquare * size && d.dot(forward_) > kShortest * size);
    if (at.usable && square) {
      entries_.push_back({at.p, at.q, index});
    } else {
      wide_.push_back(index);
    }
  }
  sort();
  return true;
}

int RayGrid::bin(double value, int axis) const {
  const double x = (value - first_[axis]) * scale_[axis];
  return x <= 0.0 ? 0 : x >= side_ - 1 ? side_ - 1 : static_cast<int>(x);
}

void RayGrid::sort() {
  side_ = side_for(entries_.size());
  double last[2] = {-HUGE_VAL, -HUGE_VAL};
  first_[0] = first_[1] = HUGE_VAL;
  for (const Entry& e : entries_) {
    first_[0] = std::min(first_[0], e.p), last[0] = std::max(last[0], e.p);
    first_[1] = std::min(first_[1], e.q), last[1] = std::max(last[1], e.q);
  }
  for (int i = 0; i < 2; ++i) scale_[i] = last[i] > first_[i] ? side_ / (last[i] - first_[i]) : 0.0;
  if (entries_.empty()) first_[0] = first_[1] = 0.0;
  cell_start_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 2, 0);
  for (const Entry& e : entries_) ++cell_start_[static_cast<std::size_t>(cell(e)) + 2];
  for (std::size_t i = 2; i < cell_start_.size(); ++i) cell_start_[i] += cell_start_[i - 1];
  sorted_.resize(entries_.size());
  for (const Entry& e : entries_) sorted_[cell_start_[static_cast<std::size_t>(cell(e)) + 1]++] = e;
}

RayGrid::Range RayGrid::element_range(const Surface& surface, int element) const {
  Range range{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (int corner = 0; corner < 3; ++corner) {
    const Place at = place(surface.corner(element, corner));
    if (!at.usable) return {{-kEverywhere, -kEverywhere}, {kEverywhere, kEverywhere}};
    const double margin_p = kMargin;
    const double margin_q = kMargin * (line_ ? size_ : 1.0);
    range.low[0] = std::min(range.low[0], at.p - margin_p);
    range.high[0] = std::max(range.high[0], at.p + margin_p);
    range.low[1] = std::min(range.low[1], at.q - margin_q);
    range.high[1] = std::max(range.high[1], at.q + margin_q);
  }
  return range;
}

}  // namespace jet
