// SPDX-License-Identifier: Apache-2.0
// Where a triangulated skin passes through itself, and which volume is therefore counted wrongly (M.35).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace driver {

/// Positions of nodes, 3 x N [m]; columns may lie apart.
using NodesView = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;
/// Nodes of triangles from 0, 3 x M.
using TrianglesView = Eigen::Ref<const Eigen::Matrix3Xi>;

/// Pairs of triangles that meet elsewhere than in the nodes and edges that they share, exactly on the
/// coordinates as given.
/// - Triangles that share no node cross if they have a point in common. Contact and layers on each other in
///   one plane count, too.
/// - Triangles that share a node cross if they meet elsewhere.
/// - Triangles that share an edge cross if they lie in one plane on one side of it.
///
/// Triangles without area are left out. Preconditions: nodes are finite, and each triangle has three
/// different ones. The cost grows as M^1.5 for triangles of one size.
std::vector<std::pair<int, int>> crossing_pairs(const NodesView& nodes, const TrianglesView& triangles);

/// A volume and its standard error, both [m3].
struct VolumeEstimate {
  double value = 0.0, standard_error = 0.0;
};

/// Volumes of a closed, consistently oriented surface by its winding number w. The signed volume (M.5) is
/// that of the points with w > 0, plus counted_twice, less inside_out.
struct LayerVolumes {
  VolumeEstimate counted_twice{};  // integral of max(w - 1, 0)
  VolumeEstimate inside_out{};     // integral of max(-w, 0)
};

/// Integrates along at least `lines` parallel lines, across the shortest extent of the surface. Each cell of
/// a grid has two random lines, always the same ones; their difference gives the standard error.
LayerVolumes layer_volumes(const NodesView& nodes, const TrianglesView& triangles, int lines);

/// Crossings of the skin in one state.
struct Crossing {
  std::size_t pairs = 0;     // pairs of elements that cross
  std::size_t elements = 0;  // elements in them
  std::size_t layers = 0;    // pairs of fabric that are no neighbours: contact of the skin keeps them apart
  std::pair<int, int> first_layers{-1, -1};  // first of these pairs
  LayerVolumes volumes{};                    // zero if no elements cross
  /// [m3] Counted twice or inside out.
  double miscounted() const { return volumes.counted_twice.value + volumes.inside_out.value; }
};

/// Looks at a skin. Without `closed` it has no volumes. If no elements of a connected skin cross, w is 0 or 1
/// everywhere, and no line is drawn. `null_elements` are not fabric; they rise.
Crossing find_crossing(const NodesView& nodes, const TrianglesView& triangles, bool closed,
                       std::span<const int> null_elements = {});

/// Elements, pairs and volumes in words; volumes as shares of the signed `volume` [m3] if that is above 0.
std::string text_of(const Crossing& crossing, double volume);

}  // namespace driver
