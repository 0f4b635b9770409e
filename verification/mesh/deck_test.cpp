// SPDX-License-Identifier: Apache-2.0
// Whole decks, LS-DYNA and Radioss: files within files, cards that are skipped, parts that are picked.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "mesh/icosphere.hpp"
#include "mesh/keyword.hpp"
#include "mesh/radioss.hpp"
#include "same_mesh.hpp"

namespace {

using mesh::Mesh;
using mesh::MeshFileError;
using Files = std::map<std::string, std::string>;

mesh::IncludedFile folder_of(const Files& files) {
  return [files](const std::string& name) {
    if (!files.contains(name)) throw MeshFileError(name, 0, 0, "cannot be opened for reading");
    return files.at(name);
  };
}

// A triangle of each of two parts, and what no bag is made of.
const std::string kFourNodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n";
const std::string kDeck = "*KEYWORD\n*MAT_FABRIC\n1,2\n*ELEMENT_BEAM\n7,1,1,2\n8,1,2,3\n" + kFourNodes +
                          "*PART\nbag\n1,\nseat\n2,\n*ELEMENT_SHELL\n1,1,1,2,3\n2,2,2,3,4\n*END\n";

const std::string kRadioss =
    "#RADIOSS STARTER\n/BEGIN\ntitle\n      2022         0\n/MAT/FABRI/1\nx\n/NODE\n"
    "         1                  0.                  0.                  0.\n"
    "         2                  1.                  0.                  0.\n"
    "#a comment\n"
    "         3                  0.                  1.                  0.\n"
    "         4                  0.                  0.                  1.\n"
    "/PART/1\nbag\n         1         1         0\n/SH3N/1\n         1         1         2         3\n"
    "/PART/2\nseat\n         1         1         0\n/SHELL/2\n         2         2         3         4       "
    "  4\n"
    "/SPRING/3\n         7         1         2\n         8         2         3\n/END\n";

void expect_deck(const Mesh& mesh, const std::string& element, const std::string& material) {
  EXPECT_EQ(mesh.elements, (Eigen::Matrix<int, 3, 2>() << 0, 1, 1, 2, 2, 3).finished());
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"bag", "seat"}));
  EXPECT_EQ(mesh.other_elements, (std::vector<std::string>{element + " (2)"}));
  EXPECT_EQ(mesh.skipped, (std::vector<std::string>{material}));
}

TEST(Deck, of_a_whole_model_gives_its_shells_and_lists_the_rest) {
  expect_deck(mesh::parse_keyword(kDeck, "t"), "*ELEMENT_BEAM", "*MAT_FABRIC");
  expect_deck(mesh::parse_radioss(kRadioss, "t"), "/SPRING", "/MAT");
}

TEST(Deck, includes_are_read_at_their_place) {
  const Files files{{"nodes.k", kFourNodes + "*END\nnot read\n"}, {"all.k", "*KEYWORD\n*INCLUDE\nnodes.k\n"}};
  const std::string head = "*KEYWORD\n*INCLUDE\n", rest = "*ELEMENT_SHELL\n1,1,1,2,3\n*END\n";
  for (const char* name : {"nodes.k", " all.k "}) {
    const Mesh mesh = mesh::parse_keyword(head + name + "\n" + rest, "t", folder_of(files));
    EXPECT_EQ(mesh.node_count(), 3);
    EXPECT_TRUE(mesh.line.empty());
  }
  EXPECT_EQ(mesh::parse_keyword(head + "empty.k\nnodes.k\n" + rest, "t",
                                folder_of({{"empty.k", "*KEYWORD\n"}, {"nodes.k", kFourNodes}}))
                .node_count(),
            3);
  const auto half = kRadioss.find("/PART/2");
  const Mesh whole = mesh::parse_radioss(kRadioss, "t");
  const Mesh split = mesh::parse_radioss("/BEGIN\n#include half.inc\n" + kRadioss.substr(half), "t",
                                         folder_of({{"half.inc", kRadioss.substr(0, half) + "/END\n"}}));
  EXPECT_EQ(split.nodes, whole.nodes);
  EXPECT_EQ(split.elements, whole.elements);
}

