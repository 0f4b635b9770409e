// SPDX-License-Identifier: Apache-2.0
// Triangle mesh of an airbag skin with named panels, and the plain geometry that is asked of it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace membrane {

/// Triangulated surface. Elements are wound counter-clockwise seen from outside (outward orientation).
struct Mesh {
  Eigen::Matrix3Xd nodes;                // [m] 3 x N, node positions
  Eigen::Matrix3Xi elements;             // 3 x M, node indices from 0
  std::vector<int> panel;                // M, index into panel_names
  std::vector<std::string> panel_names;  // one name per panel, unique
  std::vector<int> line;                 // M, line of its file from 1, by which faults are named; else empty

  /// N
  int node_count() const { return static_cast<int>(nodes.cols()); }
  /// M
  int element_count() const { return static_cast<int>(elements.cols()); }
};

/// Index of the panel called `name`. Throws std::invalid_argument that lists the existing panels if there is
/// none.
int panel_index(const Mesh& mesh, std::string_view name);

/// Elements of a panel, ascending. Throws std::invalid_argument for an unknown panel.
std::vector<int> panel_elements(const Mesh& mesh, std::string_view name);

/// Nodes used by the elements of a panel, ascending, each once. Throws std::invalid_argument for an unknown
/// panel.
std::vector<int> panel_nodes(const Mesh& mesh, std::string_view name);

/// Node nearest to `point` [m]; of equally near ones the lowest index. Throws std::invalid_argument on an
/// empty mesh.
int nearest_node(const Mesh& mesh, const Eigen::Vector3d& point);

/// Areas of the elements [m2], shape M.
Eigen::VectorXd element_areas(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                              const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Areas of the panels [m2], in the order of panel_names.
Eigen::VectorXd panel_areas(const Mesh& mesh);

/// Enclosed volume [m3], V = (1/6) sum x_a . (x_b x x_c) (M.5), summed about the first node's position so
/// that it does not depend on the origin to round-off. Positive for outward orientation; meaningful on closed
/// surfaces only.
double enclosed_volume(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                       const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// False if the area of a triangle of sides `ab` and `ac` [m] is rounding noise of its corners, at most 1e-14
/// of the longer one's square, or beyond what a double's square holds.
bool has_area(const Eigen::Vector3d& ab, const Eigen::Vector3d& ac);

/// Smallest and mean shape figures of a set of elements.
struct ElementQuality {
  double min_angle;      // [rad] smallest interior angle
  double min_altitude;   // [m] smallest altitude: governs the critical time step
  double mean_altitude;  // [m] mean over the elements of each one's smallest altitude
  double max_aspect;     // [-] longest edge over smallest altitude (equilateral: 2/sqrt(3))
  double min_area;       // [m2] of the smallest element
  double max_area;       // [m2] of the largest
};

/// Element-quality report. Precondition: at least one element, none of zero area or beyond double range (else
/// std::invalid_argument).
ElementQuality element_quality(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                               const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Nodes flattened along x: x -> factor * x, so that whatever lies in x = 0 (the attachment) stays. The
/// design shape stays the stress-free reference; the result is an initial shape. Throws std::invalid_argument
/// unless 0 < factor <= 1.
Eigen::Matrix3Xd flatten(const Mesh& mesh, double factor);

}  // namespace membrane
