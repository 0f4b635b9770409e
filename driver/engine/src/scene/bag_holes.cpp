// SPDX-License-Identifier: Apache-2.0
#include "engine/bag_holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "mesh/holes.hpp"

namespace driver {
namespace {

// The holes of a cap, from 0.
std::vector<std::size_t> holes_of(const Cap& cap, std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), std::size_t{0});
  if (!cap.hole) return list;
  const auto number = static_cast<std::size_t>(std::max(*cap.hole, 0));
  if (number < 1 || number > count)
    throw std::invalid_argument(fmt::format("there is no hole {}; the surface has {}{}", *cap.hole, count,
                                            count == 0 ? "" : ", which gasjet mesh convert --report lists"));
  return {number - 1};
}

}  // namespace

std::string list_of_holes(const mesh::Mesh& mesh) {
  try {
    std::string text;
    const auto holes = mesh::find_holes(mesh.nodes, mesh.elements, mesh.line);
    for (std::size_t i = 0; i < holes.size(); ++i)
      text += fmt::format("hole {}: {}\n", i + 1, mesh::describe(holes[i]));
    return text;
  } catch (const std::invalid_argument& error) {
    return fmt::format("{}\n", error.what());
  }
}

std::vector<std::string> close_holes(mesh::Mesh& mesh, const std::vector<Cap>& caps, double longest) {
  const auto holes = mesh::find_holes(mesh.nodes, mesh.elements, mesh.line);
  const std::vector<std::string> own = mesh.panel_names;
  std::vector<bool> is_closed(holes.size(), false);
  std::vector<std::string> lines;
  std::vector<Cap> ordered = caps;  // one for all holes takes those that no other does
  std::ranges::stable_partition(ordered, [](const Cap& cap) { return cap.hole.has_value(); });
  for (const Cap& cap : ordered) {
    if (std::ranges::find(own, cap.panel) != own.end())
      throw std::invalid_argument(
          fmt::format("the mesh has a panel \"{}\" already; a cap is a panel of its own", cap.panel));
    for (const std::size_t i : holes_of(cap, holes.size())) {
      if (is_closed[i]) {
        if (!cap.hole) continue;
        throw std::invalid_argument(fmt::format("hole {} is closed twice", i + 1));
      }
      is_closed[i] = true;
      mesh::close_hole(mesh, holes[i], cap.panel, longest);
      lines.push_back(fmt::format("panel {} closes hole {}: {}", cap.panel, i + 1, mesh::describe(holes[i])));
    }
  }
  return lines;
}

}  // namespace driver
