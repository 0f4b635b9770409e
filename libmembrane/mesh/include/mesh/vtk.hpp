// SPDX-License-Identifier: Apache-2.0
// VTK files: polydata and unstructured grids, legacy and XML.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads a legacy VTK file (versions 1 to 5.1, ASCII or BINARY) with a DATASET of POLYDATA or
/// UNSTRUCTURED_GRID; lengths are not converted. `name` is the file's name in messages.
/// - Cells are triangles, quads (also pixels), triangle strips and polygons, split as by mesh_of_polygons.
///   Vertices and lines are skipped.
/// - Panels are the values of the first integer array with one component in CELL_DATA, named `ARRAY_VALUE`;
///   without one there is the panel "default". Arrays with only one value are used last. Identifiers are not
///   used: arrays with more values than half of the cells, and VTK's own (vtkOriginalCellIds, vtkGhostType).
///   Mesh::skipped lists those before the panels.
/// - Nodes that no cell uses are left out.
///
/// Throws MeshFileError, with line and column or byte, for other datasets and cells, node numbers out of
/// range, counts that disagree and numbers that are not finite.
Mesh parse_vtk(std::string_view text, const std::string& name);

/// Reads an XML file of VTK, PolyData (.vtp) or UnstructuredGrid (.vtu), in the same way: arrays as text, in
/// base64, or appended, raw or in base64; plain or compressed by zlib; in either order of bytes. All pieces
/// are one mesh; an integer array that all of them have names the panels. Mesh::line is empty.
///
/// Throws MeshFileError as parse_vtk does, and for other compressors (LZ4, LZMA).
Mesh parse_vtk_xml(std::string_view text, const std::string& name);

}  // namespace mesh
