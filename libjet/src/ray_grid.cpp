// SPDX-License-Identifier: Apache-2.0
#include "ray_grid.hpp"

#include <cmath>

namespace jet {
namespace {

// Relative to the coordinates' size. Sources of a line lie beside it by 1e-14, so a slope at kNearest errs by
// 1e-9; a ray as long as kShortest turns from its plane by 1e-10: kMargin is ten times that or more.
constexpr double kNearest = 1e-5;
constexpr double kShortest = 1e-4;
constexpr double kMargin = 1e-8;
constexpr double kSquare = 1e-14;
constexpr double kTiny = 1e-300;  // far below any difference of coordinates
constexpr double kEverywhere = 1e300;

constexpr unsigned kSmallW = 1, kSmallSide = 2;  // the latter for u, the next bit for v

int side_for(std::size_t ray_count) {
  return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(ray_count))), 1, 1024);
}

}  // namespace

void RayGrid::reserve(std::size_t ray_count, std::size_t node_count) {
  const std::size_t side = static_cast<std::size_t>(side_for(ray_count));
  nodes_.resize(node_count);
  entries_.reserve(ray_count);
  sorted_.reserve(ray_count);
  wide_.reserve(ray_count);
  cell_start_.reserve(side * side + 2);
}

// Slopes u / w enter as u / (w + |u|): the same order, but bounded, so that a few steep rays do not spoil the
// bins. What is upstream counts as at its side, +-1.
RayGrid::Place RayGrid::place(const Local& x) const {
  const double u = x.side[0], v = x.side[1], near = kNearest * size_, w = std::max(x.w, 0.0) + kTiny;
  const unsigned small = (x.w > near ? 0u : kSmallW) | (std::abs(u) > near ? 0u : kSmallSide) |
                         (std::abs(v) > near ? 0u : 2 * kSmallSide);
  return {u / (w + std::abs(u)), line_ ? v : v / (w + std::abs(v)), small};
}

// A ray from the line's end does not run square to the line: it belongs nowhere in particular.
bool RayGrid::has_place(const Local& target, const Local& ray) const {
  const double u = std::abs(target.side[0]), v = std::abs(target.side[1]);
  const bool far = target.w + std::min(u, line_ ? u : v) > kNearest * size_;
  const bool square = std::abs(ray.side[1]) <= kSquare * size_ && ray.w + u > kShortest * size_;
  return far && (square || !line_);
}

void RayGrid::build(const RayBundle& bundle, const Surface& surface, double size) {
  line_ = bundle.frame.line;
  size_ = size;
  for (int i = 0; i < surface.node_count; ++i)
    nodes_[static_cast<std::size_t>(i)] = place(bundle.frame.at(surface.node(i)));
  entries_.clear();
  wide_.clear();
  auto aside = bundle.aside.begin();
  for (std::uint32_t k = 0; k < bundle.rays.size(); ++k) {
    if (aside != bundle.aside.end() && *aside == k) {
      ++aside;
      continue;
    }
    const blocking::Ray& ray = bundle.rays[k];
    const Local target = bundle.frame.at(ray.target);
    if (has_place(target, bundle.frame.direction(ray.source, ray.target))) {
      const Place at = place(target);
      entries_.push_back({at.p, at.q, k});
    } else {
      wide_.push_back(k);
    }
  }
  sort();
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

// An element that reaches upstream projects to no triangle. If it stays on one side of the axis, its part
// downstream still lies between its corners' slopes and the side; if not, it is anywhere.
void RayGrid::extend(Range& range, int axis, unsigned small, double margin) const {
  const bool one_side = (small & (kSmallSide << axis)) == 0 && range.low[axis] * range.high[axis] > 0.0;
  if ((small & kSmallW) == 0 || one_side) {
    range.low[axis] -= margin;
    range.high[axis] += margin;
  } else {
    range.low[axis] = -kEverywhere;
    range.high[axis] = kEverywhere;
  }
}

RayGrid::Range RayGrid::element_range(const Surface& surface, int element) const {
  const auto& t = surface.triangles[element];
  const Place &a = nodes_[static_cast<std::size_t>(t[0])], &b = nodes_[static_cast<std::size_t>(t[1])],
              &c = nodes_[static_cast<std::size_t>(t[2])];
  Range range{{std::min({a.p, b.p, c.p}), std::min({a.q, b.q, c.q})},
              {std::max({a.p, b.p, c.p}), std::max({a.q, b.q, c.q})}};
  const unsigned small = a.small | b.small | c.small;
  extend(range, 0, small, kMargin);
  if (line_) {
    range.low[1] -= kMargin * size_;
    range.high[1] += kMargin * size_;
  } else {
    extend(range, 1, small, kMargin);
  }
  return range;
}

}  // namespace jet
