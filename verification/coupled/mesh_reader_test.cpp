// SPDX-License-Identifier: Apache-2.0
// PLY, OFF and binary STL, read with CGAL; every format by its ending.
#include "results/mesh_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "case_folder.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/stl.hpp"
#include "mesh/surface_check.hpp"
#include "run_case.hpp"

namespace {

using coupled::Folder;
using driver::read_any_mesh;
using mesh::Mesh;

Mesh read_text_as(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.path / name, std::ios::binary) << text;
  return read_any_mesh(folder.path / name);
}

// What reading says after the name of the folder; "accepted" if nothing.
std::string refusal(const std::string& name, const std::string& text) {
  const Folder folder;
  try {
    read_text_as(folder, name, text);
  } catch (const mesh::MeshFileError& error) {
    return std::string(error.what()).substr(folder.path.string().size() + 1);
  }
  return "accepted";
}

template <class T>
void append(std::string& bytes, T value, bool swapped = false) {
  std::string part(sizeof value, '\0');
  std::memcpy(part.data(), &value, sizeof value);
  if (swapped) std::reverse(part.begin(), part.end());
  bytes += part;
}

std::string binary_stl(const Mesh& mesh) {
  std::string bytes = "solid of another program";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.element_count()));
  for (int e = 0; e < mesh.element_count(); ++e) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(mesh.nodes(i, mesh.elements(k, e))));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string binary_ply(const Mesh& mesh, bool big_endian) {
  std::string bytes =
      std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
      "_endian 1.0\ncomment a bag\nelement vertex " + std::to_string(mesh.node_count()) +
      "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
      std::to_string(mesh.element_count()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int n = 0; n < mesh.node_count(); ++n) {
    for (int i = 0; i < 3; ++i) append(bytes, mesh.nodes(i, n), big_endian);
    append(bytes, std::uint8_t{10});
  }
  for (int e = 0; e < mesh.element_count(); ++e) {
    append(bytes, std::uint8_t{3});
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<std::int32_t>(mesh.elements(k, e)), big_endian);
  }
  return bytes;
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 5\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
const std::string kOff =
    "OFF\n# a pyramid\n5 5 0\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 "
    "0 4\n";

TEST(mesh_reader, text_of_ply_and_off_is_the_same_pyramid) {
  const Folder folder;
  for (const Mesh& mesh : {read_text_as(folder, "a.ply", kPly), read_text_as(folder, "b.OFF", kOff)}) {
    EXPECT_EQ(mesh.node_count(), 5);
    EXPECT_EQ(mesh.element_count(), 6);
    EXPECT_EQ(mesh.split_quads, 1);
    EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"default"}));
    EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    EXPECT_EQ(mesh::enclosed_volume(mesh.nodes, mesh.elements), 1.0 / 3.0);
  }
}

// A tetrahedron, one edge of which has a node beside it: the element between the two is a sliver.
TEST(mesh_reader, a_case_warns_of_slivers) {
  const auto warnings = [](const char* beside) {
    const Folder folder;
    std::ofstream(folder.path / "a.off")
        << "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        << beside << "3 0 2 1\n3 1 2 4\n3 1 4 3\n3 4 2 3\n3 0 1 3\n3 0 3 2\n";
    const std::string mesh = "membrane.mesh={file=\"" + (folder.path / "a.off").string() + "\"}";
    return coupled::scene_of("sphere_inflation", {mesh}).warnings;
  };
  EXPECT_EQ(warnings("0.4 0.4 0.2\n"), std::vector<std::string>{});
  const auto thin = warnings("0.499995 0.499995 0.00001\n");
  ASSERT_EQ(thin.size(), 1u);
  EXPECT_TRUE(thin[0].starts_with("membrane.mesh: an element has an altitude of 1.2e-05 m")) << thin[0];
}

TEST(mesh_reader, binary_files_keep_every_bit) {
  const Folder folder;
  Mesh mesh = mesh::icosphere(0.3, 2);
  for (const bool big_endian : {false, true}) {
    const Mesh back = read_text_as(folder, "a.ply", binary_ply(mesh, big_endian));
    EXPECT_TRUE(back.nodes == mesh.nodes);
    EXPECT_TRUE(back.elements == mesh.elements);
  }
  mesh.nodes = mesh.nodes.cast<float>().cast<double>();
  const Mesh back = read_text_as(folder, "a.stl", binary_stl(mesh));
  EXPECT_EQ(back.node_count(), mesh.node_count());  // corners of equal coordinates are one node
  ASSERT_EQ(back.element_count(), mesh.element_count());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(back.nodes.col(back.elements(k, e)) == mesh.nodes.col(mesh.elements(k, e)));
}

TEST(mesh_reader, every_ending_has_its_format) {
  const Folder folder;
  const Mesh mesh = mesh::icosphere(0.3, 1);
  for (const char* name : {"a.obj", "a.k", "a.KEY", "a.dyn", "a.stl"}) {
    mesh::write_mesh(mesh, folder.path / name);
    EXPECT_EQ(read_any_mesh(folder.path / name).node_count(), mesh.node_count()) << name;
  }
  EXPECT_EQ(read_text_as(folder, "b.stl", "\xEF\xBB\xBF" + format_stl(mesh)).node_count(), mesh.node_count());
  EXPECT_NE(refusal("a.step", "x")
                .find("a mesh file ends with one of .obj, .k, .key, .dyn, .rad, .stl, .ply, .off"),
            std::string::npos);
  EXPECT_THROW(read_any_mesh(folder.path / "none.ply"), mesh::MeshFileError);
  EXPECT_THROW(read_any_mesh(folder.path), mesh::MeshFileError);
}

