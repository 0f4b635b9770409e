// SPDX-License-Identifier: Apache-2.0
#include "mesh/merge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "checks.hpp"
#include "node_sets.hpp"

namespace mesh {
namespace {

using Cube = std::array<std::int64_t, 3>;

// Remaining nodes, by cubes whose side is the tolerance: neighbours are in the 27 cubes around.
class Neighbours {
 public:
  Neighbours(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  // The node to which node `n` is joined. If there is none, stores `n` as remaining and returns it.
  int join(int n) {
    const Eigen::Vector3d x = mesh_.nodes.col(n);
    const Cube own = cube_of(x);
    int first = n;
    for (int k = 0; k < 27; ++k) {
      const Cube beside{own[0] + k % 3 - 1, own[1] + k / 3 % 3 - 1, own[2] + k / 9 - 1};
      const auto [begin, end] = staying_.equal_range(beside);
      for (auto it = begin; it != end; ++it)
        if (it->second < first && is_near(it->second, n)) first = it->second;
    }
    if (first == n) staying_.emplace(own, n);
    return first;
  }

 private:
  Cube cube_of(const Eigen::Vector3d& x) const {
    Cube cube;
    for (std::size_t c = 0; c < 3; ++c) {
      const double place = std::floor(x[static_cast<Eigen::Index>(c)] / tolerance_);
      if (!(std::abs(place) < 0x1p52))
        throw std::invalid_argument("a node is not finite, or too far away for this tolerance");
      cube[c] = static_cast<std::int64_t>(place);
    }
    return cube;
  }

  // True if two nodes are near in both shapes.
  bool is_near(int a, int b) const {
    const auto near = [&](const Eigen::Matrix3Xd& x) { return (x.col(a) - x.col(b)).norm() <= tolerance_; };
    return near(mesh_.nodes) && (!mesh_.start || near(*mesh_.start));
  }

  const Mesh& mesh_;
  double tolerance_;
  std::multimap<Cube, int> staying_;
};

std::vector<int> joined(const Mesh& mesh, double tolerance) {
  const Eigen::Matrix3Xd &nodes = mesh.nodes, &start = mesh.start_nodes();
  std::vector<int> of(static_cast<std::size_t>(nodes.cols()));
  if (tolerance > 0.0) {
    Neighbours neighbours(mesh, tolerance);
    for (int n = 0; n < nodes.cols(); ++n) of[static_cast<std::size_t>(n)] = neighbours.join(n);
    return of;
  }
  std::map<std::array<double, 6>, int> first;
  for (int n = 0; n < nodes.cols(); ++n) {
    if (!nodes.col(n).allFinite()) throw std::invalid_argument("a node is not finite");
    std::array<double, 6> x;
    for (std::size_t c = 0; c < 6; ++c)  // -0 equals 0
      x[c] = (c < 3 ? nodes : start)(static_cast<Eigen::Index>(c % 3), n) + 0.0;
    of[static_cast<std::size_t>(n)] = first.try_emplace(x, n).first->second;
  }
  return of;
}

// Keeps the nodes that are marked, and renumbers the elements' corners by `of`.
void keep_nodes(Mesh& mesh, const std::vector<bool>& stays, const std::vector<int>& of) {
  std::vector<int> place(stays.size(), -1);
  int count = 0;
  for (std::size_t n = 0; n < stays.size(); ++n)
    if (stays[n]) {
      mesh.nodes.col(count) = mesh.nodes.col(static_cast<Eigen::Index>(n));
      if (mesh.start) mesh.start->col(count) = mesh.start->col(static_cast<Eigen::Index>(n));
      place[n] = count++;
    }
  mesh.nodes.conservativeResize(3, count);
  if (mesh.start) mesh.start->conservativeResize(3, count);
  const auto now = [&](int node) {
    return place[static_cast<std::size_t>(of[static_cast<std::size_t>(node)])];
  };
  for (int& corner : mesh.elements.reshaped()) corner = now(corner);
  mesh.node_sets = renumbered_sets(mesh.node_sets, now);
}

// Removes elements with two equal corners; returns their number.
int drop_repeated(Mesh& mesh) {
  Eigen::Index count = 0;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Vector3i c = mesh.elements.col(e);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    mesh.elements.col(count) = c;
    mesh.panel[static_cast<std::size_t>(count)] = mesh.panel[static_cast<std::size_t>(e)];
    if (!mesh.line.empty())
      mesh.line[static_cast<std::size_t>(count)] = mesh.line[static_cast<std::size_t>(e)];
    ++count;
  }
  const auto gone = static_cast<int>(mesh.elements.cols() - count);
  mesh.elements.conservativeResize(3, count);
  mesh.panel.resize(static_cast<std::size_t>(count));
  if (!mesh.line.empty()) mesh.line.resize(static_cast<std::size_t>(count));
  return gone;
}

}  // namespace

MergeReport merge_nodes(Mesh& mesh, double tolerance) {
  if (!(std::isfinite(tolerance) && tolerance >= 0.0))
    throw std::invalid_argument("tolerance = " + std::to_string(tolerance) + ", allowed: finite and >= 0");
  require_nodes("merge_nodes", mesh.elements, mesh.nodes.cols());
  const std::vector<int> of = joined(mesh, tolerance);
  std::vector<bool> stays(of.size());
  for (std::size_t n = 0; n < of.size(); ++n) stays[n] = of[n] == static_cast<int>(n);
  MergeReport report;
  report.nodes = static_cast<int>(std::count(stays.begin(), stays.end(), false));
  keep_nodes(mesh, stays, of);
  report.elements = drop_repeated(mesh);
  return report;
}

int drop_collapsed(Mesh& mesh, Eigen::Matrix3Xd* start) {
  require_nodes("drop_collapsed", mesh.elements, mesh.nodes.cols());
  std::vector<int> of(static_cast<std::size_t>(mesh.nodes.cols()));
  std::iota(of.begin(), of.end(), 0);
  const auto first = [&](int node) {  // each search halves the path of the next
    for (auto n = static_cast<std::size_t>(node); of[n] != node;
         node = of[n = static_cast<std::size_t>(node)])
      of[n] = of[static_cast<std::size_t>(of[n])];
    return node;
  };
  std::vector<bool> was_used(of.size(), false), stays(of.size(), true);
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e)
    for (int a = 0; a < 3; ++a) {
      const int i = mesh.elements(a, e), j = mesh.elements((a + 1) % 3, e);
      was_used[static_cast<std::size_t>(i)] = true;
      if (mesh.nodes.col(i) != mesh.nodes.col(j)) continue;
      const auto [low, high] = std::minmax({first(i), first(j)});
      of[static_cast<std::size_t>(high)] = low;
    }
  for (int& corner : mesh.elements.reshaped()) corner = first(corner);
  const int gone = drop_repeated(mesh);
  if (gone == 0) return 0;
  for (std::size_t n = 0; n < of.size(); ++n) stays[n] = !was_used[n];
  for (const int corner : mesh.elements.reshaped()) stays[static_cast<std::size_t>(corner)] = true;
  if (start) {
    Mesh other;
    other.nodes = *start;
    keep_nodes(other, stays, of);
    *start = other.nodes;
  }
  keep_nodes(mesh, stays, of);
  return gone;
}

Mesh used_nodes(Mesh mesh) {
  require_nodes("used_nodes", mesh.elements, mesh.nodes.cols());
  std::vector<bool> stays(static_cast<std::size_t>(mesh.nodes.cols()), false);
  std::vector<int> of(stays.size());
  for (std::size_t n = 0; n < of.size(); ++n) of[n] = static_cast<int>(n);
  for (const int corner : mesh.elements.reshaped()) stays[static_cast<std::size_t>(corner)] = true;
  keep_nodes(mesh, stays, of);
  return mesh;
}

}  // namespace mesh
