// SPDX-License-Identifier: Apache-2.0
// Closed skins for the side tests.
#pragma once
#include <map>
#include <utility>

#include "scenes.hpp"

namespace scenes {

// Unit sphere: a regular octahedron, outward, its faces split `levels` times and pushed out.
inline Skin octasphere(int levels) {
  std::vector<Eigen::Vector3d> nodes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Eigen::Vector3i> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(nodes.size()));
      if (fresh)
        nodes.push_back(
            (nodes[static_cast<std::size_t>(a)] + nodes[static_cast<std::size_t>(b)]).normalized());
      return entry->second;
    };
    std::vector<Eigen::Vector3i> split;
    for (const auto& f : faces) {
      const int ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
      for (const Eigen::Vector3i& part : {Eigen::Vector3i(f[0], ab, ca), Eigen::Vector3i(ab, f[1], bc),
                                          Eigen::Vector3i(ca, bc, f[2]), Eigen::Vector3i(ab, bc, ca)})
        split.push_back(part);
    }
    faces = split;
  }
  Skin skin;
  skin.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t a = 0; a < nodes.size(); ++a) skin.nodes.col(static_cast<Eigen::Index>(a)) = nodes[a];
  skin.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t e = 0; e < faces.size(); ++e) skin.triangles.col(static_cast<Eigen::Index>(e)) = faces[e];
  lump_masses(skin, 0.31);
  return skin;
}

// Two closed skins side by side in one array.
inline Skin joined(const Skin& first, const Skin& second) {
  Skin skin;
  skin.nodes.resize(3, first.nodes.cols() + second.nodes.cols());
  skin.nodes << first.nodes, second.nodes;
  skin.triangles.resize(3, first.triangles.cols() + second.triangles.cols());
  skin.triangles << first.triangles,
      (second.triangles.array() + static_cast<int>(first.nodes.cols())).matrix();
  lump_masses(skin, 0.31);
  return skin;
}

}  // namespace scenes
