// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "results/crossing.hpp"
#include "results/winding.hpp"

namespace driver {
namespace {

using Point = Eigen::Vector2d;

/// A place where a line meets a triangle.
struct Hit {
  std::size_t line;
  double height;  // [m] along the line
  int step;       // step of the winding number
};

/// Lines across the shortest extent of the surface, two in each cell of a grid of almost square cells.
class LineGrid {
 public:
  LineGrid(const NodesView& nodes, int lines) {
    const Eigen::Vector3d low = nodes.rowwise().minCoeff(), size = nodes.rowwise().maxCoeff() - low;
    size.minCoeff(&along_);
    across_ = {(along_ + 1) % 3, (along_ + 2) % 3};
    low_ = {low(across_[0]), low(across_[1])};
    const Point extent{size(across_[0]), size(across_[1])};
    const double side = std::sqrt(2.0 * extent.prod() / lines);
    for (int k = 0; k < 2; ++k)
      count_[static_cast<std::size_t>(k)] = side > 0.0 ? static_cast<int>(std::ceil(extent(k) / side)) : 0;
    cell_ = side > 0.0 ? Point(extent.x() / count_[0], extent.y() / count_[1]) : Point::Zero();
    std::mt19937_64 random;  // the same lines in each check
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int i = 0; i < count_[0]; ++i)
      for (int j = 0; j < count_[1]; ++j)
        for (int k = 0; k < 2; ++k) {
          const double x = low_.x() + (i + share()) * cell_.x(), y = low_.y() + (j + share()) * cell_.y();
          points_.emplace_back(x, y);
        }
  }

  double cell_area() const { return cell_.prod(); }  // [m2]
  std::size_t cells() const { return points_.size() / 2; }

  /// Adds the points where lines meet the triangle with these corners.
  void add_hits(const std::array<Eigen::Vector3d, 3>& corner, std::vector<Hit>& hits) const {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = {corner[k](across_[0]), corner[k](across_[1])};
    const Point low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto [i0, i1] = cells_between(low, high, 0);
    const auto [j0, j1] = cells_between(low, high, 1);
    for (int i = i0; i <= i1; ++i)
      for (std::size_t line = 2 * index(i, j0); line < 2 * index(i, j1) + 2; ++line) {
        const Point& q = points_[line];
        if (q.x() < low.x() || q.x() > high.x() || q.y() < low.y() || q.y() > high.y()) continue;
        if (const int winding = winding_about(p, q)) hits.push_back({line, height(corner, p, q), -winding});
      }
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j);
  }
  // One cell more on each side: rounding may move a line just outside its cell.
  std::pair<int, int> cells_between(const Point& low, const Point& high, int k) const {
    const auto place = [&](double x, double margin) {
      const double cell = std::floor((x - low_(k)) / cell_(k) + margin);
      return static_cast<int>(std::clamp(cell, 0.0, count_[static_cast<std::size_t>(k)] - 1.0));
    };
    return {place(low(k), -1e-9), place(high(k), 1e-9)};
  }
  double height(const std::array<Eigen::Vector3d, 3>& corner, const std::array<Point, 3>& p,
                const Point& q) const {
    const auto twice = [](const Point& a, const Point& b, const Point& c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    const double u = twice(p[1], p[2], q), v = twice(p[2], p[0], q), w = twice(p[0], p[1], q);
    const double a = corner[0](along_), b = corner[1](along_), c = corner[2](along_);
    const double total = u + v + w;
    if (total == 0.0) return a;  // edge-on, to rounding
    return std::clamp((u * a + v * b + w * c) / total, std::min({a, b, c}), std::max({a, b, c}));
  }

  int along_ = 0;
  std::array<int, 2> across_{}, count_{};
  Point low_, cell_;
  std::vector<Point> points_;  // two for each cell
};

/// Lengths of a line [m]: where w > 1, times w - 1; where w < 0, times -w.
struct Lengths {
  double twice = 0.0, inside_out = 0.0;
};

std::vector<Lengths> lengths_of(std::vector<Hit>& hits, std::size_t lines) {
  std::ranges::sort(hits, [](const Hit& a, const Hit& b) {
    return a.line != b.line ? a.line < b.line : a.height < b.height;
  });
  std::vector<Lengths> lengths(lines);
  int winding = 0;
  for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
    winding += hits[i].step;
    if (hits[i + 1].line != hits[i].line) {
      winding = 0;
      continue;
    }
    const double length = hits[i + 1].height - hits[i].height;
    lengths[hits[i].line].twice += std::max(winding - 1, 0) * length;
    lengths[hits[i].line].inside_out += std::max(-winding, 0) * length;
  }
  return lengths;
}

}  // namespace

LayerVolumes layer_volumes(const NodesView& nodes, const TrianglesView& triangles, int lines) {
  const LineGrid grid(nodes, lines);
  std::vector<Hit> hits;
  for (int e = 0; e < triangles.cols(); ++e)
    grid.add_hits({nodes.col(triangles(0, e)), nodes.col(triangles(1, e)), nodes.col(triangles(2, e))}, hits);
  const std::vector<Lengths> length = lengths_of(hits, 2 * grid.cells());
  LayerVolumes volumes;
  const auto sum = [&](double Lengths::*part, VolumeEstimate& volume) {
    double variance = 0.0;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
      const double a = length[2 * c].*part, b = length[2 * c + 1].*part;
      volume.value += 0.5 * (a + b) * grid.cell_area();
      const double half = 0.5 * (a - b) * grid.cell_area();
      variance += half * half;
    }
    volume.standard_error = std::sqrt(variance);
  };
  sum(&Lengths::twice, volumes.counted_twice);
  sum(&Lengths::inside_out, volumes.inside_out);
  return volumes;
}

}  // namespace driver
