// SPDX-License-Identifier: Apache-2.0
// Triangles within a closed line: of a polygon, or of a hole in a surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace mesh {

/// Most corners of a line that is filled; time and memory grow with their cube and square.
inline constexpr int kMostCorners = 1000;
/// Largest distance of a corner from the plane of its line, over the diameter of a circle of the line's
/// length.
inline constexpr double kMostOffPlane = 0.1;

/// A closed line and its plane, by the area vector (1/2) sum x_i x x_(i+1).
struct LoopPlane {
  double length;           // [m] of the line
  double area;             // [m2] of what it encloses in the plane
  Eigen::Vector3d centre;  // [m] mean of the corners
  Eigen::Vector3d normal;  // the line runs counter-clockwise about it; 0 if it encloses no area
  double off_plane;        // [m] largest distance of a corner from the plane

  double diameter() const;   // [m] of a circle of the same length
  double roundness() const;  // the area over that of this circle, 1 at most
};

/// The plane of a closed line, `corners` [m] 3 x N with N >= 3.
LoopPlane loop_plane(const Eigen::Ref<const Eigen::Matrix3Xd>& corners);

/// What fills a closed line.
struct Filling {
  std::vector<std::array<int, 3>> triangles;  // corners from 0, which run as the line does
  std::string fault;                          // why there are none; empty if there are
};

/// Fills a closed line with N - 2 triangles of its corners: of all that cover its inside once, those with the
/// least sum of (squared sides) / area, which is the best shape. `is_taken(i, j)` forbids a side between two
/// corners that are no neighbours. The line is refused if it has more than kMostCorners corners, is further
/// from its plane than kMostOffPlane, encloses no area, or crosses or touches itself in the plane.
Filling fill(const Eigen::Ref<const Eigen::Matrix3Xd>& corners,
             const std::function<bool(int, int)>& is_taken = {});

}  // namespace mesh
