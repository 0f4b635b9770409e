// SPDX-License-Identifier: Apache-2.0
#include "mesh/fill.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "checks.hpp"

namespace mesh {
namespace {

constexpr double kLeastArea = 1e-9;  // twice an area over a squared length, below which it is none

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A line in its plane.
class FlatLoop {
 public:
  FlatLoop(const Eigen::Ref<const Eigen::Matrix3Xd>& corners, const LoopPlane& plane)
      : count_(static_cast<int>(corners.cols())), points_(2, corners.cols()) {
    const Eigen::Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
    const Eigen::Matrix3Xd about = corners.colwise() - plane.centre;
    points_.row(0) = u.transpose() * about;
    points_.row(1) = v.transpose() * about;
  }

  // Two sides that meet elsewhere than in a common corner; {-1, -1} if there are none.
  std::array<int, 2> crossing() const {
    for (int i = 0; i < count_; ++i)
      for (int j = i + 1; j < count_; ++j)
        if (meet(i, j)) return {i, j};
    return {-1, -1};
  }

  // The triangles of least cost; empty if there are none.
  std::vector<std::array<int, 3>> triangles(const std::function<bool(int, int)>& is_taken) {
    const auto n = static_cast<std::size_t>(count_);
    cost_.assign(n * n, std::numeric_limits<double>::infinity());
    middle_.assign(n * n, -1);
    for (int i = 0; i + 1 < count_; ++i) cost_[at(i, i + 1)] = 0.0;
    for (int span = 2; span < count_; ++span)
      for (int i = 0; i + span < count_; ++i) {
        const int j = i + span;
        const bool is_side = i == 0 && j == count_ - 1;
        if (is_side || !is_taken || !is_taken(i, j)) divide(i, j);
      }
    std::vector<std::array<int, 3>> found;
    if (middle_[at(0, count_ - 1)] >= 0) collect(found);
    return found;
  }

 private:
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(j);
  }
  Eigen::Vector2d side(int i) const { return points_.col((i + 1) % count_) - points_.col(i); }
  double twice_area(int i, int j, int k) const {
    return cross(points_.col(j) - points_.col(i), points_.col(k) - points_.col(i));
  }
  bool is_area(double twice, double squared_length) const { return twice > kLeastArea * squared_length; }

  // True if point k is on side i, which ends elsewhere.
  bool is_on(int k, int i) const {
    const Eigen::Vector2d along = side(i), to = points_.col(k) - points_.col(i);
    const double squared = along.squaredNorm(), share = to.dot(along);
    return std::abs(cross(along, to)) <= kLeastArea * squared && share >= 0.0 && share <= squared;
  }

  bool meet(int i, int j) const {
    if (j == i + 1) return is_on((j + 1) % count_, i) || is_on(i, j);
    if (i == 0 && j == count_ - 1) return is_on(1, j) || is_on(j, 0);
    const int a = i, b = i + 1, c = j, d = (j + 1) % count_;
    if (is_on(c, i) || is_on(d, i) || is_on(a, j) || is_on(b, j)) return true;
    return (twice_area(a, b, c) > 0.0) != (twice_area(a, b, d) > 0.0) &&
           (twice_area(c, d, a) > 0.0) != (twice_area(c, d, b) > 0.0);
  }

  // The best triangle on the side from i to j. All triangles run like the line, so that they cover its inside
  // once.
  void divide(int i, int j) {
    const double base = (points_.col(j) - points_.col(i)).squaredNorm();
    double& least = cost_[at(i, j)];
    for (int k = i + 1; k < j; ++k) {
      const double parts = cost_[at(i, k)] + cost_[at(k, j)];
      if (!(parts < least)) continue;
      const double squares = base + (points_.col(k) - points_.col(i)).squaredNorm() +
                             (points_.col(j) - points_.col(k)).squaredNorm();
      const double area = twice_area(i, k, j);
      if (!is_area(area, squares) || !(parts + squares / area < least)) continue;
      least = parts + squares / area;
      middle_[at(i, j)] = k;
    }
  }

  void collect(std::vector<std::array<int, 3>>& found) const {
    std::vector<std::array<int, 2>> sides{{0, count_ - 1}};
    while (!sides.empty()) {
      const auto [i, j] = sides.back();
      sides.pop_back();
      if (j == i + 1) continue;
      const int k = middle_[at(i, j)];
      found.push_back({i, k, j});
      sides.push_back({k, j});
      sides.push_back({i, k});
    }
  }

  int count_;
  Eigen::Matrix2Xd points_;
  std::vector<double> cost_;  // of the corners from i to j, at their least
  std::vector<int> middle_;   // the third corner of the triangle on the side from i to j
};

std::string plane_fault(const LoopPlane& plane) {
  const double diameter = plane.diameter();
  if (plane.normal.isZero()) return "encloses no area";
  if (plane.off_plane <= kMostOffPlane * diameter) return {};
  return "is not plane: a corner is " + three_digits(plane.off_plane) +
         " m from its plane, allowed: " + three_digits(kMostOffPlane * diameter) +
         " m, a tenth of its length over pi";
}

}  // namespace

double LoopPlane::diameter() const {
  return length / std::numbers::pi;
}

double LoopPlane::roundness() const {
  return 4.0 * std::numbers::pi * area / (length * length);
}

LoopPlane loop_plane(const Eigen::Ref<const Eigen::Matrix3Xd>& corners) {
  LoopPlane plane{0.0, 0.0, corners.rowwise().mean(), Eigen::Vector3d::Zero(), 0.0};
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    const Eigen::Vector3d a = corners.col(i) - plane.centre,
                          b = corners.col((i + 1) % corners.cols()) - plane.centre;
    twice += a.cross(b);
    plane.length += (b - a).norm();
  }
  plane.area = 0.5 * twice.norm();
  if (!(2.0 * plane.area > kLeastArea * plane.length * plane.length)) return plane;
  plane.normal = twice.normalized();
  plane.off_plane = (plane.normal.transpose() * (corners.colwise() - plane.centre)).cwiseAbs().maxCoeff();
  return plane;
}

Filling fill(const Eigen::Ref<const Eigen::Matrix3Xd>& corners,
             const std::function<bool(int, int)>& is_taken) {
  if (corners.cols() < 3)
    return {{}, "has " + std::to_string(corners.cols()) + " corners, allowed: 3 or more"};
  if (corners.cols() > kMostCorners)
    return {{},
            "has " + std::to_string(corners.cols()) + " corners, allowed: at most " +
                std::to_string(kMostCorners)};
  const LoopPlane plane = loop_plane(corners);
  if (std::string fault = plane_fault(plane); !fault.empty()) return {{}, std::move(fault)};
  FlatLoop loop(corners, plane);
  const auto [first, second] = loop.crossing();
  if (first >= 0)
    return {
        {},
        "crosses itself: side " + std::to_string(first + 1) + " meets side " + std::to_string(second + 1)};
  Filling filling{loop.triangles(is_taken), {}};
  if (filling.triangles.empty())
    filling.fault = "cannot be filled without a side that the surface already has";
  return filling;
}

}  // namespace mesh
