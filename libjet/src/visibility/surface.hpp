// SPDX-License-Identifier: Apache-2.0
// The triangles of one query in the form that the routes read. Nodes are not copied; they have a stride.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jet {

enum class Role : std::uint8_t { fabric, null_panel, attachment, absent };

struct Surface {
  const double* nodes = nullptr;                  // [m] node i at nodes + i * stride
  std::ptrdiff_t stride = 3;                      // [doubles]
  const std::array<int, 3>* triangles = nullptr;  // node indices
  const Role* roles = nullptr;
  int count = 0;
  int node_count = 0;
  const int* names = nullptr;  // the caller's numbers of the nodes; null: the same as here

  const double* node(int i) const { return nodes + i * stride; }
  const double* corner(int element, int i) const {
    return node(triangles[element][static_cast<std::size_t>(i)]);
  }
  int name(int i) const { return names == nullptr ? i : names[i]; }
  bool never_blocks(int element) const { return roles[element] != Role::fabric; }
  bool absent(int element) const { return roles[element] == Role::absent; }
};

}  // namespace jet
