// SPDX-License-Identifier: Apache-2.0
// Triangle meshes for the visibility tests.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace scenes {

struct Mesh {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<Eigen::Vector3i> elements;

  Eigen::Matrix3Xd points() const {
    Eigen::Matrix3Xd m(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) m.col(static_cast<Eigen::Index>(i)) = nodes[i];
    return m;
  }
  Eigen::Matrix3Xi triangles() const {
    Eigen::Matrix3Xi m(3, static_cast<Eigen::Index>(elements.size()));
    for (std::size_t i = 0; i < elements.size(); ++i) m.col(static_cast<Eigen::Index>(i)) = elements[i];
    return m;
  }
  const Eigen::Vector3d& corner(std::size_t e, int i) const {
    return nodes[static_cast<std::size_t>(elements[e][i])];
  }
  Eigen::Vector3d centroid(std::size_t e) const { return (corner(e, 0) + corner(e, 1) + corner(e, 2)) / 3.0; }
};

/// Reproducible uniform numbers: the standard's distributions may differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  Eigen::Vector3d vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

inline void append(Mesh& mesh, const Mesh& other) {
  const int offset = static_cast<int>(mesh.nodes.size());
  mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (const auto& t : other.elements) mesh.elements.push_back(t + Eigen::Vector3i::Constant(offset));
}

inline void flip(Mesh& mesh) {
  for (auto& t : mesh.elements) std::swap(t[1], t[2]);
}

/// Regular octahedron of circumradius 1, outward: its nodes and centroids have simple coordinates.
inline Mesh octahedron() {
  Mesh mesh;
  mesh.nodes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.elements = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// Each element split in four; new nodes at the edges' midpoints.
inline Mesh split(const Mesh& mesh) {
  Mesh result;
  result.nodes = mesh.nodes;
  std::map<std::pair<int, int>, int> middle;
  const auto mid = [&](int a, int b) {
    const auto [it, fresh] = middle.try_emplace(std::minmax(a, b), static_cast<int>(result.nodes.size()));
    if (fresh) {
      const Eigen::Vector3d p =
          0.5 * (result.nodes[static_cast<std::size_t>(a)] + result.nodes[static_cast<std::size_t>(b)]);
      result.nodes.push_back(p);
    }
    return it->second;
  };
  for (const auto& t : mesh.elements) {
    const int ab = mid(t[0], t[1]), bc = mid(t[1], t[2]), ca = mid(t[2], t[0]);
    result.elements.push_back({t[0], ab, ca});
    result.elements.push_back({ab, t[1], bc});
    result.elements.push_back({ca, bc, t[2]});
    result.elements.push_back({ab, bc, ca});
  }
  return result;
}

/// Sphere of 8 * 4^levels elements about the origin, outward.
inline Mesh sphere(int levels, double radius = 1.0) {
  Mesh mesh = octahedron();
  for (int i = 0; i < levels; ++i) mesh = split(mesh);
  for (auto& p : mesh.nodes) p *= radius / p.norm();
  return mesh;
}

/// Star-shaped: a sphere with radii scattered by `amplitude`; the origin sees every element.
inline Mesh star(int levels, double amplitude, std::uint64_t seed) {
  Mesh mesh = sphere(levels);
  Random random(seed);
  for (auto& p : mesh.nodes) p *= random.uniform(1.0 - amplitude, 1.0);
  return mesh;
}

/// Folded bag: the sphere flattened to a sheet with waves and scattered nodes, so that it intersects itself.
inline Mesh crumpled(int levels, double amplitude, std::uint64_t seed) {
  Mesh mesh = sphere(levels);
  Random random(seed);
  for (auto& p : mesh.nodes) {
    p = Eigen::Vector3d(p[0], p[1], 0.25 * p[2] + 0.3 * std::sin(7.0 * p[0]) * std::cos(3.0 * p[1]));
    p += random.vector(amplitude);
  }
  return mesh;
}

/// Unconnected triangles of the given size in the unit cube.
inline Mesh soup(int count, double size, std::uint64_t seed) {
  Mesh mesh;
  Random random(seed);
  for (int e = 0; e < count; ++e) {
    const Eigen::Vector3d centre = random.vector(1.0);
    for (int i = 0; i < 3; ++i) mesh.nodes.push_back(centre + random.vector(size));
    mesh.elements.push_back({3 * e, 3 * e + 1, 3 * e + 2});
  }
  return mesh;
}

/// Unconnected triangles, degenerate ones among them, with integer coordinates 0 to `size` times 3.
inline Mesh lattice_soup(int count, int size, std::uint64_t seed) {
  Mesh mesh;
  Random random(seed);
  for (int e = 0; e < count; ++e) {
    for (int i = 0; i < 3; ++i) {
      const int x = random.integer(0, size), y = random.integer(0, size), z = random.integer(0, size);
      mesh.nodes.emplace_back(3.0 * x, 3.0 * y, 3.0 * z);
    }
    mesh.elements.push_back({3 * e, 3 * e + 1, 3 * e + 2});
  }
  return mesh;
}

/// Cube [0, 6]^3 of 2 n^2 elements a face with nodes on the lattice, outward: rays meet edges and vertices.
inline Mesh lattice_cube(int n) {
  Mesh mesh;
  const double h = 6.0 / n;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const int offset = static_cast<int>(mesh.nodes.size());
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          Eigen::Vector3d p;
          p[axis] = 6.0 * side;
          p[(axis + 1) % 3] = i * h;
          p[(axis + 2) % 3] = j * h;
          mesh.nodes.push_back(p);
        }
      }
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          const int k = offset + i + j * (n + 1);
          Eigen::Vector3i lower(k, k + 1, k + n + 2), upper(k, k + n + 2, k + n + 1);
          if (side == 0) std::swap(lower[1], lower[2]), std::swap(upper[1], upper[2]);
          mesh.elements.push_back(lower);
          mesh.elements.push_back(upper);
        }
      }
    }
  }
  return mesh;
}

