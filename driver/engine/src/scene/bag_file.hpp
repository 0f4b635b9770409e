// SPDX-License-Identifier: Apache-2.0
// The mesh of a bag from files: its shape as cut and its shape at the start.
#pragma once

#include "base/case_reader.hpp"
#include "engine/bag_mesh.hpp"
#include "engine/scene.hpp"
#include "mesh/surface_check.hpp"

namespace driver {

/// What the surface of a mesh needs. A sheet need not be closed; layers that lie on each other enclose no
/// volume before they are folded.
struct Needs {
  bool closed, volume;
};

/// Faults of a surface that needs this.
mesh::SurfaceReport surface_report(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements,
                                   const Needs& needs);

/// [membrane.mesh] with `file`. A deck with a stress-free shape beside its nodes has both shapes;
/// `initial_file` has the shape at the start for every format. Adds warnings to the scene.
BagMesh mesh_of_files(TableReader& table, const MeshReader& read_mesh, const Needs& needs, Scene& scene);

}  // namespace driver
