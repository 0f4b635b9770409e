// SPDX-License-Identifier: Apache-2.0
// OBJ files: what is read, what is refused and where, and bit-exact round trips.
#include "mesh/obj.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <random>
#include <stdexcept>

#include "mesh/icosphere.hpp"
#include "mesh/passenger_bag.hpp"
#include "same_mesh.hpp"

namespace {

using mesh::Mesh;
using mesh::MeshFileError;
using mesh::parse_obj;

const std::string kNodes = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // four lines

using meshes::expect_same_bits;

TEST(Obj, round_trip_keeps_every_bit) {
  Mesh awkward = mesh::icosphere(1.0 / 3.0, 0);
  awkward.nodes.col(0) << 5e-324, -0.0, std::numeric_limits<double>::max();
  awkward.nodes.col(1) << 0.1 + 0.2, -1e-300, 123456789.0 / 7.0;
  for (const Mesh& mesh : {awkward, mesh::icosphere(0.31, 3), mesh::passenger_bag().mesh})
    expect_same_bits(parse_obj(format_obj(mesh), "memory"), mesh);
}

TEST(Obj, colours_lines_and_names_of_two_words_are_read) {
  const Mesh mesh = parse_obj(
      "v 0 0 0 0.5 0.5 1\nv 1 0 0 1 1 1\nv 1 1 0 0 0 0\nl 1 2\np 3\ng front panel\nf 1 2 3\n", "memory");
  EXPECT_EQ(mesh.node_count(), 3);
  EXPECT_EQ(mesh.element_count(), 1);
  EXPECT_EQ(mesh.panel_names, std::vector<std::string>{"front_panel"});
}

TEST(Obj, round_trip_through_a_file) {
  const auto path = std::filesystem::temp_directory_path() / "gasjet_obj_round_trip_test.obj";
  const Mesh mesh = mesh::passenger_bag().mesh;
  mesh::write_mesh(mesh, path);
  expect_same_bits(mesh::read_mesh(path), mesh);
  std::filesystem::remove(path);
}

TEST(Obj, panels_come_from_groups_and_objects) {
  const Mesh mesh =
      parse_obj(kNodes + "f 1 2 3\no bag\ng front\nf 1 3 4\ng\nf 2 3 4\ng front\nf 1 2 4\n", "t");
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"default", "front"}));
  EXPECT_EQ(mesh.panel, (std::vector<int>{0, 1, 0, 1}));
}

TEST(Obj, index_forms_name_the_same_element) {
  const Eigen::Matrix3Xi expected = parse_obj(kNodes + "f 1 2 3\n", "t").elements;
  for (const char* face :
       {"f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/4/1 2/4/1 3/4/1", "f -4 -3 -2", "f 1 -3 3/9"})
    EXPECT_TRUE(parse_obj(kNodes + face, "t").elements == expected) << face;
}

TEST(Obj, quads_split_along_the_shorter_diagonal) {
  const std::string skewed = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 1 0\n";  // diagonal 2-4 is the shorter
  EXPECT_TRUE(parse_obj(skewed + "f 1 2 3 4", "t").elements ==
              (Eigen::Matrix<int, 3, 2>() << 1, 1, 2, 3, 3, 0).finished());
  EXPECT_TRUE(parse_obj(kNodes + "f 1 2 3 4", "t").elements ==
              (Eigen::Matrix<int, 3, 2>() << 0, 0, 1, 2, 2, 3).finished());
}

TEST(Obj, comments_blanks_and_skipped_statements_are_no_elements) {
  const Mesh mesh = parse_obj(
      "# bag\r\n\r\nmtllib a.mtl\r\nv +0 0 0 1.0#x\r\n  v\t1 0 0\nv 0 1e0 0\nvt 0 0\ns off\nf 1 2 3 # last",
      "t");
  EXPECT_EQ(mesh.node_count(), 3);
  EXPECT_EQ(mesh.element_count(), 1);
}

// Rhino breaks long lines like that.
TEST(Obj, a_backslash_at_the_end_of_a_line_joins_the_next_one) {
  const Mesh whole = parse_obj(kNodes + "g a b\nf 1 2 3\nf 1 3 4\n", "t");
  for (const char* rest :
       {"g a b\nf 1 2 \\\n3\nf 1 3 4\n", "g a b\nf 1\\\n2\\\n3\nf 1 3 4", "g a \\\nb\nf 1 2 3\nf 1 3 4",
        "g a b\r\nf 1 2 \\\r\n 3\r\nf 1 3 4\r\n", "g a b\nf 1 2 \\ \t\n3\nf 1 3 4\n",
        "g a b\nf \\\n1 2 3 # one\nf 1 3 4\n", "g a b\nf 1 2 \\ # two\n3\nf 1 3 4\n",
        "g a b\nf 1 2 \\\n\\\n3\nf 1 3 4\n", "g a b\nf 1//1 2//1 \\\n3//1\nf 1 3 4 \\\n",
        "g a b\nf 1 2 3\n\\\nf 1 3 4\n", "vt 0 \\\n0\ng a b\nf 1 2 3\nf 1 3 4\n"}) {
    const Mesh mesh = parse_obj(kNodes + rest, "t");
    EXPECT_TRUE(mesh.elements == whole.elements) << rest;
    EXPECT_EQ(mesh.panel_names, whole.panel_names) << rest;
  }
  EXPECT_EQ(parse_obj("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n", "t").line, std::vector<int>{5});
}

