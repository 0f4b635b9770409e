// SPDX-License-Identifier: Apache-2.0
#include "mesh/refine.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "checks.hpp"

namespace mesh {
namespace {

using Triangle = Eigen::Vector3i;

class Midpoints {
 public:
  explicit Midpoints(int first) : next_(first) {}

  void split(int a, int b) {
    if (node_.try_emplace(key(a, b), next_).second) {
      ends_.push_back({a, b});
      ++next_;
    }
  }
  // Midpoint of a side, -1 if it is not split.
  int operator()(int a, int b) const {
    const auto found = node_.find(key(a, b));
    return found == node_.end() ? -1 : found->second;
  }
  const std::vector<std::array<int, 2>>& ends() const { return ends_; }

 private:
  static std::int64_t key(int a, int b) { return (std::int64_t{std::min(a, b)} << 32) + std::max(a, b); }
  std::unordered_map<std::int64_t, int> node_;
  std::vector<std::array<int, 2>> ends_;
  int next_;
};

std::vector<bool> rim_only_elements(const Mesh& mesh, std::span<const std::string> panels) {
  std::vector<bool> rim_only(mesh.panel.size(), false);
  for (const std::string& name : panels)
    for (const int e : panel_elements(mesh, name)) rim_only[static_cast<std::size_t>(e)] = true;
  return rim_only;
}

Midpoints split_sides(const Mesh& mesh, const std::vector<bool>& rim_only) {
  Midpoints midpoints(mesh.node_count());
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (rim_only[static_cast<std::size_t>(e)]) continue;
    for (int i = 0; i < 3; ++i) midpoints.split(mesh.elements(i, e), mesh.elements((i + 1) % 3, e));
  }
  return midpoints;
}

// Parts of an element, midpoints ab, bc, ca or -1.
std::vector<Triangle> parts(const Triangle& corners, const Midpoints& midpoints) {
  std::array<int, 3> c{corners[0], corners[1], corners[2]}, m{};
  int split = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = midpoints(c[i], c[(i + 1) % 3]);
    split += m[i] >= 0;
  }
  if (split == 0) return {corners};
  if (split == 3) return {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}};
  // Rotated so that side 0 is split and, if two sides are split, side 2 is not.
  const auto at = [](std::size_t i) { return i % 3; };
  std::size_t s = 0;
  while (m[s] < 0 || (split == 2 && m[at(s + 2)] >= 0)) ++s;
  const int a = c[s], b = c[at(s + 1)], d = c[at(s + 2)], ab = m[s], bd = m[at(s + 1)];
  if (split == 1) return {{a, ab, d}, {ab, b, d}};
  return {{ab, b, bd}, {a, ab, bd}, {a, bd, d}};
}

void check(const Mesh& mesh) {
  if (mesh.element_count() > kMostElements / 4)
    throw std::invalid_argument("refine: the mesh has " + std::to_string(mesh.element_count()) +
                                " elements; four times as many must be at most " +
                                std::to_string(kMostElements));
  if (mesh.element_count() > 0 &&
      (mesh.elements.minCoeff() < 0 || mesh.elements.maxCoeff() >= mesh.node_count()))
    throw std::invalid_argument("refine: a node number is out of range");
  require_panels("refine", mesh);
}

}  // namespace

Mesh refine(const Mesh& mesh, std::span<const std::string> rim_only_panels) {
  check(mesh);
  const Midpoints midpoints = split_sides(mesh, rim_only_elements(mesh, rim_only_panels));
  Mesh fine;
  fine.panel_names = mesh.panel_names;
  const auto added = static_cast<Eigen::Index>(midpoints.ends().size());
  fine.nodes.resize(3, mesh.node_count() + added);
  fine.nodes.leftCols(mesh.node_count()) = mesh.nodes;
  for (Eigen::Index i = 0; i < added; ++i) {
    const auto& [a, b] = midpoints.ends()[static_cast<std::size_t>(i)];
    fine.nodes.col(mesh.node_count() + i) = 0.5 * (mesh.nodes.col(a) + mesh.nodes.col(b));
  }
  std::vector<Triangle> elements;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const Triangle& part : parts(mesh.elements.col(e), midpoints)) {
      elements.push_back(part);
      fine.panel.push_back(mesh.panel[static_cast<std::size_t>(e)]);
    }
  fine.elements.resize(3, static_cast<Eigen::Index>(elements.size()));
  for (std::size_t e = 0; e < elements.size(); ++e)
    fine.elements.col(static_cast<Eigen::Index>(e)) = elements[e];
  return fine;
}

}  // namespace mesh
