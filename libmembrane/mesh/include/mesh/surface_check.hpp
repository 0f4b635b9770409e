// SPDX-License-Identifier: Apache-2.0
// Checks that a triangle mesh is a closed, outward-oriented, connected two-manifold, as a control volume
// needs.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace mesh {

/// An edge and the elements that share it.
struct EdgeFault {
  std::array<int, 2> nodes;   // from 0, in the direction of the first of the elements
  std::vector<int> elements;  // from 0
};

/// Faults of a surface. On a valid control volume all lists are empty, and `empty`, `inward` and
/// `flat` are false.
struct SurfaceReport {
  std::vector<int> out_of_range_elements;     // elements with a node index < 0 or >= node count
  std::vector<int> repeated_node_elements;    // elements with a node twice
  std::vector<int> non_finite_nodes;          // nodes with a coordinate that is not finite
  std::vector<EdgeFault> boundary_edges;      // edges of only one element: a hole
  std::vector<EdgeFault> non_manifold_edges;  // edges of more than two elements
  std::vector<EdgeFault> inconsistent_edges;  // edges that two elements pass in the same direction
  std::vector<int> pinched_nodes;             // nodes whose elements form more than one fan
  std::vector<int> unused_nodes;              // nodes of no element
  /// Elements of each edge-connected component; empty if there is only one.
  std::vector<std::vector<int>> components;
  bool empty = false;   // no element at all
  bool inward = false;  // closed, but the enclosed volume is <= 0
  bool flat = false;    // closed, but the enclosed volume is 0 to rounding
  /// [m3] enclosed volume; NaN unless the surface is closed and consistently oriented, as the volume of an
  /// open one depends on the origin.
  double volume = std::numeric_limits<double>::quiet_NaN();

  /// True if `volume` was computed.
  bool has_volume() const { return std::isfinite(volume); }

  /// True if the surface is closed, manifold, connected, consistently and outward oriented, without unused
  /// nodes.
  bool ok() const;

  /// Findings in prose, one per line, with the first few edges, elements and nodes of each; empty if ok().
  /// Numbers count from 0. With `lines` (Mesh::line of a mesh that was read), elements are named by their
  /// lines, and nodes count from 1 in the order of the file.
  std::string describe(const std::vector<int>& lines = {}) const;

  /// An element of the first finding; 0 if a finding names none.
  int first_element() const;
};

/// Checks a surface in O(M log M). `nodes` [m] 3 x N, `elements` 3 x M. If an index is out of range, only
/// index faults are reported, because the topology is then undefined. Never throws for a faulty surface.
SurfaceReport check_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                                   const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Throws std::invalid_argument with describe() unless the surface is ok().
void require_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                            const Eigen::Ref<const Eigen::Matrix3Xi>& elements);
/// The same for a report.
void require_closed_surface(const SurfaceReport& report);

}  // namespace mesh
