// SPDX-License-Identifier: Apache-2.0
// Triangle mesh of an airbag skin with named panels, and its plain geometry.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesh {

/// Nodes that a file names together, such as the rim of a vent.
struct NodeSet {
  std::string name;        // blanks are _
  std::vector<int> nodes;  // from 0, ascending, each once
};

/// Triangulated surface. Elements are wound counter-clockwise seen from outside (outward orientation).
struct Mesh {
  Eigen::Matrix3Xd nodes;  // [m] 3 x N, node positions
  /// [m] 3 x N, start positions of a deck with a separate stress-free shape, which is then in `nodes`.
  std::optional<Eigen::Matrix3Xd> start;
  Eigen::Matrix3Xi elements;             // 3 x M, node indices from 0
  std::vector<int> panel;                // M, index into panel_names
  std::vector<std::string> panel_names;  // one name per panel, unique
  /// [M] line of each element in its file, from 1, for messages; empty if the mesh was not read.
  std::vector<int> line;
  std::vector<NodeSet> node_sets;  // of a deck, and of Gmsh's physical curves
  int split_quads = 0;             // number of quads in the file, each split in two elements
  int split_polygons = 0;          // number of polygons with more corners in the file, split in elements
  int most_corners = 3;            // of the elements, quads and polygons of the file
  /// of a deck: keywords of elements other than shells, with their number.
  std::vector<std::string> other_elements;
  std::vector<std::filesystem::path> included;  // of a deck: included files
  std::vector<std::string> skipped;  // other content that is not read: keywords of a deck, arrays of VTK
  /// of a deck: content that is not read but changes the bag's shapes, its fabric or its initial stress.
  std::vector<std::string> neglected;

  /// N
  int node_count() const { return static_cast<int>(nodes.cols()); }
  /// M
  int element_count() const { return static_cast<int>(elements.cols()); }
  /// Positions of the nodes at the start.
  const Eigen::Matrix3Xd& start_nodes() const { return start ? *start : nodes; }
};

/// Multiplies all lengths.
void scale(Mesh& mesh, double factor);

/// The mesh in which node i is the old node order[i]. Elements, panels and lines keep their order.
/// Precondition: `order` has each node once.
Mesh renumbered(const Mesh& mesh, const std::vector<int>& order);

/// Index of the panel `name`. Throws std::invalid_argument, listing the panels, if there is none.
int panel_index(const Mesh& mesh, std::string_view name);

/// Elements of a panel, ascending. Throws std::invalid_argument for an unknown panel.
std::vector<int> panel_elements(const Mesh& mesh, std::string_view name);

/// The elements of these panels and their nodes, in the order of `mesh`; panels in the order of their first
/// element. Throws std::invalid_argument for an unknown panel, and for a number of a node or panel out of
/// range.
Mesh only_panels(const Mesh& mesh, const std::vector<std::string>& names);

/// Nodes used by the elements of a panel, ascending, each once. Throws std::invalid_argument for an unknown
/// panel, and for a number of a node or panel out of range.
std::vector<int> panel_nodes(const Mesh& mesh, std::string_view name);

/// Node nearest to `point` [m]; the lowest index if several are equally near. Throws std::invalid_argument
/// for an empty mesh or a point that is not finite.
int nearest_node(const Mesh& mesh, const Eigen::Vector3d& point);

/// Areas of the elements [m2], shape M. This and the functions below throw std::invalid_argument for a node
/// number or a panel index out of range.
Eigen::VectorXd element_areas(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                              const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Areas of the panels [m2], in the order of panel_names.
Eigen::VectorXd panel_areas(const Mesh& mesh);

/// Enclosed volume [m3], V = (1/6) sum x_a . (x_b x x_c) (M.5). It is summed about the first node, so that it
/// is independent of the origin to round-off. Positive for outward orientation; meaningful for closed
/// surfaces only.
double enclosed_volume(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                       const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Shape figures of a set of elements.
struct ElementQuality {
  double min_angle;      // [rad] smallest interior angle
  double min_altitude;   // [m] smallest altitude, which governs the critical time step
  double mean_altitude;  // [m] smallest altitude of each element, mean over the elements
  double max_aspect;     // [-] longest edge over smallest altitude (equilateral: 2/sqrt(3))
  double min_area;       // [m2] area of the smallest element
  double max_area;       // [m2] area of the largest element
};

/// Shape figures of a mesh. Throws std::invalid_argument for no element, or one whose area is zero or not
/// finite.
ElementQuality element_quality(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                               const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Nodes flattened along x: x -> factor * x, so that nodes in x = 0 (the attachment) stay. The result is an
/// initial shape; the design shape stays the stress-free reference. Throws std::invalid_argument unless
/// 0 < factor <= 1.
Eigen::Matrix3Xd flatten(const Mesh& mesh, double factor);

}  // namespace mesh
