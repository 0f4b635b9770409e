// SPDX-License-Identifier: Apache-2.0
// Plane targets for jets, with the areas and centroids that stage S1 would give.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "jet/jet.hpp"

namespace plates {

struct Target {
  Eigen::Matrix3Xd nodes;  // [m]
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix3Xd area_vectors;  // [m2]
  Eigen::Matrix3Xd centroids;     // [m]
  int count() const { return static_cast<int>(triangles.cols()); }
};

inline Target finish(Eigen::Matrix3Xd nodes, Eigen::Matrix3Xi triangles) {
  Target target{std::move(nodes), std::move(triangles), {}, {}};
  target.area_vectors.resize(3, target.count());
  target.centroids.resize(3, target.count());
  for (int e = 0; e < target.count(); ++e) {
    const Eigen::Vector3d a = target.nodes.col(target.triangles(0, e));
    const Eigen::Vector3d b = target.nodes.col(target.triangles(1, e));
    const Eigen::Vector3d c = target.nodes.col(target.triangles(2, e));
    target.area_vectors.col(e) = 0.5 * (b - a).cross(c - a);
    target.centroids.col(e) = (a + b + c) / 3.0;
  }
  return target;
}

/// Plate of nu x nv cells about `centre`, spanned by the cell sides u and v, two triangles a cell, normal u x
/// v.
inline Target plate(const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int nu,
                    int nv) {
  Eigen::Matrix3Xd nodes(3, (nu + 1) * (nv + 1));
  for (int j = 0; j <= nv; ++j) {
    for (int i = 0; i <= nu; ++i)
      nodes.col(i + j * (nu + 1)) = centre + (i - 0.5 * nu) * u + (j - 0.5 * nv) * v;
  }
  Eigen::Matrix3Xi triangles(3, 2 * nu * nv);
  for (int j = 0, e = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i, e += 2) {
      const int n = i + j * (nu + 1);
      triangles.col(e) << n, n + 1, n + nu + 2;
      triangles.col(e + 1) << n, n + nu + 2, n + nu + 1;
    }
  }
  return finish(std::move(nodes), std::move(triangles));
}

/// Disc of the given radius about `centre`, normal u x v (unit vectors): `rings` rings of 6 k nodes each.
inline Target disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                   double radius, int rings) {
  Eigen::Matrix3Xd nodes(3, 1 + 3 * rings * (rings + 1));
  nodes.col(0) = centre;
  const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < 6 * ring; ++i) {
      const double phi = 2.0 * std::numbers::pi * i / (6.0 * ring);
      nodes.col(first(ring) + i) = centre + radius * ring / rings * (std::cos(phi) * u + std::sin(phi) * v);
    }
  }
  std::vector<Eigen::Vector3i> triangles;
  const auto node = [&](int ring, int i) { return ring == 0 ? 0 : first(ring) + i % (6 * ring); };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < 6 * ring; ++i) {
      const int inner = i * (ring - 1) / ring, next = (i + 1) * (ring - 1) / ring;
      triangles.emplace_back(node(ring, i), node(ring, i + 1), node(ring - 1, next));
      if (next != inner) triangles.emplace_back(node(ring, i), node(ring - 1, next), node(ring - 1, inner));
    }
  }
  Eigen::Matrix3Xi matrix(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t e = 0; e < triangles.size(); ++e) matrix.col(static_cast<Eigen::Index>(e)) = triangles[e];
  return finish(std::move(nodes), std::move(matrix));
}

}  // namespace plates
