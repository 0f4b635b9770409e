// SPDX-License-Identifier: Apache-2.0
#include "closest_points.hpp"

#include <algorithm>
#include <limits>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

TrianglePoint on_edge(double t, int from, int to) {
  TrianglePoint point{};
  point.weight[from] = 1.0 - t;
  point.weight[to] = t;
  return point;
}

// Of a triangle that has no inside to round-off.
TrianglePoint closest_on_edges(const Vector3d& p, const Vector3d (&corner)[3]) {
  TrianglePoint best{};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vector3d &a = corner[k], &b = corner[(k + 1) % 3];
    const double t = closest_on_segment(p, a, b);
    const double squared = (a + t * (b - a) - p).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    best = on_edge(t, k, (k + 1) % 3);
  }
  return best;
}

}  // namespace

TrianglePoint closest_on_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                                  const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {{1.0, 0.0, 0.0}};
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {{0.0, 1.0, 0.0}};
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {{0.0, 0.0, 1.0}};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return on_edge(d1 / (d1 - d3), 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return on_edge(d2 / (d2 - d6), 0, 2);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return on_edge((d4 - d3) / ((d4 - d3) + (d5 - d6)), 1, 2);
  const double sum = va + vb + vc;
  if (!(va > 0.0 && vb > 0.0 && vc > 0.0)) return closest_on_edges(p, {a, b, c});
  const double v = vb / sum, w = vc / sum;
  return {{1.0 - v - w, v, w}};
}

double closest_on_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d edge = b - a;
  const double squared = edge.squaredNorm();
  return squared > 0.0 ? std::clamp(edge.dot(p - a) / squared, 0.0, 1.0) : 0.0;
}

SegmentPoints closest_of_segments(const Vector3d& a, const Vector3d& u, const Vector3d& b,
                                  const Vector3d& v) {
  const Vector3d r = a - b;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 1e-14 * uu * vv ? std::clamp((uv * vr - ur * vv) / determinant, 0.0, 1.0) : 0.5;
  double t = vv > 0.0 ? (uv * s + vr) / vv : 0.0;
  if (t < 0.0 || t > 1.0 || !(vv > 0.0)) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0.0 ? std::clamp((uv * t - ur) / uu, 0.0, 1.0) : 0.0;
  }
  return {s, t};
}

}  // namespace coupling::detail
