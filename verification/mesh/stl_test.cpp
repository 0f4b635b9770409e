// SPDX-License-Identifier: Apache-2.0
// STL text: what is read, what is refused and where, and round trips.
#include "mesh/stl.hpp"

#include <algorithm>
#include <cctype>

#include "bad_text.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/surface_check.hpp"

namespace stl {
namespace {

using mesh::Mesh;
using mesh::parse_stl;
using meshes::replaced;

std::string facet(const char* a, const char* b, const char* c) {
  const auto vertex = [](const char* x) { return std::string("      vertex ") + x + "\n"; };
  return "  facet normal 0 0 1\n    outer loop\n" + vertex(a) + vertex(b) + vertex(c) +
         "    endloop\n  endfacet\n";
}

// The tetrahedron of (0,0,0) and the unit vectors, in two solids.
const std::string kTetrahedron = "solid the bag\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                                 facet("0 0 -0", "1 0 0", "0 0 1e0") + "endsolid the bag\nsolid\n" +
                                 facet("1 0 0", "0 1 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0") +
                                 "endsolid\n";

TEST(Stl, equal_corners_are_one_node_and_solids_are_panels) {
  const Mesh mesh = parse_stl(kTetrahedron, "bag");
  EXPECT_EQ(mesh.node_count(), 4);
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"the_bag", "default"}));
  EXPECT_EQ(mesh.panel, (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(mesh.line, (std::vector<int>{2, 9, 18, 25}));
  EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
  EXPECT_EQ(mesh::enclosed_volume(mesh.nodes, mesh.elements), 1.0 / 6.0);
}

TEST(Stl, carriage_returns_and_normals_that_are_no_numbers_are_read) {
  std::string text = replaced(kTetrahedron, "normal 0 0 1", "normal nan nan nan");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\r\n");
  EXPECT_EQ(parse_stl(text, "bag").element_count(), 4);
}

// Panels change the order of the elements; nodes come in the order of the elements.
TEST(Stl, round_trip_keeps_triangles_and_panels) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  const Mesh back = parse_stl(format_stl(mesh), "memory");
  ASSERT_EQ(back.element_count(), mesh.element_count());
  EXPECT_EQ(back.node_count(), mesh.node_count());
  EXPECT_EQ(back.panel_names, mesh.panel_names);
  for (const std::string& panel : mesh.panel_names) {
    const auto a = mesh::panel_elements(mesh, panel), b = mesh::panel_elements(back, panel);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_TRUE(mesh.nodes.col(mesh.elements(k, a[i])) == back.nodes.col(back.elements(k, b[i])));
  }
}

TEST(Stl, binary_files_are_told_from_text) {
  EXPECT_TRUE(mesh::is_stl_text(kTetrahedron));
  EXPECT_FALSE(mesh::is_stl_text(std::string(84, '\0')));
  std::string binary = "solid by some program";
  binary.resize(84, '\0');
  EXPECT_FALSE(mesh::is_stl_text(binary));  // no facet, as it says
}

TEST(Stl, capitals_are_read) {
  const Mesh small = parse_stl(kTetrahedron, "bag");
  std::string capitals = kTetrahedron, mixed = kTetrahedron;
  for (std::size_t i = 0; i < capitals.size(); ++i) {
    const auto c = static_cast<unsigned char>(capitals[i]);
    capitals[i] = static_cast<char>(std::toupper(c));
    if (i % 3 == 0) mixed[i] = capitals[i];
  }
  for (const std::string& text : {capitals, mixed, replaced(kTetrahedron, "solid the", "Solid the"),
                                  replaced(kTetrahedron, "endloop", "EndLoop"), "\n  " + capitals}) {
    EXPECT_TRUE(mesh::is_stl_text(text));
    const Mesh mesh = parse_stl(text, "bag");
    EXPECT_TRUE(mesh.nodes == small.nodes);
    EXPECT_TRUE(mesh.elements == small.elements);
  }
  EXPECT_EQ(parse_stl(capitals, "bag").panel_names, (std::vector<std::string>{"THE_BAG", "default"}));
  meshes::expect_refused(
      parse_stl, {{replaced(capitals, "VERTEX 0 1 0", "VERTEX 0 ONE 0"), "bag:5:16: a coordinate: \"ONE\""},
                  {replaced(capitals, "    ENDLOOP", "      VERTEX 7 7 7\n    ENDLOOP"),
                   "bag:7:7: a facet has three corners"}});
}

TEST(Stl, bad_files_are_refused_with_line_and_column) {
  const std::string& good = kTetrahedron;
  meshes::expect_refused(
      parse_stl,
      {{"", "bag: the file has no facets"},
       {"solid a\nendsolid a\n", "bag: the file has no facets"},
       {"facet", "bag:1:1: \"facet\" stands where solid is needed"},
       {replaced(good, "facet normal", "face normal"),
        "bag:2:3: \"face\" is found instead of facet or endsolid"},
       {replaced(good, "vertex 0 1 0", "vertex 0 one 0"), "bag:5:16: a coordinate: \"one\" is not a number"},
       {replaced(good, "vertex 0 1 0", "vertex 0 inf 0"), "bag:5:16: a coordinate: \"inf\" is not finite"},
       {replaced(good, "vertex 0 1 0", "vertex 0 1e999 0"),
        "bag:5:16: a coordinate: \"1e999\" is beyond double range"},
       {replaced(good, "outer loop", "outer lop"), "bag:3:11: \"lop\" stands where loop is needed"},
       {replaced(good, "    endloop", "      vertex 7 7 7\n    endloop"),
        "bag:7:7: a facet has three corners"},
       {good.substr(0, good.size() - 9), "the file ends here"}});
}

TEST(Stl, no_damaged_file_crashes) {
  meshes::expect_no_crash(parse_stl, kTetrahedron);
}

TEST(Stl, what_the_format_cannot_hold_is_refused) {
  Mesh mesh = parse_stl(kTetrahedron, "bag");
  mesh.panel_names[0] = "two words";
  EXPECT_THROW(format_stl(mesh), std::invalid_argument);
  mesh.panel_names[0] = "one";
  mesh.nodes(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(format_stl(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace stl
