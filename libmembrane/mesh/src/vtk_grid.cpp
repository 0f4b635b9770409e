// SPDX-License-Identifier: Apache-2.0
#include "vtk_grid.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "mesh/merge.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh_builder.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

// Meaning of an array of the cells: panels, or identifiers of cells, which VTK's filters leave behind.
enum class Meaning { panels, one_panel, identifiers };

// True for cells without area, which are skipped.
bool is_skipped(const VtkCell& cell) {
  return cell.type >= 0 && cell.type <= 4;
}

Meaning meaning_of(const VtkArray& array, const std::vector<VtkCell>& cells) {
  if (array.name.starts_with("vtkOriginal") || array.name.starts_with("vtkGhost"))
    return Meaning::identifiers;
  std::unordered_set<long long> values;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_skipped(cells[i])) continue;
    values.insert(array.values[i]);
    ++count;
  }
  if (values.size() == 1) return Meaning::one_panel;
  return 2 * values.size() > count ? Meaning::identifiers : Meaning::panels;
}

// The first array with several panels, otherwise the first with one panel; null if there is neither.
const VtkArray* panel_array(const VtkGrid& grid, std::vector<std::string>& identifiers) {
  const VtkArray* one = nullptr;
  for (const VtkArray& array : grid.arrays) {
    const Meaning meaning = meaning_of(array, grid.cells);
    if (meaning == Meaning::panels) return &array;
    if (meaning == Meaning::identifiers) identifiers.push_back("cell array " + array.name);
    if (meaning == Meaning::one_panel && !one) one = &array;
  }
  return one;
}

[[noreturn]] void fail(const VtkGrid& grid, std::size_t cell, const std::string& message) {
  const VtkCell& at = grid.cells[cell];
  const std::string which = at.line_number == 0 ? "cell " + std::to_string(cell) + ": " : "";
  throw MeshFileError(grid.file, at.line_number, at.column, which + message);
}

void check(const VtkGrid& grid, std::size_t index) {
  const VtkCell& cell = grid.cells[index];
  const std::size_t corners = cell.nodes.size();
  if (cell.type < 5 || cell.type > 9)
    fail(grid, index,
         "cell type " + std::to_string(cell.type) +
             " is not supported; allowed: 5 triangle, 6 triangle strip, 7 polygon, 8 pixel, 9 quad "
             "(0 to 4 are skipped)");
  if (corners < 3) fail(grid, index, "a cell of " + std::to_string(corners) + " corners, allowed: 3 or more");
  if ((cell.type == 5 && corners != 3) || (cell.type >= 8 && corners != 4))
    fail(grid, index,
         "cell type " + std::to_string(cell.type) + " with " + std::to_string(corners) + " corners");
}

void add(MeshBuilder& mesh, const VtkCell& cell, const std::string& panel) {
  std::vector<int> corners(cell.nodes.begin(), cell.nodes.end());
  if (cell.type == 8) std::swap(corners[2], corners[3]);
  if (cell.type != VtkCell::strip) return mesh.add_polygon(corners, panel, cell.line_number);
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    std::array<int, 3> triangle = {corners[i], corners[i + 1], corners[i + 2]};
    if (i % 2 == 1) std::swap(triangle[0], triangle[1]);  // every second one is run the other way
    mesh.add_polygon(triangle, panel, cell.line_number);
  }
}

}  // namespace

Mesh mesh_of_grid(const VtkGrid& grid) {
  if (grid.cells.empty()) throw MeshFileError(grid.file, 0, 0, "the file has no cells");
  std::vector<std::string> identifiers;
  const VtkArray* array = panel_array(grid, identifiers);
  MeshBuilder mesh;
  for (const Eigen::Vector3d& x : grid.points) mesh.add_node(x);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (is_skipped(grid.cells[i])) continue;
    check(grid, i);
    add(mesh, grid.cells[i], array ? array->name + "_" + std::to_string(array->values[i]) : "default");
  }
  if (mesh.empty()) throw MeshFileError(grid.file, 0, 0, "the file has no cells with an area");
  Mesh result = used_nodes(std::move(mesh).finish(grid.file));
  result.skipped = std::move(identifiers);
  return result;
}

}  // namespace mesh
