// SPDX-License-Identifier: Apache-2.0
#include "contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "coupling/side.hpp"

namespace coupling::detail {

namespace {

// Two doubles in one register (a vector of GCC and Clang): the pass over the nodes is all that a step without
// contact costs.
using Pair [[gnu::vector_size(16)]] = double;

Pair load(const double* p) {
  Pair v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

void store(Pair v, double* p) {
  std::memcpy(p, &v, sizeof v);
}

// Largest squared differences and, to carry a coordinate that is not finite (a maximum drops it), their sums.
struct Motion {
  Pair largest{}, sum{};
  void add(Pair difference) {
    const Pair squared = difference * difference;
    largest = squared > largest ? squared : largest;
    sum += squared;
  }
  bool finite() const { return std::isfinite(sum[0] + sum[1]); }
};

}  // namespace

double copy_and_measure_motion(const Nodes& from, const Eigen::Matrix3Xd& old, Eigen::Matrix3Xd& to) {
  Motion even, odd, z;
  const Eigen::Index count = from.cols(), stride = from.outerStride();
  for (Eigen::Index a = 0; a < count; a += 2) {
    // Two nodes at a time; the last of an odd number is paired with itself.
    const Eigen::Index b = std::min(a + 1, count - 1);
    const double *xa = from.data() + a * stride, *xb = from.data() + b * stride;
    const double *oa = old.data() + 3 * a, *ob = old.data() + 3 * b;
    double *na = to.data() + 3 * a, *nb = to.data() + 3 * b;
    const Pair xya = load(xa), xyb = load(xb);
    even.add(xya - load(oa));
    odd.add(xyb - load(ob));
    z.add(Pair{xa[2], xb[2]} - Pair{oa[2], ob[2]});
    store(xya, na);
    store(xyb, nb);
    na[2] = xa[2], nb[2] = xb[2];
  }
  if (!(even.finite() && odd.finite() && z.finite())) return std::numeric_limits<double>::quiet_NaN();
  // Components apart: at most sqrt(3) above the largest length, and a bound all the same.
  return std::sqrt(std::max(even.largest[0], odd.largest[0]) + std::max(even.largest[1], odd.largest[1]) +
                   std::max(z.largest[0], z.largest[1]));
}

namespace {

// Nine times the squared distances point to centroid and centroid to farthest corner: neither root nor
// division.
struct Extent {
  double distance2, reach2;  // [m2] times 9
};

Extent extent(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& nodes, int element,
              const Eigen::Vector3d& point) {
  const auto corner = triangles.col(element);
  const Eigen::Vector3d a = nodes.col(corner[0]), first = nodes.col(corner[1]) - a,
                        second = nodes.col(corner[2]) - a;
  const double f2 = first.squaredNorm(), fs = 2.0 * first.dot(second), s2 = second.squaredNorm();
  const double reach2 = std::max(f2 + s2 + fs, std::max(4.0 * f2 + s2 - 2.0 * fs, 4.0 * s2 + f2 - 2.0 * fs));
  return {(3.0 * (a - point) + first + second).squaredNorm(), reach2};
}

constexpr double kRounding = 1.0 + 1e-12;  // keeps an element that only round-off puts out of reach

// From a sphere of that radius about the point to the element's bounding circle, at most [m].
double gap_of(const Extent& e, double radius) {
  return (std::sqrt(e.distance2) - kRounding * std::sqrt(e.reach2)) / (3.0 * kRounding) - radius;
}

}  // namespace

double gap_bound(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& nodes, int element,
                 const Eigen::Vector3d& point, double radius) {
  return gap_of(extent(triangles, nodes, element, point), radius);
}

void search_near_elements(const Eigen::Matrix3Xi& triangles, double radius, ContactState& state) {
  const int count = static_cast<int>(triangles.cols());
  const double listed = 3.0 * radius;
  double nearest2 = std::numeric_limits<double>::infinity(), longest2 = 0.0;
  state.near.clear();
  for (int e = 0; e < count; ++e) {
    const Extent x = extent(triangles, state.nodes, e, state.centre);
    nearest2 = std::min(nearest2, x.distance2);
    longest2 = std::max(longest2, x.reach2);
    // Cheap, and misses none: g < d + R gives g^2 < (d + R)^2 <= 2 (d^2 + R^2).
    if (!(x.distance2 < kRounding * 2.0 * (9.0 * listed * listed + x.reach2))) continue;
    const double gap = gap_of(x, radius);
    if (gap < listed - radius) state.near.push_back({e, gap});
  }
  const double gap = (std::sqrt(nearest2) - std::sqrt(longest2)) / 3.0 - radius;
  state.reach = std::max(listed - radius, gap);
  state.travelled = 0.0;
  state.gap = 0.0;
  ++state.searches;
}

double reach_of_gap(const Eigen::Matrix3Xi& triangles, double radius, const ContactState& state) {
  double reach = state.reach;
  const auto look_at = [&](int e) {
    const auto corner = triangles.col(e);
    const double distance = distance_to_triangle(state.centre, state.nodes.col(corner[0]),
                                                 state.nodes.col(corner[1]), state.nodes.col(corner[2]));
    reach = std::min(reach, state.travelled + distance - radius);
  };
  // That of the least slack first: its distance lets most others pass.
  const auto first = std::min_element(state.near.begin(), state.near.end(),
                                      [](const auto& a, const auto& b) { return a.slack < b.slack; });
  if (first == state.near.end()) return reach;
  look_at(first->element);
  for (const auto& [e, slack] : state.near)
    if (slack < reach && e != first->element) look_at(e);
  return reach;
}

void sweep_centre_path(const Eigen::Matrix3Xi& triangles, double radius, const Eigen::Vector3d& next_centre,
                       ContactState& state) {
  ++state.sweeps;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    Eigen::Matrix3d start, end;
    for (int i = 0; i < 3; ++i) {
      start.col(i) = state.nodes.col(triangles(i, e)) - state.centre;
      end.col(i) = state.next_nodes.col(triangles(i, e)) - next_centre;
    }
    // A centre this close to the skin is far beyond the penetration allowed, whichever side it ends on.
    if (path_meets_triangle(start, end, 0.01 * radius))
      throw ContactError("contact: the sphere's centre crossed the skin at element " + std::to_string(e) +
                         " within one step");
  }
}

}  // namespace coupling::detail