// Each says where, in the file that is at fault.
void expect_refused(const std::string& text, const Files& files, const std::string& says) {
  try {
    const auto parse = text[0] == '*' ? mesh::parse_keyword : mesh::parse_radioss;
    parse(text, "top", folder_of(files));
    FAIL() << "accepted: " << text;
  } catch (const MeshFileError& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(Deck, faults_of_includes_are_told_at_their_place) {
  expect_refused("*KEYWORD\n*INCLUDE\nnone.k\n*END\n", {}, "top:3:1: include: none.k: cannot be opened");
  expect_refused("*KEYWORD\n*INCLUDE\na.k\n*END\n", {{"a.k", "*KEYWORD\n*INCLUDE\na.k\n"}}, "16 nested ones");
  expect_refused("*KEYWORD\n" + kFourNodes + "*INCLUDE\na.k\n*END\n", {{"a.k", "*NODE\n9,0,0,0\n2,0,0,0\n"}},
                 "a.k:3:1: node 2 is repeated; first in line 4 of top");
  expect_refused("*KEYWORD\n*INCLUDE\n*END\n", {}, "top:3:1: the *INCLUDE before it names no file");
  expect_refused("*KEYWORD\n*INCLUDE\na.k\n*END\n", {{"a.k", "words\n"}}, "a.k:1:1: \"words\"");
  expect_refused("/BEGIN\n#include none\n/END\n", {}, "top:2:1: include: none");
  expect_refused("/BEGIN\n#include a\n/END\n", {{"a", "#include a\n"}}, "16 nested ones");
}

TEST(Deck, part_with_options_has_its_title) {
  const std::string shells = kFourNodes + "*ELEMENT_SHELL\n1,1,1,2,3\n2,2,2,3,4\n*END\n";
  const Mesh mesh = mesh::parse_keyword(
      "*KEYWORD\n*PART_INERTIA_CONTACT\nmy bag\n1,\n0,0,0,5\n9,9,9\n*PART_MOVE\n2,1,1,1\n" + shells, "t");
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"my_bag", "part_2"}));
}

TEST(Deck, cards_of_thickness_are_skipped_even_if_blank) {
  const std::string tail = "1,1,1,2,3\n1e-3,1e-3,1e-3\n2,1,2,3,4\n\n*END\n";
  for (const std::string option : {"_THICKNESS", "_BETA", "_THICKNESS_BETA", "_MCID", "_OFFSET"}) {
    const Mesh mesh =
        mesh::parse_keyword("*KEYWORD\n" + kFourNodes + "*ELEMENT_SHELL" + option + "\n" + tail, "t");
    EXPECT_EQ(mesh.element_count(), 2) << option;
    EXPECT_EQ(mesh.skipped, (std::vector<std::string>{"what else is in *ELEMENT_SHELL" + option}));
  }
  const std::string both =
      "*ELEMENT_SHELL_THICKNESS_OFFSET\n1,1,1,2,3\n1,1,1\n0.5\n2,1,2,3,4\n2,2,2\n\n*END\n";
  EXPECT_EQ(mesh::parse_keyword("*KEYWORD\n" + kFourNodes + both, "t").element_count(), 2);
}

// Without it the next shell would be taken for the card.
TEST(Deck, missing_card_of_thickness_is_told) {
  const std::string head = "*KEYWORD\n" + kFourNodes + "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3\n";
  expect_refused(head + "2,1,2,3,4\n1e-3,1e-3,1e-3\n*END\n", {}, "top:9:1: looks like a shell");
  expect_refused(head + "       2       1       2       3       4\n*END\n", {},
                 "top:9:8: looks like a shell");
  expect_refused(head + "*END\n", {}, "top:9:1: the shell before lacks the card");
  for (const char* card : {"2,2,2,2,0", "1,1,1", "               2               2", "0.5,1,2,3,4", ""})
    EXPECT_EQ(mesh::parse_keyword(head + card + "\n*END\n", "t").element_count(), 1) << card;
}

