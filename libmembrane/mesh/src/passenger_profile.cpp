// SPDX-License-Identifier: Apache-2.0
#include "passenger_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <elementary/trigonometric.hpp>
#include <numbers>

namespace mesh {
namespace {

using Vec2 = ProfilePoint;

double perimeter(const PassengerBagOptions& o) {
  return 2.0 * (o.depth + o.height) - (4.0 - std::numbers::pi) * (o.back_radius + o.front_radius);
}

// Point of the upper half of the profile at arc length t from the middle of the back, 0 <= t <= perimeter
// / 2.
Vec2 upper_profile(const PassengerBagOptions& o, double t) {
  const double half = 0.5 * o.height, rb = o.back_radius, rf = o.front_radius;
  const double quarter = 0.5 * std::numbers::pi;
  if (t <= half - rb) return {0.0, t};
  t -= half - rb;
  if (t <= quarter * rb) return {rb - rb * elementary::cos(t / rb), half - rb + rb * elementary::sin(t / rb)};
  t -= quarter * rb;
  if (t <= o.depth - rb - rf) return {rb + t, half};
  t -= o.depth - rb - rf;
  if (t <= quarter * rf)
    return {o.depth - rf + rf * elementary::sin(t / rf), half - rf + rf * elementary::cos(t / rf)};
  t -= quarter * rf;
  return {o.depth, half - rf - t};
}

double smallest_altitude(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  return twice_area / std::max({u.norm(), v.norm(), (c - b).norm()});
}

// Smallest altitude of the elements abc and acd.
double diagonal_altitude(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return std::min(smallest_altitude(a, b, c), smallest_altitude(a, c, d));
}

}  // namespace

int rim_count(const PassengerBagOptions& o) {
  return 2 * (o.depth_cells + o.height_cells);
}

double rim_step(const PassengerBagOptions& o) {
  return perimeter(o) / rim_count(o);
}

// Counts positions in half steps from the middle of the back, so that both halves are exact mirror images.
std::vector<Vec2> rim_points(const PassengerBagOptions& o) {
  const int count = rim_count(o);
  std::vector<Vec2> points;
  for (int r = 0; r < count; ++r) {
    int half_steps = 2 * r - o.height_cells;
    if (half_steps > count) half_steps -= 2 * count;
    Vec2 point = upper_profile(o, 0.5 * std::abs(half_steps) * rim_step(o));
    if (half_steps < 0) point.y() = -point.y();
    points.push_back(point);
  }
  return points;
}

SideGrid::SideGrid(const PassengerBagOptions& o) : nx_(o.depth_cells), nz_(o.height_cells) {
  const std::vector<Vec2> rim = rim_points(o);
  points_.assign(static_cast<std::size_t>((nx_ + 1) * (nz_ + 1)), Vec2(0.5 * o.depth, 0.0));
  for (int i = 0; i <= nx_; ++i)
    for (int k = 0; k <= nz_; ++k)
      if (const int r = rim_index(i, k); r >= 0) at(i, k) = rim[static_cast<std::size_t>(r)];
  smooth();
}

int SideGrid::rim_index(int i, int k) const {
  if (i == 0) return k;
  if (k == nz_) return nz_ + i;
  if (i == nx_) return 2 * nz_ + nx_ - k;
  return k == 0 ? 2 * (nz_ + nx_) - i : -1;
}

// A sweep multiplies the slowest mode by 1 - pi^2 / 4 (1 / nx^2 + 1 / nz^2); all sweeps together reduce it to
// e^-39 or less.
void SideGrid::smooth() {
  const int sweeps = 4 * (nx_ * nx_ + nz_ * nz_);
  std::vector<Vec2> next = points_;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int k = 1; k < nz_; ++k)
      for (int i = 1; i < nx_; ++i)
        next[static_cast<std::size_t>(i + k * (nx_ + 1))] =
            0.25 * ((at(i - 1, k) + at(i + 1, k)) + (at(i, k - 1) + at(i, k + 1)));
    points_.swap(next);
  }
}

bool SideGrid::rising_diagonal(int i, int k) const {
  constexpr double nearly = 0.02;
  const SideGrid& p = *this;
  const double rising = diagonal_altitude(p(i, k), p(i + 1, k), p(i + 1, k + 1), p(i, k + 1));
  const double falling = diagonal_altitude(p(i + 1, k), p(i + 1, k + 1), p(i, k + 1), p(i, k));
  if (std::abs(rising - falling) > nearly * std::max(rising, falling)) return rising > falling;
  return (i + k) % 2 == 0;
}

}  // namespace mesh
