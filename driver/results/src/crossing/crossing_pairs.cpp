// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "crossing/exact.hpp"
#include "results/crossing.hpp"

namespace driver {
namespace {

using exact::Triangle;

// Six products of three differences of doubles, summed, are off by less than 9.1 roundings (2^-53) of the
// sum of their magnitudes.
int sign_if_sure(double value, double magnitude) {
  constexpr double share = 9.1 * 0x1p-53, underflow = 1e-300;
  return std::abs(value) > share * magnitude + underflow ? (value > 0.0 ? 1 : -1) : 0;
}

/// A triangle with its plane.
struct Face {
  Triangle corner;
  std::array<int, 3> node;
  Eigen::Vector3d normal, magnitude;  // of the cross product, and of the terms that it sums
};

Face face_of(const NodesView& nodes, const Eigen::Vector3i& triangle) {
  const Triangle t{nodes.col(triangle(0)), nodes.col(triangle(1)), nodes.col(triangle(2))};
  const Eigen::Vector3d b = t[1] - t[0], c = t[2] - t[0];
  const Eigen::Vector3d d = b.cwiseAbs(), e = c.cwiseAbs();
  return {t,
          {triangle(0), triangle(1), triangle(2)},
          b.cross(c),
          {d.y() * e.z() + d.z() * e.y(), d.z() * e.x() + d.x() * e.z(), d.x() * e.y() + d.y() * e.x()}};
}

bool has_area(const Face& face) {
  for (int k = 0; k < 3; ++k)
    if (sign_if_sure(face.normal(k), face.magnitude(k)) != 0) return true;
  return !exact::is_degenerate(face.corner);
}

// Side of the plane of t on which p is; 0: on it, or not certain by rounding.
int plane_side(const Face& t, const Eigen::Vector3d& p) {
  const Eigen::Vector3d from = p - t.corner[0];
  return sign_if_sure(t.normal.dot(from), t.magnitude.dot(from.cwiseAbs()));
}

int line_side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p, Eigen::Index x,
              Eigen::Index y) {
  const double left = (b(x) - a(x)) * (p(y) - a(y)), right = (b(y) - a(y)) * (p(x) - a(x));
  return sign_if_sure(left - right, std::abs(left) + std::abs(right));
}

bool has_node(const Face& t, int node) {
  return t.node[0] == node || t.node[1] == node || t.node[2] == node;
}

// True if all corners of u that are not corners of t are on one side of the plane of t.
bool one_side(const Face& t, const Face& u) {
  int side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (has_node(t, u.node[k])) continue;
    const int own = plane_side(t, u.corner[k]);
    if (own == 0 || own == -side) return false;
    side = own;
  }
  return true;
}

// True if, in a projection onto a coordinate plane, u is beyond the line of an edge of t. Nodes of u may be
// ends of that edge.
bool beyond_an_edge(const Face& t, const Face& u) {
  Eigen::Index axis;
  t.normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index x = (axis + 1) % 3, y = (axis + 2) % 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const int inside = line_side(t.corner[k], t.corner[next], t.corner[(k + 2) % 3], x, y);
    bool beyond = inside != 0;
    for (std::size_t m = 0; beyond && m < 3; ++m)
      beyond = u.node[m] == t.node[k] || u.node[m] == t.node[next] ||
               line_side(t.corner[k], t.corner[next], u.corner[m], x, y) == -inside;
    if (beyond) return true;
  }
  return false;
}

// Corners of t: first those that are corners of u.
Triangle shared_first(const Face& t, const Face& u) {
  Triangle order;
  std::size_t count = 0;
  for (const bool shared : {true, false})
    for (std::size_t k = 0; k < 3; ++k)
      if (has_node(u, t.node[k]) == shared) order[count++] = t.corner[k];
  return order;
}

bool cross(const Face& t, const Face& u) {
  const int shared = has_node(u, t.node[0]) + has_node(u, t.node[1]) + has_node(u, t.node[2]);
  if (shared == 3) return true;
  if (one_side(t, u) || one_side(u, t) || beyond_an_edge(t, u) || beyond_an_edge(u, t)) return false;
  const Triangle a = shared_first(t, u), b = shared_first(u, t);
  if (shared == 2) return exact::overlap(a[0], a[1], a[2], b[2]);
  if (shared == 1) return exact::meet(a, b[1], b[2]) || exact::meet(b, a[1], a[2]);
  return exact::meet(a, b);
}

