// SPDX-License-Identifier: Apache-2.0
// Decks with a stress-free shape beside their nodes: the design shape is that one, the start the nodes'.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "mesh/keyword.hpp"
#include "mesh/merge.hpp"
#include "mesh/radioss.hpp"

namespace deck_reference {
namespace {

using Eigen::Vector3d;
using mesh::Mesh;
using mesh::MeshFileError;
using Files = std::map<std::string, std::string>;
using Texts = std::vector<std::string>;

Mesh read(const std::string& text, const Files& files = {}) {
  const auto parse = text[0] == '*' ? mesh::parse_keyword : mesh::parse_radioss;
  return parse(text, "run_0000.rad", [&](const std::string& name) {
    if (!files.contains(name)) throw MeshFileError(name, 0, 0, "cannot be opened for reading");
    return files.at(name);
  });
}

// A tetrahedron of 1 m in two parts; the node 9 is no corner.
const std::string kKeyword =
    "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n9,5,5,5\n"
    "*ELEMENT_SHELL\n1,1,1,3,2\n2,1,1,2,4\n3,2,2,3,4\n4,2,1,4,3\n";
const std::string kRadioss =
    "/BEGIN\n/NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n11,0,0,0\n12,2,0,0\n13,0,2,0\n14,0,0,2\n"
    "/SH3N/1\n1,1,3,2\n2,1,2,4\n/SH3N/2\n3,2,3,4\n4,1,4,3\n";

Eigen::Matrix3Xd tetrahedron(double edge) {
  return edge * (Eigen::Matrix<double, 3, 4>() << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished();
}

void expect_twice_as_large(const Mesh& mesh) {
  ASSERT_TRUE(mesh.start.has_value());
  EXPECT_TRUE(mesh.nodes.isApprox(tetrahedron(2.0), 1e-15)) << mesh.nodes;
  EXPECT_EQ(*mesh.start, tetrahedron(1.0));
  EXPECT_EQ(mesh.neglected, Texts{});
}

// Where the shape as cut was lost, the nodes would be both shapes.
TEST(DeckReference, of_a_keyword_file_is_the_design_shape) {
  for (const std::string lists :
       {"*AIRBAG_REFERENCE_GEOMETRY\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n9,7,7,7\n77,1,1,1\n",
        "*airbag_reference_geometry\n4,0,0,2\n3,0,2,0\n*AIRBAG_REFERENCE_GEOMETRY_RDT\n2,2,0,0\n",
        "*AIRBAG_REFERENCE_GEOMETRY_ID\n5,2,2,2,1\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n",
        "*AIRBAG_REFERENCE_GEOMETRY_ID_RDT\n5,,0,2,1\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,1\n",
        "*AIRBAG_REFERENCE_GEOMETRY_RDT_ID\n5,2.0,2.0,2.0\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n",
        "*AIRBAG_REFERENCE_GEOMETRY_BIRTH\n0.\n2,2,0,0\n3,0,2,0\n4,0,0,2\n",
        "*AIRBAG_REFERENCE_GEOMETRY_BIRTH_ID\n\n\n2,2,0,0\n3,0,2,0\n4,0,0,2\n",
        "*AIRBAG_REFERENCE_GEOMETRY\n       2             2.0             0.0             0.0\n"
        "       3                             2.0                \n"
        "       4             0.0             0.0           2.0+0\n",
        "*AIRBAG_REFERENCE_GEOMETRY+\n                   2                 2.0                 0.0           "
        "  "
        "    0.0\n3,0,2,0\n4,0,0,2\n",
        "*NODE\n11,0,0,0\n12,2,0,0\n13,0,2,0\n14,0,0,2\n*AIRBAG_SHELL_REFERENCE_GEOMETRY\n1,1,11,13,12,12\n"
        "2,1,11,12,14\n3,2,12,13,14,14\n4,2,11,14,13,13\n"}) {
    SCOPED_TRACE(lists);
    expect_twice_as_large(read(kKeyword + lists + "*END\n"));
    expect_twice_as_large(read("*KEYWORD\n" + lists + kKeyword.substr(9) + "*END\n"));  // in any order
  }
}

TEST(DeckReference, of_a_radioss_deck_is_the_design_shape) {
  const Files files{{"runRS0", "# of all nodes\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n"},
                    {"ref.sta",
                     "         2                  2.                  0.                  0.\n         3     "
                     "                                 2.                    \n4,0,0,2\n"},
                    {"short",
                     "       2              2.              0.              0.\n"
                     "       3              0.              2.              0.\n"
                     "       4              0.              0.              2.\n"}};
  for (const std::string lists :
       {"/XREF/1\nbag\n       100\n2,2,0,0\n3,0,2,0\n4,0,0,2\n/XREF/2\n\n\n2,2,0,0\n3,0,2,0\n4,0,0,2\n",
        "/XREF/   1\nbag\n       100\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n",  // of part 2 all by part 1
        "/REFSTA\n\n         0\n", "/REFSTA\nref.sta\n         0         0\n", "/REFSTA\nref.sta\n",
        "/REFSTA\nshort\n       100         1\n",
        "/EREF/SH3N/1\nflat\n1,11,13,12\n2,11,12,14\n/EREF/SH3N/2\nflat\n3,12,13,14\n4,11,14,13\n"}) {
    SCOPED_TRACE(lists);
    expect_twice_as_large(read(kRadioss + lists + "/END\n", files));
    expect_twice_as_large(read("/BEGIN\n" + lists + kRadioss.substr(7) + "/END\n", files));
  }
}

TEST(DeckReference, that_is_where_the_nodes_are_is_none) {
  const Mesh mesh = read(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY\n1,0,0,0\n2,1,0,0\n9,8,8,8\n*END\n");
  EXPECT_FALSE(mesh.start.has_value());
  EXPECT_EQ(mesh.nodes, tetrahedron(1.0));
}

// The origin of the scales is a node of the list, its first by default, or one of the deck.
TEST(DeckReference, is_scaled_about_a_node) {
  const auto scaled = [](const char* card) {
    return read(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY_ID\n" + card + "\n2,1,0,0\n3,0,1,0\n*END\n").nodes;
  };
  EXPECT_EQ(scaled("1,2,2,2").col(2), Vector3d(-1, 2, 0));    // about (1, 0, 0)
  EXPECT_EQ(scaled("1,2,2,2,3").col(1), Vector3d(2, -1, 0));  // about (0, 1, 0)
  EXPECT_EQ(scaled("1,3,3,3,4").col(1), Vector3d(3, 0, -2));  // about (0, 0, 1), of the deck
  EXPECT_EQ(scaled("1,2,1,1,4").col(1), Vector3d(2, 0, 0));
}

// Both shapes go the same way through what is done to a mesh.
TEST(DeckReference, stays_beside_the_start) {
  Mesh mesh = read(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY\n2,2,0,0\n3,0,2,0\n4,0,0,2\n*END\n");
  const Mesh part = mesh::only_panels(mesh, {"part_2"}), same = mesh::only_panels(mesh, mesh.panel_names);
  expect_twice_as_large(same);
  EXPECT_EQ(part.node_count(), part.start->cols());
  const Mesh turned = mesh::renumbered(mesh, {3, 2, 1, 0});
  EXPECT_EQ(turned.start->col(0), Vector3d(0, 0, 1));
  EXPECT_EQ(turned.nodes.col(0), Vector3d(0, 0, 2));
  mesh::scale(mesh, 0.5);
  EXPECT_EQ(mesh.nodes, tetrahedron(1.0));
  EXPECT_EQ(*mesh.start, tetrahedron(0.5));
  Mesh two = read(
      "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,1,0,0\n5,0,0,1\n6,0,1,0\n"
      "*AIRBAG_REFERENCE_GEOMETRY\n6,0,3,0\n*ELEMENT_SHELL\n1,1,1,2,3\n2,1,4,5,6\n*END\n");
  EXPECT_EQ(mesh::merge_nodes(two, 1e-6).nodes, 1);  // 2 and 4; 3 and 6 meet at the start alone
  EXPECT_EQ(two.start->cols(), 5);
  EXPECT_EQ(two.start->col(4), Vector3d(0, 1, 0));
}

// What cannot be taken is named, and the shape is that of the nodes.
TEST(DeckReference, of_panels_cut_flat_is_named) {
  for (const std::string& text :
       {kRadioss +
            "/XREF/1\nflat\n\n2,2,0,0\n3,0,2,0\n4,0,0,2\n/XREF/2\nflat\n\n2,2,0,0\n3,0,2,0\n4,1,1,2\n/END\n",
        kRadioss + "/XREF/1\nflat\n\n4,0,0,2\n/XREF/2\nflat\n\n4,1,1,2\n/END\n",
        kRadioss + "/NODE\n15,3,3,2\n/EREF/SH3N/1\nflat\n1,11,13,12\n2,11,12,15\n/EREF/"
                   "SH3N\nflat\n3,12,13,14\n/END\n"}) {
    const Mesh mesh = read(text);
    EXPECT_FALSE(mesh.start.has_value());
    EXPECT_EQ(mesh.nodes, tetrahedron(1.0));
    ASSERT_EQ(mesh.neglected.size(), 1u);
    EXPECT_EQ(mesh.neglected[0],
              "the reference shape, which has node 4 in two places, as for panels cut flat");
  }
}

TEST(DeckReference, of_a_part_without_a_list_is_named) {
  const Mesh mesh = read(kRadioss + "/XREF/2\nhalf\n\n2,2,0,0\n3,0,2,0\n4,0,0,2\n/END\n");
  ASSERT_EQ(mesh.neglected.size(), 1u);
  EXPECT_NE(mesh.neglected[0].find("of part 1"), std::string::npos) << mesh.neglected[0];
}

TEST(DeckReference, what_changes_a_bag_and_is_not_read_is_named) {
  const auto keyword = [](const std::string& text) { return read(kKeyword + text + "*END\n").neglected; };
  EXPECT_EQ(keyword("*PART_MOVE\n1,0.1,0,0\n"), Texts{"*PART_MOVE"});
  EXPECT_EQ(keyword("*INITIAL_STRESS_SHELL\n1,1,1\n"), Texts{"*INITIAL_STRESS_SHELL"});
  EXPECT_EQ(keyword("*AIRBAG_REFERENCE_GEOMETRY_LADDER\n1,1,1\n"),
            Texts{"*AIRBAG_REFERENCE_GEOMETRY_LADDER"});
  EXPECT_EQ(keyword("*AIRBAG_REFERENCE_GEOMETRY_BIRTH\n5e-3\n2,2,0,0\n"),
            Texts{"BIRTH of *AIRBAG_REFERENCE_GEOMETRY, which acts from the start here"});
  EXPECT_EQ(keyword("*AIRBAG_SHELL_REFERENCE_GEOMETRY_ID\n1,2,2,2\n"),
            Texts{"SX, SY and SZ of *AIRBAG_SHELL_REFERENCE_GEOMETRY"});
  EXPECT_EQ(keyword("*MAT_FABRIC\n1,2\n*AIRBAG_HYBRID\n1\n*BOUNDARY_SPC_NODE\n1\n"), Texts{});
  for (const std::string option : {"_THICKNESS", "_BETA", "_MCID"}) {
    const auto shells = [&](const std::string& cards) {
      return keyword("*ELEMENT_SHELL" + option + "\n11,1,1,3,2\n" + cards);
    };
    EXPECT_EQ(shells("0.,0.,0.,0.,90.\n"), Texts{"*ELEMENT_SHELL" + option});
    EXPECT_EQ(shells("1e-3,1e-3,1e-3\n12,1,1,3,2\n1e-3,1e-3,1e-3\n"),
              Texts{"*ELEMENT_SHELL" + option + " (2)"});
    EXPECT_EQ(shells("0.0,0.0,0.,0.\n12,1,1,3,2\n\n"), Texts{}) << option;
  }
  const auto radioss = [](const std::string& text) { return read(kRadioss + text + "/END\n").neglected; };
  EXPECT_EQ(radioss("/INISH3/STRS_F/GLOB\n1\n"), Texts{"/INISH3"});
  EXPECT_EQ(radioss("/INIVEL/TRA/1\nup\n"), Texts{"/INIVEL"});
  EXPECT_EQ(radioss("/SH3N/1\n        11         1         3         2                    90.0\n"),
            Texts{"angles and thicknesses in /SH3N"});
  EXPECT_EQ(radioss("/MAT/FABRI/1\nx\n/BCS/1\nx\n"), Texts{});
}

void expect_refused(const std::string& text, const std::string& says) {
  try {
    read(text);
    FAIL() << "accepted: " << text;
  } catch (const MeshFileError& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(DeckReference, faults_are_told_at_their_place) {
  expect_refused(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY\n2,2,x,0\n*END\n", ":14:5: \"x\" is not a number");
  expect_refused(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY\n2,2\n*END\n", ":14:4: a coordinate is blank");
  expect_refused(kKeyword + "*AIRBAG_REFERENCE_GEOMETRY\nx,2,0,0\n*END\n", ":14:1: the node's number");
  expect_refused(kKeyword + "*AIRBAG_SHELL_REFERENCE_GEOMETRY\n1,1,1,3,22\n*END\n",
                 ":14:9: node 22 is in no list");
  expect_refused(kRadioss + "/XREF/1\nno Nitrs\n         2                  2.                  0.\n/END\n",
                 "the card of Nitrs is missing");
  expect_refused(kRadioss + "/XREF/1/3\nx\n\n2,2,0,0\n/END\n", "units of their own");
  expect_refused(kRadioss + "/XREF\nx\n\n2,2,0,0\n/END\n", "the part's number is blank");
  expect_refused(kRadioss + "/REFSTA\nnone\n\n/END\n", "include: none: cannot be opened");
  expect_refused(kRadioss + "/EREF/SH3N/1\nx\n1,1,3,99\n/END\n", "node 99 is in no list");
}

}  // namespace
}  // namespace deck_reference
