// SPDX-License-Identifier: Apache-2.0
// LS-DYNA keyword files: what is read, what is refused and where, and bit-exact round trips.
#include "mesh/keyword.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <random>
#include <stdexcept>

#include "mesh/driver_bag.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/passenger_bag.hpp"
#include "same_mesh.hpp"

namespace {

using mesh::Mesh;
using mesh::MeshFileError;
using mesh::parse_keyword;

// Columns of 8 and 16; node 9 belongs to nothing, node 40 comes after the shell that uses it.
const std::string kFixed =
    "*KEYWORD\n"
    "$ a comment, with, commas\n"
    "*TITLE\n"
    "bag, two parts\n"
    "*PART\n"
    "main panel\n"
    "         7         1         1\n"
    "*NODE\n"
    "$    nid               x               y               z\n"
    "      10             0.0             0.0             0.0\n"
    "       9             5.0             5.0             5.0\n"
    "      20           1.0e0             0.0             0.0       0       0\n"
    "      3012.3456789012345             1.0            +0.5\n"
    "*ELEMENT_SHELL\n"
    "       1       7      10      20      30      30\n"
    "       2       8      10      20      40\n"
    "*NODE\n"
    "      40             0.0             1.0             0.0\n"
    "*END\n"
    "what comes after the end is not read\n";

Mesh quad(const std::string& corners) {
  return parse_keyword(
      "*KEYWORD\n*NODE\n1,0,0,0\n2,2,0,0\n3,2,1,0\n4,0.5,1,0\n*ELEMENT_SHELL\n1,1," + corners + "\n*END\n",
      "t");
}

TEST(Keyword, columns_are_read) {
  const Mesh mesh = parse_keyword(kFixed, "t");
  ASSERT_EQ(mesh.node_count(), 4);
  EXPECT_EQ(mesh.nodes(0, 2), 12.3456789012345);  // all 16 columns
  EXPECT_EQ(mesh.nodes(2, 2), 0.5);
  EXPECT_EQ(mesh.nodes(1, 3), 1.0);
  EXPECT_EQ(mesh.elements, (Eigen::Matrix<int, 3, 2>() << 0, 0, 1, 1, 2, 3).finished());
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"main_panel", "part_8"}));
  EXPECT_EQ(mesh.panel, (std::vector<int>{0, 1}));
}

// The same content in other forms: commas, carriage returns, long columns in the file or of one keyword,
// lower case.
TEST(Keyword, every_form_of_a_card_is_the_same_mesh) {
  const std::string commas =
      "*keyword\n*PART\nmain panel\n7,1,1\n*NODE\n10,0,0,0\n 20 , 1, 0 "
      ",0,0,0\n30,12.3456789012345,1,0.5\n40,0,1,0\n"
      "*element_shell\n1,7,10,20,30,30,0,0,0,0\n2,8,10,20,40,0\n*end\n";
  const auto column = [](const std::string& text) { return std::string(20 - text.size(), ' ') + text; };
  std::string nodes, shells;
  for (const auto& [id, x, y, z] : {std::array{"10", "0", "0", "0"},
                                    {"20", "1", "0", "0"},
                                    {"30", "12.3456789012345", "1", "0.5"},
                                    {"40", "0", "1", "0"}})
    nodes += column(id) + column(x) + column(y) + column(z) + "\n";
  for (const auto& ids : {std::array{"1", "7", "10", "20", "30", "30"}, {"2", "8", "10", "20", "40", "40"}}) {
    for (const char* id : ids) shells += column(id);
    shells += "\n";
  }
  const std::string part = "*PART\nmain panel\n" + column("7") + "\n";
  const Mesh mesh = parse_keyword(kFixed, "t");
  std::string returns;
  for (const char c : kFixed) returns += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& text :
       {commas, returns,
        "*KEYWORD LONG=Y\n" + part + "*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells + "*END\n",
        "*KEYWORD\n*PART+\nmain panel\n" + column("7") + "\n*NODE+\n" + nodes + "*ELEMENT_SHELL+\n" + shells +
            "*END\n",
        "*KEYWORD LONG=Y\n*PART-\nmain panel\n         7\n*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells +
            "*END\n"})
    meshes::expect_same_bits(parse_keyword(text, "t"), mesh);
}

