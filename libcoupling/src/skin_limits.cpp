// SPDX-License-Identifier: Apache-2.0
#include "skin_limits.hpp"

#include <algorithm>

namespace coupling::detail {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// A limit rises by no more than that in a level.
constexpr double kGrowth = 1.25;

std::vector<int> below(const std::vector<double>& limits, double full) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (limits[i] < full) numbers.push_back(static_cast<int>(i));
  return numbers;
}

}  // namespace

SkinLimits::SkinLimits(const SkinParts& parts)
    : parts_(&parts),
      thickness_(parts.parameters.thickness),
      nodes_(parts.masses.size(), thickness_),
      edges_(parts.edges.size(), parts.reach_of(true)),
      least_node_(nodes_.size(), kFar),
      least_edge_(edges_.size(), kFar),
      groups_(parts.groups.count(), thickness_) {}

double SkinLimits::reach_of_node(int node) const {
  return std::min(thickness_, kGrowth * of_node(node));
}

double SkinLimits::most_of_edge(int edge) const {
  const auto& nodes = parts_->edges[static_cast<std::size_t>(edge)];
  return SkinParts::kEdgeShare * std::min(of_node(nodes[0]), of_node(nodes[1]));
}

// At the distance told.
double SkinLimits::limit_of_edge(int edge) const {
  const double most = most_of_edge(edge), told = least_edge_[static_cast<std::size_t>(edge)];
  return told < most ? SkinParts::kEdgeShare * told : most;
}

double SkinLimits::of(const PartPair& pair) const {
  if (!pair.edges) return of_node(pair.first);
  return std::min(edges_[static_cast<std::size_t>(pair.first)],
                  edges_[static_cast<std::size_t>(pair.second)]);
}

double SkinLimits::reach_of(const PartPair& pair) const {
  if (!pair.edges) return reach_of_node(pair.first);
  return std::min(most_of_edge(pair.first), most_of_edge(pair.second));
}

double SkinLimits::reach_of_nodes(int group) const {
  return std::min(thickness_, kGrowth * groups_[static_cast<std::size_t>(group)]);
}

double SkinLimits::reach_of_edges(int group) const {
  return SkinParts::kEdgeShare * groups_[static_cast<std::size_t>(group)];
}

void SkinLimits::tell(const PartPair& pair, double distance) {
  const auto lower = [&](std::vector<double>& least, int part) {
    double& told = least[static_cast<std::size_t>(part)];
    told = std::min(told, distance);
  };
  lower(pair.edges ? least_edge_ : least_node_, pair.first);
  if (pair.edges) lower(least_edge_, pair.second);
}

void SkinLimits::set_from_told() {
  for (std::size_t n = 0; n < nodes_.size(); ++n) nodes_[n] = std::min(thickness_, least_node_[n]);
  for (std::size_t e = 0; e < edges_.size(); ++e) edges_[e] = limit_of_edge(static_cast<int>(e));
  std::ranges::fill(least_node_, kFar);
  std::ranges::fill(least_edge_, kFar);
  small_nodes_ = below(nodes_, thickness_);
  small_edges_ = below(edges_, parts_->reach_of(true));
  set_groups();
}

void SkinLimits::write(SkinContactRecord& record) const {
  record.node_limits = nodes_;
  record.edge_limits = edges_;
}

void SkinLimits::read(const SkinContactRecord& record) {
  nodes_ = record.node_limits;
  edges_ = record.edge_limits;
  small_nodes_ = below(nodes_, thickness_);
  small_edges_ = below(edges_, parts_->reach_of(true));
  set_groups();
}

void SkinLimits::raise() {
  if (small_nodes_.empty() && small_edges_.empty()) return;
  std::erase_if(small_edges_, [&](int edge) {
    const auto e = static_cast<std::size_t>(edge);
    edges_[e] = std::max(edges_[e], limit_of_edge(edge));
    return !(edges_[e] < parts_->reach_of(true));
  });
  std::erase_if(small_nodes_, [&](int node) {
    const auto n = static_cast<std::size_t>(node);
    nodes_[n] = std::max(nodes_[n], std::min(reach_of_node(node), least_node_[n]));
    return !(nodes_[n] < thickness_);
  });
  for (const int edge : small_edges_) least_edge_[static_cast<std::size_t>(edge)] = kFar;
  for (const int node : small_nodes_) least_node_[static_cast<std::size_t>(node)] = kFar;
  set_groups();
}

void SkinLimits::set_groups() {
  const ElementGroups& groups = parts_->groups;
  for (std::size_t g = 0; g < groups.count(); ++g) {
    groups_[g] = 0.0;
    for (std::size_t k = groups.first_node[g]; k < groups.first_node[g + 1]; ++k)
      groups_[g] = std::max(groups_[g], of_node(groups.nodes[k]));
  }
}

}  // namespace coupling::detail