/// Prism over an outline counter-clockwise in x and y, z from 0 to height, its ends cut into the triangles
/// given, outward.
inline Mesh prism(const std::vector<Eigen::Vector2d>& outline, const std::vector<Eigen::Vector3i>& ends,
                  double height) {
  Mesh mesh;
  const int n = static_cast<int>(outline.size());
  for (const double z : {0.0, height})
    for (const auto& p : outline) mesh.nodes.emplace_back(p.x(), p.y(), z);
  for (const auto& t : ends) {
    mesh.elements.emplace_back(t[0], t[2], t[1]);
    mesh.elements.emplace_back(t + Eigen::Vector3i::Constant(n));
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.elements.emplace_back(i, j, j + n);
    mesh.elements.emplace_back(i, j + n, i + n);
  }
  return mesh;
}

/// Nodes at the same place become one, so that a mesh of patches closes.
inline Mesh welded(const Mesh& mesh) {
  Mesh result;
  std::map<std::array<double, 3>, int> index;
  std::vector<int> to;
  for (const auto& p : mesh.nodes) {
    const auto [it, fresh] = index.try_emplace({p[0], p[1], p[2]}, static_cast<int>(result.nodes.size()));
    if (fresh) result.nodes.push_back(p);
    to.push_back(it->second);
  }
  for (const auto& t : mesh.elements) {
    result.elements.push_back({to[static_cast<std::size_t>(t[0])], to[static_cast<std::size_t>(t[1])],
                               to[static_cast<std::size_t>(t[2])]});
  }
  return result;
}

/// Shell of radius 2 with an opaque body of radius 0.7 inside, which faces the gas: the space between has
/// winding 1.
inline Mesh shell_with_body(int levels) {
  Mesh mesh = sphere(levels, 2.0);
  Mesh body = sphere(levels, 0.7);
  flip(body);
  append(mesh, body);
  return mesh;
}

inline Mesh without_top(Mesh mesh, double height) {
  Mesh result;
  result.nodes = mesh.nodes;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.centroid(e)[2] < height) result.elements.push_back(mesh.elements[e]);
  }
  return result;
}

inline Mesh scaled(Mesh mesh, double factor) {
  for (auto& p : mesh.nodes) p *= factor;
  return mesh;
}

}  // namespace scenes
