// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj.hpp"

#include "mesh_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::read_and_write(data, size, mesh::parse_obj, mesh::format_obj);
}
