// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh_file.hpp"

namespace meshes {

using Parser = mesh::Mesh (*)(std::string_view, const std::string&);

// A file that is refused, and what the message holds: place and reason.
struct BadText {
  std::string text;
  std::string says;
};

inline void expect_refused(Parser parse, const std::vector<BadText>& files) {
  for (const BadText& file : files) {
    try {
      parse(file.text, "bag");
      ADD_FAILURE() << "accepted: " << file.text;
    } catch (const mesh::MeshFileError& error) {
      EXPECT_NE(std::string(error.what()).find(file.says), std::string::npos)
          << error.what() << "\nneeded: " << file.says;
    }
  }
}

// Every beginning of a good text is refused or read, and so is the text with one character changed: nothing
// else happens.
inline void expect_no_crash(Parser parse, const std::string& text) {
  int read = 0, refused = 0;
  const auto attempt = [&](const std::string& one) {
    try {
      const mesh::Mesh mesh = parse(one, "bag");
      EXPECT_GT(mesh.element_count(), 0);
      EXPECT_LT(mesh.elements.maxCoeff(), mesh.node_count());
      EXPECT_GE(mesh.elements.minCoeff(), 0);
      EXPECT_TRUE(mesh.nodes.allFinite());
      ++read;
    } catch (const mesh::MeshFileError&) {
      ++refused;
    }
  };
  for (std::size_t length = 0; length < text.size(); ++length) attempt(text.substr(0, length));
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const char c : {'9', '-', 'x', ' ', '\n', '\0'}) {
      std::string changed = text;
      changed[i] = c;
      attempt(changed);
    }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

// The text with `from` replaced by `to`, once.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace meshes
