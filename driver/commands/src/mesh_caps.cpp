// SPDX-License-Identifier: Apache-2.0
#include "mesh_caps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "base/case_reader.hpp"
#include "engine/bag_holes.hpp"

namespace driver::commands {
namespace {

// NAME or NAME=HOLE.
Cap cap_of(const std::string& text) {
  const auto equals = text.rfind('=');
  if (equals == std::string::npos) return {text, {}};
  int hole = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, hole);
  if (error != std::errc{} || stop != end || equals == 0)
    throw CaseError(fmt::format("--cap {}: allowed: NAME, or NAME=HOLE with the number of a hole", text));
  return {text.substr(0, equals), hole};
}

}  // namespace

void close_holes_of(mesh::Mesh& mesh, const MeshArguments& arguments, std::vector<std::string>& null_panels) {
  if (arguments.caps.empty()) {
    if (arguments.cap_length) throw CaseError("--cap-length needs --cap");
    return;
  }
  std::vector<Cap> caps;
  for (const auto& text : arguments.caps) caps.push_back(cap_of(text));
  try {
    for (const auto& line : close_holes(mesh, caps, arguments.cap_length.value_or(longest_hole)))
      fmt::print("{}\n", line);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("--cap: {}\n{}", error.what(), list_of_holes(mesh)));
  }
  for (const auto& cap : caps)
    if (std::ranges::find(null_panels, cap.panel) == null_panels.end()) null_panels.push_back(cap.panel);
}

}  // namespace driver::commands
