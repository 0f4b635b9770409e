// SPDX-License-Identifier: Apache-2.0
// Any bytes are a mesh, or are refused at their place; a mesh that is read and can be written comes back as
// it was.
#pragma once

#include <optional>

#include "bytes.hpp"
#include "mesh/mesh_file.hpp"

namespace fuzz {

inline bool is_same(const mesh::Mesh& a, const mesh::Mesh& b) {
  return a.nodes == b.nodes && a.elements == b.elements && a.panel.size() == b.panel.size();
}

/// The mesh that the bytes are; none if they are refused.
template <class Parse>
std::optional<mesh::Mesh> read(const std::uint8_t* data, std::size_t size, Parse&& parse) {
  try {
    const mesh::Mesh mesh = parse({reinterpret_cast<const char*>(data), size}, "input");
    require(mesh.element_count() > 0 && mesh.nodes.allFinite(), "a mesh has elements and finite nodes");
    require(mesh.elements.minCoeff() >= 0 && mesh.elements.maxCoeff() < mesh.node_count(),
            "node numbers are in range");
    return mesh;
  } catch (const mesh::MeshFileError& error) {
    require(error.what()[0] != '\0', "a refusal says why");
    return {};
  }
}

template <class Parse, class Format>
int read_and_write(const std::uint8_t* data, std::size_t size, Parse&& parse, Format&& format) {
  const auto mesh = read(data, size, parse);
  if (!mesh) return 0;
  try {
    require(is_same(*mesh, parse(format(*mesh), "written")), "a mesh comes back as it was");
  } catch (const std::invalid_argument&) {
    // a name that the format cannot hold
  }
  return 0;
}

}  // namespace fuzz