// A comment may end in a path of Windows.
TEST(Obj, a_backslash_in_a_comment_joins_nothing) {
  EXPECT_EQ(parse_obj("# from C:\\bags\\\n" + kNodes + "f 1 2 3 # \\\nf 1 3 4", "t").node_count(), 4);
}

struct BadFile {
  const char* text;
  std::size_t line, column;
  const char* message;  // part of it
};

TEST(Obj, bad_files_are_refused_with_line_and_column) {
  const BadFile files[] = {
      {"", 0, 0, "no elements"},
      {"v 0 0 0\n", 0, 0, "no elements"},
      {"v 0 0\n", 1, 1, "3 coordinates"},
      {"v 0 0 0 1 1\n", 1, 1, "3 coordinates"},
      {"v 0 nan 0\n", 1, 5, "not finite"},
      {"v 0 0 -inf\n", 1, 7, "not finite"},
      {"v 1e999 0 0\n", 1, 3, "double range"},
      {"v 0 0 1.5m\n", 1, 7, "not a number"},
      {"v 0 0 +-1\n", 1, 7, "not a number"},
      {"v 0,5 0 0\n", 1, 3, "not a number"},
      {"# one\nv 0 0 0\nvertex 1 2 3\n", 3, 1, "not a supported statement"},
      {"v 0 0 0\n  \x01\x02 1\n", 2, 3, "\"??\""},
      {"v 0 0 0\nv 1 0 0\nf 1 2\n", 3, 1, "3 corners or more"},
      {"v 0 0 0\nf -1 1 1 1 1\n", 2, 1, "the polygon of 5 corners encloses no area"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", 4, 7, "out of range"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 -4 2\n", 4, 5, "out of range"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", 4, 3, "index 0"},
      {"v 0 0 \\\n nan\n", 2, 2, "not finite"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\\\n\n", 4, 1, "3 corners or more"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\\\n3 \\\n  4\n", 6, 3, "out of range"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\4\n", 4, 7, "not a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.0\n", 4, 7, "not a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/\n", 4, 7, "not a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3//\n", 4, 7, "not a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/1/1/1\n", 4, 7, "three fields"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", 4, 7, "not a corner"},
      {"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", 1, 3, "out of range"},
  };
  for (const BadFile& file : files) {
    try {
      parse_obj(file.text, "bag.obj");
      ADD_FAILURE() << "accepted: " << file.text;
    } catch (const MeshFileError& error) {
      EXPECT_EQ(error.line(), file.line) << file.text << error.what();
      EXPECT_EQ(error.column(), file.column) << file.text << error.what();
      EXPECT_NE(std::string(error.what()).find(file.message), std::string::npos) << error.what();
      const std::string place =
          file.line ? "bag.obj:" + std::to_string(file.line) + ":" + std::to_string(file.column) + ": "
                    : "bag.obj: ";
      EXPECT_EQ(std::string(error.what()).rfind(place, 0), 0u) << error.what();
    }
  }
}

// Any bytes give a mesh or a MeshFileError; the sanitizer build sees the rest.
TEST(Obj, random_bytes_give_a_mesh_or_an_error) {
  std::mt19937 random(1);
  const std::string alphabet = "vfgo#/-+.0123456789e \n\t\r\\\xff";
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = kNodes + "f 1 2 3\n";
    for (int change = 0; change < 1 + trial % 3; ++change)
      text[random() % text.size()] =
          trial % 4 ? alphabet[random() % alphabet.size()] : static_cast<char>(random() % 256);
    try {
      const Mesh mesh = parse_obj(text, "random");
      EXPECT_TRUE(mesh.nodes.allFinite());
      EXPECT_GE(mesh.elements.minCoeff(), 0);
      EXPECT_LT(mesh.elements.maxCoeff(), mesh.node_count());
    } catch (const MeshFileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Obj, meshes_that_obj_cannot_hold_are_refused) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  mesh.panel_names = {"two words"};
  EXPECT_THROW(mesh::format_obj(mesh), std::invalid_argument);
  mesh.panel_names = {""};
  EXPECT_THROW(mesh::format_obj(mesh), std::invalid_argument);
  mesh = mesh::icosphere(std::numeric_limits<double>::max() / 1e10, 0);
  mesh.nodes(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(mesh::format_obj(mesh), std::invalid_argument);
}

}  // namespace
