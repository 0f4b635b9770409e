// SPDX-License-Identifier: Apache-2.0
// Files of VTK and Gmsh, text and binary: each reader takes any bytes.
#include "mesh/gmsh.hpp"
#include "mesh/vtk.hpp"
#include "mesh_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto parse : {mesh::parse_vtk, mesh::parse_vtk_xml, mesh::parse_gmsh})
    fuzz::read(data, size, parse);
  return 0;
}
