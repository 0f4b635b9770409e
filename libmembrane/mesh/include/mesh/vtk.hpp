// SPDX-License-Identifier: Apache-2.0
// Legacy VTK text: polydata and unstructured grids.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads legacy VTK text (versions 1 to 5.1, ASCII) with a DATASET of POLYDATA or UNSTRUCTURED_GRID; lengths
/// are not converted. `name` is the file's name in messages.
/// - Cells are triangles, quads (also pixels) and polygons of 3 or 4 corners. Vertices and lines are skipped.
/// - Panels are the values of the first integer array with one component in CELL_DATA, named `ARRAY_VALUE`;
///   without one there is the panel "default". Arrays with only one value are used last. Identifiers are not
///   used: arrays with more values than half of the cells, and VTK's own (vtkOriginalCellIds, vtkGhostType).
///   Mesh::skipped lists those before the panels.
/// - Nodes that no cell uses are left out.
///
/// Throws MeshFileError, with line and column, for binary files, other datasets and cells, node numbers out
/// of range, counts that disagree and numbers that are not finite.
Mesh parse_vtk(std::string_view text, const std::string& name);

}  // namespace mesh
