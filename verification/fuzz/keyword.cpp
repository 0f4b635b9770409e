// SPDX-License-Identifier: Apache-2.0
#include "mesh/keyword.hpp"

#include "mesh_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto parse = [](std::string_view text, const char* name) { return mesh::parse_keyword(text, name); };
  return fuzz::read_and_write(data, size, parse, mesh::format_keyword);
}