/// Box of a face along three axes, the longest and second longest of all boxes first.
struct Box {
  std::array<double, 3> low, high;
  std::size_t face;
};

std::vector<Box> boxes_of(const std::vector<Face>& faces) {
  std::vector<Box> boxes(faces.size());
  Eigen::Array3d least = faces[0].corner[0], largest = least;
  for (const Face& face : faces)
    for (const Eigen::Vector3d& p : face.corner) {
      least = least.min(p.array());
      largest = largest.max(p.array());
    }
  std::array<Eigen::Index, 3> axes{0, 1, 2};
  std::ranges::sort(axes, std::greater{}, [&](Eigen::Index k) { return largest(k) - least(k); });
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i].corner;
    boxes[i].face = i;
    for (std::size_t k = 0; k < 3; ++k)
      std::tie(boxes[i].low[k], boxes[i].high[k]) = std::minmax({a(axes[k]), b(axes[k]), c(axes[k])});
  }
  return boxes;
}

/// Boxes in strips across the second axis, as wide as a box on average. A box is in every strip that it
/// touches. The boxes of a strip are sorted by their begin along the first axis.
class Strips {
 public:
  /// Precondition: there is a box.
  explicit Strips(std::vector<Box> boxes) : low_(boxes[0].low[1]) {
    double high = low_, sum = 0.0;
    for (const Box& box : boxes) {
      low_ = std::min(low_, box.low[1]);
      high = std::max(high, box.high[1]);
      sum += box.high[1] - box.low[1];
    }
    const double most = static_cast<double>(boxes.size());
    count_ = sum > 0.0 ? std::clamp(std::floor((high - low_) / sum * most), 1.0, most) : 1.0;
    per_metre_ = high > low_ ? count_ / (high - low_) : 0.0;
    std::ranges::sort(boxes, {}, [](const Box& box) { return std::pair(box.low[0], box.face); });
    boxes_.resize(static_cast<std::size_t>(count_));
    for (const Box& box : boxes)
      for (std::size_t strip = place(box.low[1]); strip <= place(box.high[1]); ++strip)
        boxes_[strip].push_back(box);
  }

  /// Calls `visit` once for each two faces whose boxes overlap, in the strip where the later one begins.
  template <class Visit>
  void each_pair(const Visit& visit) const {
    for (std::size_t strip = 0; strip < boxes_.size(); ++strip)
      for (auto a = boxes_[strip].begin(); a != boxes_[strip].end(); ++a)
        for (auto b = a + 1; b != boxes_[strip].end() && b->low[0] <= a->high[0]; ++b) {
          const bool overlap = a->low[1] <= b->high[1] && b->low[1] <= a->high[1] &&
                               a->low[2] <= b->high[2] && b->low[2] <= a->high[2];
          if (overlap && place(std::max(a->low[1], b->low[1])) == strip) visit(a->face, b->face);
        }
  }

 private:
  std::size_t place(double y) const {
    return static_cast<std::size_t>(std::clamp((y - low_) * per_metre_, 0.0, count_ - 1.0));
  }
  double low_, count_ = 1.0, per_metre_ = 0.0;  // of the strips
  std::vector<std::vector<Box>> boxes_;         // of each strip
};

}  // namespace

std::vector<std::pair<int, int>> crossing_pairs(const NodesView& nodes, const TrianglesView& triangles) {
  std::vector<Face> faces;
  std::vector<int> number;
  faces.reserve(static_cast<std::size_t>(triangles.cols()));
  for (int e = 0; e < triangles.cols(); ++e) {
    const Face face = face_of(nodes, triangles.col(e));
    if (!has_area(face)) continue;
    faces.push_back(face);
    number.push_back(e);
  }
  std::vector<std::pair<int, int>> pairs;
  if (faces.empty()) return pairs;
  Strips(boxes_of(faces)).each_pair([&](std::size_t i, std::size_t j) {
    if (cross(faces[i], faces[j])) pairs.emplace_back(std::minmax(number[i], number[j]));
  });
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace driver
