// SPDX-License-Identifier: Apache-2.0
// Two parts of a skin: where they are closest, and whether they meet on straight paths.
#pragma once
#include "closest_points.hpp"
#include "coupling/skin.hpp"
#include "skin_parts.hpp"

namespace coupling::detail {

/// The four corners of a pair: node and triangle (1 and 3), or two edges (2 and 2).
struct Corners {
  int node[4];
  bool edges;
  /// Number of corners of the first part.
  int split() const { return edges ? 2 : 1; }
};
Corners corners_of(const SkinParts& parts, const PartPair& pair);

/// Positions of the four corners [m], as columns.
using Quad = Eigen::Matrix<double, 3, 4>;
Quad positions(const Corners& corners, const Nodes& nodes);

/// Closest points of two parts. The weights of the corners are positive in the first part, negative in the
/// second.
struct Closest {
  Eigen::Vector4d weight;
  double distance;         // [m]
  Eigen::Vector3d normal;  // unit, from the second part to the first; undefined without distance
};
Closest closest_of(bool edges, const Quad& x);

/// Largest motion of a corner of one part relative to one of the other [m].
double relative_motion(bool edges, const Quad& from, const Quad& to);

/// True if the parts come within `tolerance` [m] > 0 of each other while the corners move on straight lines,
/// by conservative advancement as in path_meets_triangle.
bool paths_meet(bool edges, const Quad& from, const Quad& to, double tolerance);

/// The pair in the numbers of a caller.
SkinPair named(const SkinParts& parts, const PartPair& pair, double gap);
/// Throws GapError for parts that met, `motion` [m] relative to each other since the last level.
[[noreturn]] void throw_gap(const SkinParts& parts, const PartPair& pair, double motion);

}  // namespace coupling::detail
