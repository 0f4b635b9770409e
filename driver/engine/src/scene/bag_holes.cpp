// SPDX-License-Identifier: Apache-2.0
#include "engine/bag_holes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "mesh/holes.hpp"

namespace driver {
namespace {

bool has_all(const mesh::NodeSet& set, const mesh::Hole& hole) {
  return std::ranges::all_of(hole.nodes,
                             [&](int node) { return std::ranges::binary_search(set.nodes, node); });
}

// Names of the node sets that have all nodes of a hole.
std::vector<std::string> sets_of(const mesh::Hole& hole, const mesh::Mesh& mesh) {
  std::vector<std::string> names;
  for (const mesh::NodeSet& set : mesh.node_sets)
    if (has_all(set, hole)) names.push_back(set.name);
  return names;
}

// The name of the smallest set with all nodes of a hole, if it has no other hole; else empty.
std::string own_set(std::size_t hole, const std::vector<mesh::Hole>& holes, const mesh::Mesh& mesh) {
  const mesh::NodeSet* smallest = nullptr;
  for (const mesh::NodeSet& set : mesh.node_sets)
    if (has_all(set, holes[hole]) && (!smallest || set.nodes.size() < smallest->nodes.size()))
      smallest = &set;
  if (!smallest) return {};
  const auto has = [&](const mesh::Hole& one) { return has_all(*smallest, one); };
  return std::ranges::count_if(holes, has) == 1 ? smallest->name : "";
}

std::string described(const mesh::Hole& hole, const mesh::Mesh& mesh) {
  const auto sets = sets_of(hole, mesh);
  return mesh::describe(hole) + (sets.empty() ? "" : fmt::format("; node set {}", fmt::join(sets, ", ")));
}

std::vector<std::size_t> holes_of_set(const std::string& set, const std::vector<mesh::Hole>& holes,
                                      const mesh::Mesh& mesh) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < holes.size(); ++i)
    if (const auto sets = sets_of(holes[i], mesh); std::ranges::find(sets, set) != sets.end())
      list.push_back(i);
  if (!list.empty()) return list;
  std::vector<std::string> known;
  for (const mesh::NodeSet& one : mesh.node_sets) known.push_back(one.name);
  throw std::invalid_argument(
      std::ranges::find(known, set) != known.end()
          ? fmt::format("node set \"{}\" has all nodes of no hole", set)
          : fmt::format("there is no node set \"{}\"{}", set,
                        known.empty() ? "" : fmt::format("; the file has {}", fmt::join(known, ", "))));
}

// The holes of a cap, from 0.
std::vector<std::size_t> holes_of(const Cap& cap, const std::vector<mesh::Hole>& holes,
                                  const mesh::Mesh& mesh) {
  if (!cap.set.empty()) return holes_of_set(cap.set, holes, mesh);
  std::vector<std::size_t> list(holes.size());
  std::iota(list.begin(), list.end(), std::size_t{0});
  if (!cap.hole) return list;
  const auto number = static_cast<std::size_t>(std::max(*cap.hole, 0));
  if (number < 1 || number > holes.size())
    throw std::invalid_argument(
        fmt::format("there is no hole {}; the surface has {}", *cap.hole, holes.size()));
  return {number - 1};
}

}  // namespace

std::string list_of_holes(const mesh::Mesh& mesh) {
  constexpr std::size_t most = 20;
  try {
    std::string text;
    const auto holes = mesh::find_holes(mesh.nodes, mesh.elements, mesh.line);
    for (std::size_t i = 0; i < std::min(holes.size(), most); ++i)
      text += fmt::format("hole {}: {}\n", i + 1, described(holes[i], mesh));
    return text + (holes.size() > most ? fmt::format("and {} shorter holes\n", holes.size() - most) : "");
  } catch (const std::invalid_argument& error) {
    return fmt::format("{}\n", error.what());
  }
}

std::vector<Cap> caps_of_all(const mesh::Mesh& mesh) {
  const auto holes = mesh::find_holes(mesh.nodes, mesh.elements, mesh.line);
  if (holes.empty()) throw std::invalid_argument("the mesh has no hole");
  std::vector<std::string> used = mesh.panel_names;
  std::vector<Cap> caps;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string set = own_set(i, holes, mesh);
    const bool is_named = !set.empty() && std::ranges::find(used, set) == used.end();
    caps.push_back({is_named ? set : fmt::format("cap_{}", i + 1), static_cast<int>(i) + 1});
    used.push_back(caps.back().panel);
  }
  return caps;
}

std::vector<std::string> close_holes(mesh::Mesh& mesh, const std::vector<Cap>& caps, double longest) {
  const auto holes = mesh::find_holes(mesh.nodes, mesh.elements, mesh.line);
  const std::vector<std::string> own = mesh.panel_names;
  std::vector<bool> is_closed(holes.size(), false);
  std::vector<std::string> lines;
  std::vector<Cap> ordered = caps;  // one for all holes takes those that no other does
  const auto takes_rest = [](const Cap& cap) { return !cap.hole && cap.set.empty(); };
  std::stable_partition(ordered.begin(), ordered.end(), std::not_fn(takes_rest));
  for (const Cap& cap : ordered) {
    if (std::ranges::find(own, cap.panel) != own.end())
      throw std::invalid_argument(
          fmt::format("the mesh has a panel \"{}\" already; a cap is a panel of its own", cap.panel));
    const std::size_t before = lines.size();
    for (const std::size_t i : holes_of(cap, holes, mesh)) {
      if (is_closed[i]) {
        if (takes_rest(cap)) continue;
        throw std::invalid_argument(fmt::format("hole {} is closed twice", i + 1));
      }
      is_closed[i] = true;
      mesh::close_hole(mesh, holes[i], cap.panel, longest);
      lines.push_back(fmt::format("panel {} closes hole {}: {}", cap.panel, i + 1, mesh::describe(holes[i])));
    }
    if (lines.size() == before)
      throw std::invalid_argument(
          fmt::format("the mesh has no hole {}for \"{}\"", holes.empty() ? "" : "left ", cap.panel));
  }
  return lines;
}

}  // namespace driver