TEST(mesh_reader, bad_files_are_refused_with_their_line) {
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const struct {
    const char* name;
    std::string text;
    const char* says;
  } files[] = {
      {"a.ply", "", "a.ply: the file ends before end_header"},
      {"a.ply", "solid", "a.ply:1:1: a PLY file begins with ply"},
      {"a.ply", changed(kPly, "ascii", "utf8"), "a.ply:2:1: the format is not ascii"},
      {"a.ply", changed(kPly, "vertex 5", "vertex 5000000000"), "a.ply:3:1: more items are announced"},
      {"a.ply", changed(kPly, "vertex 5", "vertex"), "a.ply:3:1: the number of elements is missing"},
      {"a.ply", changed(kPly, "element face 5", "element edge 5"),
       "a.ply:9:1: the header has no list vertex_indices of a face"},
      {"a.ply", changed(kPly, "list uchar", "list uint"),
       "a.ply:8:1: the length of a list must be uchar or ushort"},
      {"a.ply", changed(kPly, "property float y\n", ""),
       "a.ply:8:1: the header has no property y of a vertex"},
      {"a.ply", changed(kPly, "float y", "real y"), "a.ply:5:1: type real is not one of PLY"},
      {"a.ply", changed(kPly, "float y", "int y"), "a.ply:9:1: the header has no property y of a vertex"},
      {"a.ply", changed(kPly, "1 0 0\n", "1 none 0\n"), "a.ply:11:1: this is not a number"},
      {"a.ply", kPly.substr(0, kPly.size() - 4),
       "a.ply:19:1: this is not a number or not a vertex of the file, or the file ends"},
      {"a.ply", changed(kPly, "4 0 3 2 1", "4 0 3 2 7"), "a.ply: element 0: node 7 is out of range, 0 to 4"},
      {"a.ply", changed(kPly, "4 0 3 2 1", "4 0 3 2 -1"), "a.ply: element 0: node -1 is out of range"},
      {"a.ply", kPly + "3 0 1 2\n",
       "a.ply:20:1: the header announces element vertex 5, element face 5, but the file continues for 8 "
       "bytes"},
      {"a.ply", changed(kPly, "face 5", "face 4"), "a.ply:19:1: the header announces"},
      {"a.ply", changed(kPly, "face 5", "face 1"), "a.ply:16:1: the header announces"},
      {"a.ply", changed(kPly, "face 5", "face 0"), "a.ply:15:1: the header announces"},
      {"a.ply", changed(kPly, "vertex 5", "vertex 4"), "a.ply:16:1: the header announces"},
      {"a.ply", changed(kPly, "vertex 5", "vertex 6"), "a.ply:"},
      {"a.ply", changed(kPly, "end_header", "element edge 1\nproperty int a\nend_header") + "7\n8\n",
       "a.ply:23:1: the header announces element vertex 5, element face 5, element edge 1, but the file "
       "continues for 2 bytes here; correct the header"},
      {"a.ply", binary_ply(mesh::icosphere(1.0, 0), false) + std::string("\x03\0\0\0\0", 5),
       "a.ply: the header announces element vertex 12, element face 20, but the file continues for 5 bytes; "
       "correct the header"},
      {"a.ply", binary_ply(mesh::icosphere(1.0, 0), true) + std::string(13, '\1'), "for 13 bytes"},
      {"a.ply", changed(kPly, "4 0 3 2 1", "5 0 3 2 1 4"), "a.ply: polygon 0 of 5 corners is not plane"},
      {"a.off", "ply\n", "a.off:1:1: an OFF file begins with OFF"},
      {"a.stl", std::string(50, '\1'), "a.stl: neither STL text, which begins with solid, nor binary"},
      {"a.stl", binary_stl(mesh::icosphere(1.0, 0)).substr(0, 700),
       "a.stl: binary STL announces 20 facets, but has 12 and a part of one"},
  };
  for (const auto& file : files) {
    const std::string message = refusal(file.name, file.text);
    EXPECT_NE(message.find(file.says), std::string::npos) << message << "\nneeded: " << file.says;
  }
  EXPECT_NE(refusal("a.off", kOff.substr(0, kOff.size() - 4)), "accepted");
}

// A number that no float holds, or none at all.
TEST(mesh_reader, binary_stl_with_nan_is_refused) {
  std::string bytes = binary_stl(mesh::icosphere(1.0, 0));
  const auto nan = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN());
  std::memcpy(bytes.data() + 84 + 12, &nan, sizeof nan);
  EXPECT_NE(refusal("a.stl", bytes), "accepted");
}

// Each byte in turn is changed, and each beginning read: refused or read, nothing else.
TEST(mesh_reader, no_damaged_file_crashes) {
  const Folder folder;
  const Mesh sphere = mesh::icosphere(1.0, 0);
  const struct {
    const char* name;
    std::string bytes;
  } files[] = {
      {"a.ply", kPly}, {"b.ply", binary_ply(sphere, false)}, {"a.off", kOff}, {"a.stl", binary_stl(sphere)}};
  for (const auto& file : files) {
    const char* const name = file.name;
    const std::string& bytes = file.bytes;
    int read = 0, refused = 0;
    const auto attempt = [&](const std::string& text) {
      try {
        const Mesh mesh = read_text_as(folder, name, text);
        EXPECT_TRUE(mesh.nodes.allFinite());
        EXPECT_LT(mesh.elements.maxCoeff(), mesh.node_count());
        ++read;
      } catch (const mesh::MeshFileError&) {
        ++refused;
      }
    };
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 100)
      attempt(bytes.substr(0, length));
    for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 100)
      for (const char c : {'9', '-', ' ', '\n', '\0', '\xff'}) {
        std::string changed = bytes;
        changed[i] = c;
        attempt(changed);
      }
    EXPECT_GT(read, 0) << name;
    EXPECT_GT(refused, 0) << name;
  }
}

}  // namespace
