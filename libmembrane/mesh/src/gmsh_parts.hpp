// SPDX-License-Identifier: Apache-2.0
// Private to the reader of Gmsh files: physical groups, and nodes by their numbers.
#pragma once

#include <Eigen/Core>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "gmsh_numbers.hpp"
#include "mesh/mesh.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {

inline constexpr const char* kOneGroup = "; remove it from one of them";

/// The physical groups of surfaces.
class GmshGroups {
 public:
  GmshGroups(TokenReader& words, GmshNumbers& numbers) : words_(words), numbers_(numbers) {}

  void read_names() {
    const std::size_t count = words_.count("the number of names");
    for (std::size_t i = 0; i < count; ++i) {
      const long long dimension = words_.integer("a dimension", 0, 3),
                      group = words_.integer("a physical group", -GmshNumbers::most, GmshNumbers::most);
      const MeshWord at = words_.peek("a name in quotes");
      const std::string_view rest = words_.rest_of_line();
      if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"')
        words_.fail(at, shown(rest) + " is not a name in quotes");
      if (dimension == 1) curve_names_[group] = panel_name(rest.substr(1, rest.size() - 2));
      if (dimension == 2) names_[group] = panel_name(rest.substr(1, rest.size() - 2));
    }
  }

  // Version 4: which physical groups each surface is in.
  void read_entities() {
    numbers_.begin();
    std::size_t counts[4];
    for (std::size_t& count : counts) count = numbers_.count("the number of entities");
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        const long long entity = numbers_.tag("an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) numbers_.number("a coordinate");
        const std::size_t groups = numbers_.count("the number of physical groups");
        for (std::size_t k = 0; k < groups; ++k) {
          const long long group = numbers_.tag("a physical group");
          // Its sign is an orientation.
          if (dimension == 1) groups_of_curve_[entity].insert(std::abs(group));
          if (dimension == 2) groups_of_surface_[entity].insert(std::abs(group));
        }
        if (dimension == 0) continue;
        const std::size_t bounding = numbers_.count("the number of bounding entities");
        for (std::size_t k = 0; k < bounding; ++k) numbers_.tag("an entity");
      }
  }

  /// Adds the nodes of a line to the sets of its physical curves, by its group (version 2) or its entity.
  void add_line(std::optional<long long> group, long long entity, const std::vector<int>& nodes) {
    std::set<long long> groups;
    if (group && *group != 0) groups.insert(std::abs(*group));
    if (const auto found = groups_of_curve_.find(entity); !group && found != groups_of_curve_.end())
      groups = found->second;
    for (const long long number : groups) {
      const auto name = curve_names_.find(number);
      auto& set = sets_[name == curve_names_.end() ? "physical_" + std::to_string(number) : name->second];
      set.insert(nodes.begin(), nodes.end());
    }
  }
  std::vector<NodeSet> node_sets() const {
    std::vector<NodeSet> list;
    for (const auto& [name, nodes] : sets_) list.push_back({name, {nodes.begin(), nodes.end()}});
    return list;
  }

  std::string panel_of(long long group, long long surface) const {
    if (group == 0) return "surface_" + std::to_string(surface);
    const auto name = names_.find(group);
    return name == names_.end() ? "physical_" + std::to_string(group) : name->second;
  }

  // The one group of a surface; 0 if it is in none.
  long long group_of(const MeshWord& at, long long surface) const {
    const auto found = groups_of_surface_.find(surface);
    if (found == groups_of_surface_.end()) return 0;
    const std::set<long long>& groups = found->second;
    if (groups.size() > 1)
      words_.fail(at, "surface " + std::to_string(surface) + " is in two physical groups, " +
                          panel_of(*groups.begin(), surface) + " and " +
                          panel_of(*std::next(groups.begin()), surface) + kOneGroup);
    return *groups.begin();
  }

 private:
  TokenReader& words_;
  GmshNumbers& numbers_;
  std::map<long long, std::string> names_, curve_names_;  // of physical surfaces and curves
  std::map<long long, std::set<long long>> groups_of_surface_, groups_of_curve_;
  std::map<std::string, std::set<int>> sets_;
};

/// Nodes, and the index of each node number.
class GmshNodes {
 public:
  GmshNodes(TokenReader& words, GmshNumbers& numbers) : words_(words), numbers_(numbers) {}

  /// Reads the position of the node `number`.
  void read(const MeshWord& at, long long number) {
    if (!index_.try_emplace(number, static_cast<int>(positions.size())).second)
      words_.fail(at, "node " + std::to_string(number) + " is repeated");
    const double x = numbers_.number("x"), y = numbers_.number("y");
    positions.push_back({x, y, numbers_.number("z")});
  }
  int index_of(const MeshWord& at, long long number) const {
    const auto found = index_.find(number);
    if (found == index_.end()) words_.fail(at, "node " + std::to_string(number) + " is not in $Nodes");
    return found->second;
  }

  std::vector<Eigen::Vector3d> positions;

 private:
  TokenReader& words_;
  GmshNumbers& numbers_;
  std::unordered_map<long long, int> index_;
};

}  // namespace mesh
