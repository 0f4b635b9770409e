// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "mesh/mesh.hpp"

namespace meshes {

using mesh::Mesh;

inline void expect_same_bits(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  EXPECT_EQ(
      std::memcmp(a.nodes.data(), b.nodes.data(), sizeof(double) * static_cast<std::size_t>(a.nodes.size())),
      0);
  EXPECT_TRUE(a.elements == b.elements);
  EXPECT_EQ(a.panel, b.panel);
  EXPECT_EQ(a.panel_names, b.panel_names);
}

}  // namespace meshes
