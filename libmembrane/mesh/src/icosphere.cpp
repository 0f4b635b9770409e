// SPDX-License-Identifier: Apache-2.0
#include "mesh/icosphere.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "checks.hpp"
#include "mesh/refine.hpp"

namespace mesh {
namespace {

constexpr int kMaxLevels = 9;  // 5.2 million elements

Mesh icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Mesh mesh;
  mesh.nodes.resize(3, 12);
  mesh.nodes << -1, 1, -1, 1, 0, 0, 0, 0, g, g, -g, -g,  //
      g, g, -g, -g, -1, 1, -1, 1, 0, 0, 0, 0,            //
      0, 0, 0, 0, g, g, -g, -g, -1, 1, -1, 1;
  mesh.nodes.colwise().normalize();
  mesh.elements.resize(3, 20);
  mesh.elements << 0, 0, 0, 0, 0, 1, 5, 11, 10, 7, 3, 3, 3, 3, 3, 4, 2, 6, 8, 9,  //
      11, 5, 1, 7, 10, 5, 11, 10, 7, 1, 9, 4, 2, 6, 8, 9, 4, 2, 6, 8,             //
      5, 1, 7, 10, 11, 9, 4, 2, 6, 8, 4, 2, 6, 8, 9, 5, 11, 10, 7, 1;
  mesh.panel.assign(20, 0);
  mesh.panel_names = {"sphere"};
  return mesh;
}

Mesh refined_on_unit_sphere(const Mesh& coarse) {
  Mesh fine = refine(coarse);
  for (int i = coarse.node_count(); i < fine.node_count(); ++i) fine.nodes.col(i).normalize();
  return fine;
}

}  // namespace

Mesh icosphere(double radius, int levels) {
  require_positive("mesh", "radius", radius);
  if (levels < 0 || levels > kMaxLevels)
    throw std::invalid_argument("levels: " + std::to_string(levels) + "; must be 0 to " +
                                std::to_string(kMaxLevels));
  Mesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level) mesh = refined_on_unit_sphere(mesh);
  mesh.nodes *= radius;
  return mesh;
}

Mesh rectangle(int nx, int ny, double width, double height, Diagonals diagonals) {
  require_positive("mesh", "nx", nx);
  require_positive("mesh", "ny", ny);
  require_positive("mesh", "width", width);
  require_positive("mesh", "height", height);
  if (2.0 * nx * ny > kMostElements || (nx + 1.0) * (ny + 1.0) > kMostElements)
    reject("mesh", "nx ny", static_cast<double>(nx) * ny,
           "at most " + std::to_string(kMostElements / 2) + " cells");
  if (diagonals != Diagonals::uniform && diagonals != Diagonals::union_jack)
    throw std::invalid_argument("mesh: diagonals: no such enumerator");
  Mesh mesh;
  mesh.nodes.resize(3, (nx + 1) * (ny + 1));
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.nodes.col(i + j * (nx + 1)) << i * width / nx, j * height / ny, 0.0;
  mesh.elements.resize(3, 2 * nx * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = i + j * (nx + 1), b = a + 1, c = b + nx + 1, d = a + nx + 1;
      auto cell = mesh.elements.middleCols(2 * (i + j * nx), 2);
      if (diagonals == Diagonals::uniform || (i + j) % 2 == 0)
        cell << a, a, b, c, c, d;
      else
        cell << a, b, b, c, d, d;
    }
  mesh.panel.assign(static_cast<std::size_t>(mesh.element_count()), 0);
  mesh.panel_names = {"sheet"};
  return mesh;
}

}  // namespace mesh
