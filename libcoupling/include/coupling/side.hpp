// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>

#include "coupling/skin.hpp"

namespace coupling {

// (K.14) Winding number of a closed, outward oriented surface about a point off it: the sum of the triangles'
// solid angles over 4 pi; 1 inside, 0 outside, other integers where the surface overlaps itself. To round-off
// an integer for a closed surface; a fraction for an open one. A. van Oosterom, J. Strackee, IEEE Trans.
// Biomed. Eng. 30 (1983) 125-126.
double winding_number(const Triangles& triangles, const Nodes& nodes, const Eigen::Vector3d& point);

// Distance [m] of a point from the closed triangle abc; a triangle without area counts as its edges.
double distance_to_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c);

// How near a sphere is to the skin.
struct Gap {
  double distance = 0.0;  // [m] sphere to skin, negative when they overlap
  int element = -1;       // the nearest
};

// The smallest gap between a sphere and the skin, exactly, over all elements (no quadrature).
Gap smallest_gap(const Triangles& triangles, const Nodes& nodes, const Eigen::Vector3d& centre,
                 double radius);

// (K.24) Checks that a sphere lies outside a closed surface and does not overlap it by more than 1e-9 radius
// (the round-off of placing it in touch). Throws std::invalid_argument naming pendulum.impactor and the
// element.
void require_outside(const Triangles& triangles, const Nodes& nodes, const Eigen::Vector3d& centre,
                     double radius);

// (K.15) Does the path of a point come within `tolerance` [m] > 0 of a moving triangle? All four move on
// straight lines at constant speed from the start to the end of the step; the columns of start and end are
// the corners minus the point [m]. Conservative advancement: from distance d at time t nothing can meet
// before t + d / (largest corner motion), so the answer `false` is certain; it takes at most motion/tolerance
// rounds.
bool path_meets_triangle(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end, double tolerance);

}  // namespace coupling