TEST(Keyword, quads_are_split_along_the_shorter_diagonal) {
  EXPECT_EQ(quad("1,2,3,4").elements, (Eigen::Matrix<int, 3, 2>() << 1, 1, 2, 3, 3, 0).finished());
  EXPECT_EQ(quad("2,3,4,1").elements, (Eigen::Matrix<int, 3, 2>() << 1, 1, 2, 3, 3, 0).finished());
}

TEST(Keyword, repeated_and_blank_titles_get_the_number) {
  const Mesh mesh = parse_keyword(
      "*KEYWORD\n*PART\nskin\n1,\nskin\n2,\n\n3,\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,"
      "3\n2,2,1,2,3\n3,3,1,2,3\n*END\n",
      "t");
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"skin", "skin_2", "part_3"}));
}

TEST(Keyword, round_trip_keeps_every_bit) {
  Mesh awkward = mesh::icosphere(1.0 / 3.0, 0);
  awkward.nodes.col(0) << 5e-324, -0.0, std::numeric_limits<double>::max();
  awkward.nodes.col(1) << 0.1 + 0.2, -1e-300, -123456789.0 / 7.0;
  for (const Mesh& mesh :
       {awkward, mesh::icosphere(0.31, 2), mesh::passenger_bag().mesh, mesh::driver_bag().mesh})
    meshes::expect_same_bits(parse_keyword(format_keyword(mesh), "memory"), mesh);
}

TEST(Keyword, files_go_by_their_ending) {
  const auto folder = std::filesystem::temp_directory_path();
  const Mesh mesh = mesh::passenger_bag().mesh;
  for (const char* name : {"gasjet_test.k", "gasjet_test.KEY", "gasjet_test.dyn", "gasjet_test.obj"}) {
    mesh::write_mesh(mesh, folder / name);
    meshes::expect_same_bits(mesh::read_mesh(folder / name), mesh);
    std::filesystem::remove(folder / name);
  }
  EXPECT_THROW(mesh::write_mesh(mesh, folder / "gasjet_test.vtk"), MeshFileError);
  EXPECT_THROW(mesh::read_mesh("no/such/file.k"), MeshFileError);
  EXPECT_THROW(mesh::read_mesh(folder), MeshFileError);
  EXPECT_THROW(mesh::write_mesh(mesh, "no/such/folder/bag.k"), MeshFileError);
}

