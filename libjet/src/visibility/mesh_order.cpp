// SPDX-License-Identifier: Apache-2.0
#include "visibility/mesh_order.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace jet {
namespace {

struct Link {
  int a, b, weight;  // patches, and edges that they share
};

std::vector<Link> shared_edges(std::span<const Triangle> triangles) {
  std::vector<std::tuple<int, int, int>> edges;  // nodes, element
  for (std::size_t e = 0; e < triangles.size(); ++e) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[e][i], triangles[e][(i + 1) % 3]);
      edges.emplace_back(low, high, static_cast<int>(e));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Link> links;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [a, b, e] = edges[i - 1];
    const auto& [c, d, f] = edges[i];
    if (a == c && b == d && e != f) links.push_back({e, f, 1}), links.push_back({f, e, 1});
  }
  return links;
}

// Sorts the links by patch and leaves one for each neighbour.
void unite(std::vector<Link>& links) {
  std::sort(links.begin(), links.end(),
            [](const Link& x, const Link& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::size_t count = 0;
  for (const Link& link : links) {
    if (count > 0 && links[count - 1].a == link.a && links[count - 1].b == link.b) {
      links[count - 1].weight += link.weight;
    } else {
      links[count++] = link;
    }
  }
  links.resize(count);
}

/// Pairs each patch with the free neighbour that shares most edges with it, or leaves it alone. Sets the
/// number of its pair; returns the count of pairs.
int pair_up(const std::vector<Link>& links, std::vector<int>& pair_of) {
  int pairs = 0;
  std::size_t i = 0;
  for (int patch = 0; patch < static_cast<int>(pair_of.size()); ++patch) {
    int best = -1, most = 0;
    for (; i < links.size() && links[i].a == patch; ++i) {
      if (links[i].weight > most && pair_of[static_cast<std::size_t>(links[i].b)] < 0)
        best = links[i].b, most = links[i].weight;
    }
    if (pair_of[static_cast<std::size_t>(patch)] >= 0) continue;
    pair_of[static_cast<std::size_t>(patch)] = pairs;
    if (best >= 0) pair_of[static_cast<std::size_t>(best)] = pairs;
    ++pairs;
  }
  return pairs;
}

}  // namespace

std::vector<int> mesh_order(std::span<const Triangle> triangles) {
  std::vector<Link> links = shared_edges(triangles);
  std::vector<int> next(triangles.size(), -1), head(triangles.size()), tail;
  std::iota(head.begin(), head.end(), 0);
  tail = head;
  while (!links.empty()) {
    unite(links);
    std::vector<int> pair_of(head.size(), -1);
    const auto pairs = static_cast<std::size_t>(pair_up(links, pair_of));
    std::vector<int> new_head(pairs, -1), new_tail(pairs);
    for (std::size_t patch = 0; patch < head.size(); ++patch) {
      const auto p = static_cast<std::size_t>(pair_of[patch]);
      (new_head[p] < 0 ? new_head[p] : next[static_cast<std::size_t>(new_tail[p])]) = head[patch];
      new_tail[p] = tail[patch];
    }
    head.swap(new_head);
    tail.swap(new_tail);
    for (Link& link : links) {
      link.a = pair_of[static_cast<std::size_t>(link.a)];
      link.b = pair_of[static_cast<std::size_t>(link.b)];
    }
    std::erase_if(links, [](const Link& link) { return link.a == link.b; });
  }
  std::vector<int> order;
  for (const int first : head) {
    for (int e = first; e >= 0; e = next[static_cast<std::size_t>(e)]) order.push_back(e);
  }
  return order;
}

OrderedMesh::OrderedMesh(std::span<const Triangle> mesh)
    : elements(mesh_order(mesh)), rank(mesh.size()), patches(static_cast<int>((mesh.size() + 7) / 8)) {
  for (std::size_t i = 0; i < mesh.size(); ++i)
    rank[static_cast<std::size_t>(elements[i])] = static_cast<int>(i);
  elements.resize(8 * static_cast<std::size_t>(patches), elements.back());
  const auto triangle = [&](std::size_t place) { return mesh[static_cast<std::size_t>(elements[place])]; };
  std::vector<int> nodes;
  for (std::size_t i = 0; i < elements.size(); i += 8) {
    nodes.clear();
    for (std::size_t j = i; j < i + 8; ++j)
      for (const int node : triangle(j)) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    patch_begin.push_back(static_cast<int>(patch_nodes.size()));
    patch_nodes.insert(patch_nodes.end(), nodes.begin(), std::unique(nodes.begin(), nodes.end()));
    patch_nodes.resize((patch_nodes.size() + 3) / 4 * 4, patch_nodes.back());
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t j = i; j < i + 8; ++j)
        corner_rows.push_back(4 * static_cast<std::uint32_t>(triangle(j)[corner]));
  }
  patch_begin.push_back(static_cast<int>(patch_nodes.size()));
}

}  // namespace jet
