// SPDX-License-Identifier: Apache-2.0
// Is a triangle mesh the closed, outward-oriented, connected two-manifold that a control volume needs?
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace membrane {

/// An edge (node pair as the first of the elements runs it) and the elements that share it.
struct EdgeFault {
  std::array<int, 2> nodes;   // from 0
  std::vector<int> elements;  // from 0
};

/// Everything found wrong with a surface; all lists empty and inward false on a valid control volume.
struct SurfaceReport {
  std::vector<int> out_of_range_elements;     // elements naming a node index < 0 or >= node count
  std::vector<int> repeated_node_elements;    // elements naming one node twice
  std::vector<int> non_finite_nodes;          // nodes with a coordinate that is not finite
  std::vector<EdgeFault> boundary_edges;      // in one element only: a hole
  std::vector<EdgeFault> non_manifold_edges;  // in more than two elements
  std::vector<EdgeFault> inconsistent_edges;  // two elements run along the edge the same way
  std::vector<int> pinched_nodes;             // nodes whose elements form more than one fan
  std::vector<int> unused_nodes;              // nodes of no element
  std::vector<std::vector<int>> components;   // elements of each edge-connected component, if more than one
  bool empty = false;                         // no element at all
  bool inward = false;                        // closed, but the enclosed volume is negative or zero
  double volume = 0.0;  // [m3] enclosed volume; computed only if closed and consistently oriented

  /// True if the surface is closed, manifold, connected, consistently and outward oriented, without unused
  /// nodes.
  bool ok() const;

  /// Findings in prose, one per line, naming the first few offending edges, elements and nodes; empty if
  /// ok(). Numbers count from 0; with the `line` of a mesh that was read, elements are named by their lines
  /// and nodes from 1, in the order of the file.
  std::string describe(const std::vector<int>& lines = {}) const;

  /// An element of the first finding; 0 where a finding names none.
  int first_element() const;
};

/// Checks a surface; O(M log M). `nodes` [m] 3 x N, `elements` 3 x M. When an index is out of range only
/// index faults are reported, since the topology is undefined then. Never throws for a faulty surface.
SurfaceReport check_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                                   const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// Throws std::invalid_argument with describe() unless the surface is ok().
void require_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                            const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

}  // namespace membrane
