// SPDX-License-Identifier: Apache-2.0
// The mesh of a bag from files: its shape as cut and its shape at the start.
#pragma once

#include "base/case_reader.hpp"
#include "engine/bag_mesh.hpp"
#include "engine/scene.hpp"
#include "mesh/surface_check.hpp"

namespace driver {

/// Whether the surface encloses a volume. Sheets that lie on each other enclose none before they are folded;
/// of a sheet alone, an open edge is none of its faults.
enum class Closed { needed, before_folds, free };

/// Faults of a surface that is to be as `closed` says.
mesh::SurfaceReport surface_report(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements,
                                   Closed closed);

/// [membrane.mesh] with `file`. A deck with a stress-free shape beside its nodes has both shapes;
/// `initial_file` has the shape at the start for every format. Adds warnings to the scene.
BagMesh mesh_of_files(TableReader& table, const MeshReader& read_mesh, Closed closed, Scene& scene);

}  // namespace driver
