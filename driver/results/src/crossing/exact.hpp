// SPDX-License-Identifier: Apache-2.0
// Exact predicates of triangles on the coordinates as given. CGAL stays in exact.cpp.
#pragma once

#include <Eigen/Core>
#include <array>

namespace driver::exact {

using Triangle = std::array<Eigen::Vector3d, 3>;  // corners

/// True if the corners lie on a line.
bool is_degenerate(const Triangle& t);

/// True if two closed triangles have a point in common. Precondition: neither is degenerate.
bool meet(const Triangle& t, const Triangle& u);

/// True if the closed segment p q has a point in common with the closed triangle. Precondition: the triangle
/// is not degenerate.
bool meet(const Triangle& t, const Eigen::Vector3d& p, const Eigen::Vector3d& q);

/// True if the triangles a b c and b a d lie on each other: in one plane, on one side of their common edge a
/// b. Precondition: neither is degenerate.
bool overlap(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d);

/// Side of the line from a to b on which p is: 1 left, -1 right, 0 on it.
int side(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p);

}  // namespace driver::exact