struct Bad {
  const char* name;
  std::string text;
  std::size_t line, column;
  const char* says;
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

TEST(Keyword, blank_coordinates_are_zero_and_exponents_may_be_fortrans) {
  const Mesh mesh = parse_keyword(
      "*KEYWORD\n*NODE\n"
      "       1                           1.0d3                \n"
      "2,1,,0\n3,\t0.1D+1, ,5\n*ELEMENT_SHELL\n1,1,1,2,3\n*END\n",
      "t");
  EXPECT_EQ(mesh.nodes, (Eigen::Matrix3d() << 0, 1, 1, 1000, 0, 0, 0, 0, 5).finished());
}

class bad_keyword : public testing::TestWithParam<Bad> {};

TEST_P(bad_keyword, is_refused) {
  const Bad& bad = GetParam();
  try {
    parse_keyword(bad.text, "bag.k");
    FAIL() << "accepted";
  } catch (const MeshFileError& error) {
    EXPECT_EQ(error.line(), bad.line) << error.what();
    EXPECT_EQ(error.column(), bad.column) << error.what();
    EXPECT_NE(std::string(error.what()).find(bad.says), std::string::npos) << error.what();
  }
}

const std::string kHead = "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n";  // five lines
const std::string kShells = kHead + "*ELEMENT_SHELL\n";                    // six
const Bad kBad[] = {
    {"empty", "", 0, 0, "empty"},
    {"not_a_keyword_file", "hello world\n", 1, 1, "*KEYWORD"},
    {"other_first_keyword", "*NODE\n1,0,0,0\n", 1, 1, "*KEYWORD"},
    {"truncated", kShells + "1,1,1,2,3\n", 0, 0, "*END"},
    {"truncated_in_a_node", "*KEYWORD\n*NODE\n       1             0.0           ", 3, 25, "blank"},
    {"truncated_in_a_shell", kShells + "1,1,1,2", 7, 8, "blank"},
    {"no_elements", kHead + "*END\n", 0, 0, "no elements"},
    {"repeated_node", kHead + "2,1,1,1\n*END\n", 6, 1, "node 2 is repeated; first in line 4"},
    {"missing_node", kShells + "1,1,1,2,5\n*END\n", 7, 9, "node 5"},
    {"not_a_number", kHead + "4,0,x,0\n*END\n", 6, 5, "not a number"},
    {"nan", kHead + "4,0,0,nan\n*END\n", 6, 7, "not finite"},
    {"beyond_double", kHead + "4,1e999,0,0\n*END\n", 6, 3, "range"},
    {"negative_node", kHead + "-4,0,0,0\n*END\n", 6, 1, "above 0"},
    {"negative_element", kShells + "-1,1,1,2,3\n*END\n", 7, 1, "above 0"},
    {"negative_part", kShells + "1,-1,1,2,3\n*END\n", 7, 3, "above 0"},
    {"negative_corner", kShells + "1,1,1,2,-3\n*END\n", 7, 9, "above 0"},
    {"fraction_of_a_node", kShells + "1,1,1,2,3.0\n*END\n", 7, 9, "whole number"},
    {"repeated_element", kShells + "1,1,1,2,3\n1,1,1,3,2\n*END\n", 8, 1, "element 1 is repeated"},
    {"eight_nodes", kShells + "1,1,1,2,3,3,4,5,6,7\n*END\n", 7, 13, "more than 4 nodes"},
    {"repeated_part", "*KEYWORD\n*PART\na\n1,\nb\n1,\n", 6, 1, "part 1 is repeated"},
    {"bad_part", "*KEYWORD\n*PART\na\n         x\n", 4, 10, "whole number"},
    {"include", "*KEYWORD\n*INCLUDE\nother.k\n", 3, 1, "no folder"},
    {"include_transform", "*KEYWORD\n*INCLUDE_TRANSFORM\n", 2, 1, "*INCLUDE_TRANSFORM"},
    {"shell_option", "*KEYWORD\n*ELEMENT_SHELL_COMPOSITE\n", 2, 1, "*ELEMENT_SHELL_COMPOSITE"},
    {"generated_shells", "*KEYWORD\n*ELEMENT_GENERATE_SHELL\n", 2, 1, "*ELEMENT_GENERATE_SHELL"},
    {"tab", "*KEYWORD\n*NODE\n1\t0\t0\t0\n", 3, 2, "a tab"},
    {"tab_before_a_number", "*KEYWORD\n*NODE\n       1\t0.0             0.0\n", 3, 9, "a tab"},
    {"exponent_alone", kHead + "4,1D,0,0\n*END\n", 6, 3, "\"1D\" is not a number"},
    {"node_option", "*KEYWORD\n*NODE_TRANSFORM\n", 2, 1, "*NODE_TRANSFORM"},
    {"other_columns", kHead + "*NODE %\n", 6, 7, "*NODE must be alone on its line"},
    {"shell_columns", kHead + "*ELEMENT_SHELL (i10)\n", 6, 16, "after *ELEMENT_SHELL"},
    {"long_with_blanks", "*KEYWORD LONG = Y\n", 1, 10, "LONG=Y (20 columns)"},
    {"long_ids", "*KEYWORD LONG=K\n", 1, 10, "LONG=K"},
    {"other_width", "*KEYWORD I10=Y\n", 1, 10, "I10="}};
INSTANTIATE_TEST_SUITE_P(files, bad_keyword, testing::ValuesIn(kBad),
                         [](const auto& one) { return std::string(one.param.name); });

// Random damage to a whole file: refused by name or read as a sound mesh, never a crash.
TEST(Keyword, damaged_text_is_refused_or_sound) {
  std::mt19937_64 random(9);
  const std::string alphabet = "0123456789.,-+e* $\nENDPARTNOD";
  int refused = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text = kFixed;
    for (int change = 0; change < 3; ++change)
      text[random() % text.size()] =
          trial % 4 ? alphabet[random() % alphabet.size()] : static_cast<char>(random() % 256);
    try {
      const Mesh mesh = parse_keyword(text, "damaged");
      EXPECT_TRUE(mesh.nodes.allFinite());
      EXPECT_GE(mesh.elements.minCoeff(), 0);
      EXPECT_LT(mesh.elements.maxCoeff(), mesh.node_count());
    } catch (const MeshFileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 400);
}

TEST(Keyword, meshes_that_the_format_cannot_hold_are_refused) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  for (const char* name : {"", "two\nlines", "*END", "$comment"}) {
    mesh.panel_names = {name};
    EXPECT_THROW(mesh::format_keyword(mesh), std::invalid_argument) << name;
  }
  mesh.panel_names = {"sphere"};
  mesh.nodes(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(mesh::format_keyword(mesh), std::invalid_argument);
}

}  // namespace