TEST(Deck, names_of_includes_go_on_in_the_next_line) {
  const std::string rest = "*ELEMENT_SHELL\n1,1,1,2,3\n*END\n";
  const Files files{{"folder/of nodes.k", kFourNodes}, {"+", kFourNodes}};
  for (const char* name : {"folder/ +\nof nodes.k", "  fol +\n  der/o +  \nf nodes.k  ", "+"}) {
    const auto text = "*KEYWORD\n*INCLUDE\n" + std::string(name) + "\n" + rest;
    EXPECT_EQ(mesh::parse_keyword(text, "t", folder_of(files)).node_count(), 3) << name;
  }
  expect_refused("*KEYWORD\n*INCLUDE\nfolder/ +\n*END\n", files,
                 "top:4:1: the *INCLUDE before it names no file");
}

TEST(Deck, angle_and_thickness_of_a_radioss_shell_are_listed) {
  const auto skipped = [](const char* tail) {
    std::string text = kRadioss;
    const auto at = text.find("\n", text.find("/SH3N"));
    const auto end = text.find('\n', at + 1);
    std::string card = text.substr(at + 1, end - at - 1);
    card.resize(50, ' ');
    text.replace(at + 1, end - at - 1, card + tail);
    const auto list = mesh::parse_radioss(text, "t").skipped;
    return std::ranges::count(list, "angles and thicknesses in /SH3N");
  };
  EXPECT_EQ(skipped("                 0.0                 1.5"), 1);
  EXPECT_EQ(skipped("                 0.0                 0.0"), 0);
}

TEST(Deck, for_both_programs_has_the_engine_first) {
  const std::string engine = "#RADIOSS\n/RUN/bag/1\n  0.05\n/TFILE\n 1e-4\n/END/ENGINE\n#\n";
  const Mesh one = mesh::parse_radioss(kRadioss, "t");
  for (const auto& text : {engine + kRadioss, kRadioss + "/RUN/bag/1\n0.05\n/END/ENGINE\n"}) {
    const Mesh mesh = mesh::parse_radioss(text, "t");
    meshes::expect_same_bits(mesh, one);
    EXPECT_EQ(mesh.skipped, one.skipped);
  }
  expect_refused(engine, {}, "the file is empty; a Radioss starter deck begins with /BEGIN");
  expect_refused("/RUN/bag/1\n" + kRadioss, {}, "top:1:1: \"/RUN/bag/1\": a Radioss starter deck begins");
}

TEST(Deck, numbers_of_parts_may_have_blanks_before_them) {
  const Mesh one = mesh::parse_radioss(kRadioss, "t");
  for (const char* blanks : {"/   ", " / ", "/\t"}) {
    std::string text = kRadioss;
    for (const char* block : {"/PART", "/SH3N", "/SHELL"})
      for (std::size_t at = 0; (at = text.find(std::string(block) + "/", at)) != text.npos;)
        text.replace(at += std::string(block).size(), 1, blanks);
    meshes::expect_same_bits(mesh::parse_radioss(text, "t"), one);
  }
}

TEST(Deck, exponents_may_be_fortrans) {
  for (const auto& [text, value] : std::map<std::string, double>{{"1.5D2", 150.0},
                                                                 {"1.5+2", 150.0},
                                                                 {"-1.5-3", -1.5e-3},
                                                                 {"+.5d-1", 0.05},
                                                                 {"1.234-101", 1.234e-101},
                                                                 {"1.+0", 1.0}}) {
    const Mesh keyword = mesh::parse_keyword(
        "*KEYWORD\n*NODE\n1,0,0," + text + "\n2,1,0,0\n3,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3\n*END\n", "t");
    EXPECT_EQ(keyword.nodes(2, 0), value) << text;
    const Mesh radioss = mesh::parse_radioss(
        "/BEGIN\n/NODE\n1,0,0," + text + "\n2,1,0,0\n3,0,1,0\n/SH3N/1\n1,1,2,3\n/END\n", "t");
    EXPECT_EQ(radioss.nodes(2, 0), value) << text;
  }
  for (const char* text : {"5-3", "1.5-", "1.5--2", "1.5e3-2", ".-3", "1.5-3.0", "1.2.3-4", "D"})
    expect_refused("*KEYWORD\n*NODE\n1," + std::string(text) + ",0,0\n*END\n", {},
                   "\"" + std::string(text) + "\" is not a number");
}

