// SPDX-License-Identifier: Apache-2.0
// Limits of a skin's nodes and edges: the distances within which they push (K.45).
#pragma once
#include <limits>
#include <vector>

#include "skin_parts.hpp"

namespace coupling::detail {

/// Limits of one run. What starts closer than the thickness has a smaller limit, which only rises, and only
/// where there is no force. So no more has to be looked at than what is within a limit or a little more.
class SkinLimits {
 public:
  explicit SkinLimits(const SkinParts& parts);

  double of_node(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  double of(const PartPair& pair) const;
  /// [m] Distance up to which the pair has to be told.
  double reach_of(const PartPair& pair) const;
  /// [m] The largest one of nodes, or edges, of a group. It does not fall.
  double reach_of_nodes(int group) const;
  double reach_of_edges(int group) const;

  /// Tells a distance at this level.
  void tell(const PartPair& pair, double distance);
  void set_from_told();  // at the first level
  void raise();          // after each other one

  /// Writes the limits between two levels, and reads them.
  void write(SkinContactRecord& record) const;
  void read(const SkinContactRecord& record);
  const std::vector<int>& small_nodes() const { return small_nodes_; }  // with limits below the thickness

 private:
  double reach_of_node(int node) const;
  double most_of_edge(int edge) const;
  double limit_of_edge(int edge) const;
  void set_groups();

  const SkinParts* parts_;
  double thickness_;
  std::vector<double> nodes_, edges_;            // [m]
  std::vector<double> least_node_, least_edge_;  // [m] told at this level
  std::vector<int> small_nodes_, small_edges_;
  std::vector<double> groups_;  // [m] largest limit of a node
};

}  // namespace coupling::detail
