// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>

#include "coupling/impactor.hpp"
#include "coupling/skin.hpp"

namespace coupling {

/// Winding number [-] of a closed, outward oriented surface about a point off the surface: the sum of the
/// triangles' solid angles over 4 pi (K.14). To round-off it is 1 inside, 0 outside, another integer where
/// the surface overlaps itself, and a fraction for an open surface. `point` [m]. Throws std::invalid_argument
/// for a node number out of range and for coordinates that are not finite. Source: A. van Oosterom, J.
/// Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
double winding_number(const Triangles& triangles, const Nodes& nodes, const Eigen::Vector3d& point);

/// Distance [m] of a point from the closed triangle abc [m]. A triangle without area counts as its edges.
double distance_to_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c);

/// Gap between an impactor and the skin.
struct Gap {
  double distance = 0.0;  // [m] negative if they overlap
  int element = -1;       // nearest element
};

/// Smallest gap between an impactor and the skin over all elements, exact (not by quadrature). Throws
/// std::invalid_argument for a node number out of range, for coordinates of its elements or the centre that
/// are not finite, and for an impactor out of range.
Gap smallest_gap(const Triangles& triangles, const Nodes& nodes, const Impactor& impactor, const Pose& pose);

/// Checks that an impactor is outside a closed surface, with an overlap of at most 1e-9 of its size, the
/// round-off of placing it in touch (K.24). If not, throws std::invalid_argument that names impactor
/// and the element. Otherwise throws as smallest_gap does.
void require_outside(const Triangles& triangles, const Nodes& nodes, const Impactor& impactor,
                     const Pose& pose);

/// True if the path of a point comes within `tolerance` [m] > 0 of a moving triangle (K.15). All four points
/// move on straight lines at constant speed from the start to the end of the step. The columns of `start` and
/// `end` are the corners minus the point [m].
///
/// Conservative advancement: with distance d at time t, nothing can meet before t + d / (largest corner
/// motion). So the answer `false` is certain for motions up to 1e6 tolerances; it takes at most 1e6
/// iterations. Throws std::invalid_argument for coordinates that are not finite, and unless the tolerance is
/// finite and > 0.
bool path_meets_triangle(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end, double tolerance);

}  // namespace coupling
