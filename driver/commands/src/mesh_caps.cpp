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

// NAME, NAME=HOLE or NAME=SET.
Cap cap_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return {text, {}};
  const std::string panel = text.substr(0, equals), which = text.substr(equals + 1);
  if (panel.empty() || which.empty())
    throw CaseError(fmt::format(
        "--cap {}: allowed: NAME, or NAME= with the number of a hole or the name of a node set", text));
  int hole = 0;
  const char* end = which.data() + which.size();
  const auto [stop, error] = std::from_chars(which.data(), end, hole);
  if (error == std::errc{} && stop == end) return {panel, hole};
  return {panel, {}, which};
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
    const std::string list = list_of_holes(mesh);
    throw CaseError(fmt::format("--cap: {}{}{}", error.what(), list.empty() ? "" : "\n", list));
  }
  for (const auto& cap : caps)
    if (std::ranges::find(null_panels, cap.panel) == null_panels.end()) null_panels.push_back(cap.panel);
}

}  // namespace driver::commands