TEST(Deck, first_line_may_name_a_project) {
  for (const char* head : {"*KEYWORD_ID\n", "*KEYWORD_ID bag 12 LONG\n", "*keyword_jobid run_5\n",
                           "*KEYWORD MEMORY=100M\n", "*KEYWORD_ID\nbag\n*KEYWORD LONG=Y\n"})
    EXPECT_EQ(mesh::parse_keyword(head + kDeck.substr(9), "t").element_count(), 2) << head;
  expect_refused("*KEYWORDS\n*END\n", {}, "a keyword file begins with *KEYWORD");
}

TEST(Deck, faults_of_radioss_are_told_at_their_place) {
  expect_refused("/NODE\n", {}, "top:1:1: \"/NODE\": a Radioss starter deck begins with /BEGIN");
  expect_refused("/BEGIN\n", {}, "top: the file does not end with /END");
  expect_refused("/BEGIN\n/END\n", {}, "top: the file has no elements");
  expect_refused("/BEGIN\n/NODE\n0,0,0,0\n", {}, "top:3:1: the node's number is \"0\"");
  expect_refused("/BEGIN\n/NODE\n         1                  x.\n", {}, "top:3:29: \"x.\" is not a number");
  expect_refused("/BEGIN\n/SH3N/x\n", {}, "top:2:7: the part's number is \"x\"");
  expect_refused("/BEGIN\n/SH3N\n", {}, "the part's number is blank");
  expect_refused("/BEGIN\n/SH3N/1\n         1         1         2         3\n/END\n", {},
                 "top:3:20: node 1 is in no list of nodes");
  expect_refused("/BEGIN\n/PART/1\na\n/PART/1\nb\n", {}, "top:5:1: part 1 is repeated");
  expect_refused("/BEGIN\n/TRANSFORM/TRA/1\n", {}, "top:2:1: \"/TRANSFORM/TRA/1\" is not supported");
  expect_refused("/BEGIN\n//SUBMODEL/1\n", {}, "is not supported: it would change");
  expect_refused("/BEGIN\n/NODE/2\n", {}, "top:2:1: \"/NODE/2\": nodes in units of their own");
  expect_refused("", {}, "top: the file is empty");
}

TEST(Deck, panels_are_picked_with_their_nodes) {
  Mesh mesh = mesh::icosphere(1.0, 1);
  mesh.panel_names = {"a", "b", "c"};
  for (std::size_t e = 0; e < mesh.panel.size(); ++e) mesh.panel[e] = e < 5 ? 0 : e < 7 ? 1 : 2;
  mesh.split_quads = 2;
  mesh.split_polygons = 3;
  mesh.most_corners = 7;
  const Mesh part = mesh::only_panels(mesh, {"c", "a"});
  EXPECT_EQ(part.split_quads, 2);
  EXPECT_EQ(part.split_polygons, 3);
  EXPECT_EQ(part.most_corners, 7);
  EXPECT_EQ(part.panel_names, (std::vector<std::string>{"a", "c"}));
  ASSERT_EQ(part.element_count(), mesh.element_count() - 2);
  EXPECT_EQ(part.elements.maxCoeff(), part.node_count() - 1);
  for (int e = 0; e < part.element_count(); ++e)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(part.nodes.col(part.elements(k, e)), mesh.nodes.col(mesh.elements(k, e < 5 ? e : e + 2)));
  meshes::expect_same_bits(mesh::only_panels(mesh, {"a", "b", "c"}), mesh);
  EXPECT_THROW(mesh::only_panels(mesh, {"d"}), std::invalid_argument);
}

}  // namespace
