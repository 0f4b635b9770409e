// SPDX-License-Identifier: Apache-2.0
// Nodes, edges and triangles of a skin, and which of them are neighbours.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "coupling/element_groups.hpp"
#include "coupling/skin_contact.hpp"
#include "skin_masks.hpp"

namespace coupling::detail {

/// Lists one after the other: list i has items[first[i]] to items[first[i + 1]].
struct Lists {
  std::vector<int> items;
  std::vector<std::size_t> first{0};
  std::span<const int> operator[](int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {items.data() + first[k], first[k + 1] - first[k]};
  }
  void add(std::span<const int> list) {
    items.insert(items.end(), list.begin(), list.end());
    first.push_back(items.size());
  }
};

/// A node and a triangle, or two edges, by their numbers.
struct PartPair {
  int first, second;
  bool edges;
};

/// An edge or node that elements share.
struct SharedPart {
  int owner = -1;  // first element with it
  int count = 1;   // c_f without neighbours (K.44)
};

/// The constant part of a skin's contact with itself.
struct SkinParts {
  SkinParts(const Triangles& triangles, const Nodes& reference, std::span<const double> masses,
            const SkinContactParameters& parameters);

  /// True if the nodes are one, or an edge joins them.
  bool adjacent(int node, int other) const;
  /// True if a corner of one part is adjacent to one of the other: they are neighbours, and do not touch.
  bool neighbours(const PartPair& pair) const;
  /// Number c_f of an edge or node for a node that touches elements at it (K.44).
  int count_of_edge(int edge, int node) const;
  int count_of_node(int corner, int node) const;
  /// Edges only keep creases from crossing, and touch at this share of the distance of nodes.
  static constexpr double kEdgeShare = 0.8;
  double reach_of(bool of_edges) const { return (of_edges ? kEdgeShare : 1.0) * parameters.thickness; }
  /// Elements of a group.
  std::span<const int> group_elements(int group) const {
    const auto begin = static_cast<std::size_t>(group) * ElementGroups::kSize;
    return std::span(groups.elements)
        .subspan(begin, std::min(ElementGroups::kSize, groups.elements.size() - begin));
  }

  SkinContactParameters parameters;
  Eigen::Matrix3Xi triangles;             // (3 x M)
  std::vector<std::array<int, 2>> edges;  // (E) nodes, ascending
  Eigen::Matrix3Xi triangle_edges;        // (3 x M) edge k is opposite corner k
  Lists opposite;                         // (E) corners opposite to the edge, one a triangle
  Lists neighbours_of;                    // (N) nodes joined to it, ascending
  std::vector<SharedPart> shared_edges;   // (E)
  std::vector<SharedPart> shared_nodes;   // (N)
  std::vector<double> node_weight;        // (N) [m2] A_n/2
  std::vector<double> edge_weight;        // (E) [m2] half of the triangles at it
  std::vector<double> masses;             // (N) [kg]
  double mean_edge = 0.0;                 // [m]
  double full_omega_squared = 0.0;        // [1/s2]
  ElementGroups groups;
  Lists group_nodes, group_edges;  // that belong to a group, each to one
  PartMasks masks;
};

}  // namespace coupling::detail
