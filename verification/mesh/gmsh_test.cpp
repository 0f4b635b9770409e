// SPDX-License-Identifier: Apache-2.0
// Gmsh text of both versions: what is read, what is refused and where.
#include "mesh/gmsh.hpp"

#include "bad_text.hpp"
#include "mesh/surface_check.hpp"

namespace gmsh {
namespace {

using mesh::Mesh;
using mesh::parse_gmsh;
using meshes::replaced;

// A wedge: two triangles and three quads. Node 40 is that of a point alone.
const std::string kOld =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 5 \"rim\"\n2 7 \"front panel\"\n$EndPhysicalNames\n"
    "$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 0 1 0\n11 0 0 2\n12 1 0 2\n13 0 1 2\n40 5 5 5\n$EndNodes\n"
    "$Elements\n7\n1 15 2 0 1 40\n2 1 2 5 1 1 2\n3 2 2 7 1 1 3 2\n4 2 2 7 2 11 12 13\n"
    "5 3 2 9 3 1 2 12 11\n6 3 2 9 4 2 3 13 12\n7 3 2 0 5 3 1 11 13\n$EndElements\n";

const std::string kNew =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n1\n2 7 \"front panel\"\n$EndPhysicalNames\n"
    "$Comments\nanything $ at all\n$EndComments\n"
    "$Entities\n1 1 5 0\n1 5 5 5 0\n1 0 0 0 1 0 0 0 2 1 -1\n"
    "1 0 0 0 1 1 0 1 7 0\n2 0 0 2 1 1 2 1 -7 3 1 2 3\n3 0 0 0 1 0 2 1 9 0\n4 0 0 0 1 1 2 1 9 0\n"
    "5 0 0 0 0 1 2 0 0\n$EndEntities\n"
    "$Nodes\n3 7 1 40\n0 1 0 1\n40\n5 5 5\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n"
    "2 2 1 3\n11\n12\n13\n0 0 2 0.5 0.5\n1 0 2 1 0\n0 1 2 0 1\n$EndNodes\n"
    "$Elements\n7 7 1 7\n0 1 15 1\n1 40\n1 1 1 1\n2 1 2\n2 1 2 1\n3 1 3 2\n2 2 2 1\n4 11 12 13\n"
    "2 3 3 1\n5 1 2 12 11\n2 4 3 1\n6 2 3 13 12\n2 5 3 1\n7 3 1 11 13\n$EndElements\n";

TEST(Gmsh, both_versions_are_the_same_wedge_with_groups_as_panels) {
  for (const std::string* text : {&kOld, &kNew}) {
    const Mesh mesh = parse_gmsh(*text, "bag");
    EXPECT_EQ(mesh.element_count(), 8);
    EXPECT_EQ(mesh.split_quads, 3);
    EXPECT_EQ(mesh.node_count(), 6);
    EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"front_panel", "physical_9", "surface_5"}));
    EXPECT_EQ(mesh.panel, (std::vector<int>{0, 0, 1, 1, 1, 1, 2, 2}));
    EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    EXPECT_EQ(mesh::enclosed_volume(mesh.nodes, mesh.elements), 1.0);
  }
  EXPECT_TRUE(parse_gmsh(kOld, "a").nodes == parse_gmsh(kNew, "b").nodes);
  EXPECT_TRUE(parse_gmsh(kOld, "a").elements == parse_gmsh(kNew, "b").elements);
  EXPECT_EQ(parse_gmsh(kOld, "a").line.front(), 23);
}

TEST(Gmsh, bad_files_are_refused_with_line_and_column) {
  meshes::expect_refused(
      parse_gmsh,
      {{"", "bag:1:1: the file ends here"},
       {"v 0 0 0\n", "bag:1:1: \"v\" stands where $MeshFormat is needed"},
       {replaced(kOld, "2.2 0 8", "1.0 0 8"),
        "bag:2:1: version \"1.0\" is not supported; allowed: 2.2 and 4.1"},
       {replaced(kOld, "2.2 0 8", "2.2 1 8"), "bag: at byte 24: the number 1, which says the order of bytes"},
       {replaced(kOld, "$Nodes", "$ParametricNodes"),
        "bag:9:1: nodes with parameters; write the file without"},
       {replaced(kOld, "\"front panel\"", "front"), "bag:7:5: \"front\" is not a name in quotes"},
       {replaced(kOld, "12 1 0 2", "11 1 0 2"), "bag:15:1: node 11 is repeated"},
       {replaced(kOld, "12 1 0 2", "12 1 zero 2"), "bag:15:6: y: \"zero\" is not a number"},
       {replaced(kOld, "12 1 0 2", "12 1 -inf 2"), "bag:15:6: y: \"-inf\" is not finite"},
       {replaced(kOld, "$Nodes\n7", "$Nodes\n8"), "bag:18:1: the node's number is \"$EndNodes\""},
       {replaced(kOld, "$Nodes\n7", "$Nodes\n6"), "bag:17:1: \"40\" stands where $EndNodes is needed"},
       {replaced(kOld, "$Nodes\n7", "$Nodes\n77777777777"),
        "bag:10:1: the number of nodes is \"77777777777\""},
       {replaced(kOld, "1 2 12 11", "1 2 14 11"), "bag:25:15: node 14 is not in $Nodes"},
       {replaced(kOld, "3 2 2 7 1", "3 4 2 7 1"), "bag:23:3: element type 4 is not supported"},
       {replaced(kOld, "3 2 2 7 1", "3 9 2 7 1"), "bag:23:3: element type 9 is not supported"},
       {replaced(kNew, "3 7 1 40", "3 8 1 40"), "7 nodes, not the 8 announced"},
       {replaced(kNew, "7 7 1 7", "7 9 1 7"), "7 elements, not the 9 announced"},
       {replaced(kNew, "$EndEntities", "$EndElements"),
        "\"$EndElements\" stands where $EndEntities is needed"},
       {kOld.substr(0, kOld.find("$Elements")), "bag: the file has no triangles and no quads"},
       {kNew.substr(0, kNew.size() - 14), "$EndElements is missing"}});
}

// A panel is one group. Version 2 has an element once for each of its groups, version 4 a list of groups.
TEST(Gmsh, a_surface_in_two_groups_is_refused_in_both_versions) {
  const std::string says = "two physical groups, front_panel and physical_9; remove it from one of them";
  const auto twice = [](const std::string& element) {
    return replaced(replaced(kOld, "$Elements\n7", "$Elements\n8"), "$EndElements",
                    element + "\n$EndElements");
  };
  const std::string again = "bag:28:1: the element of line 24 is repeated because it is in ";
  meshes::expect_refused(parse_gmsh,
                         {{twice("8 2 2 9 2 11 12 13"), again + says},
                          {twice("4 2 2 9 2 11 12 13"), again + says},      // of the same number
                          {twice("8 2 2 9 2 12 13 11"), again + says},      // from another corner
                          {twice("8 2 2 9 2 13 12 11"), again + says},      // wound the other way
                          {twice("8 2 4 9 2 1 0 11 12 13"), again + says},  // with tags of partitions
                          {twice("8 3 2 7 3 1 2 12 11"),
                           "the element of line 25 is repeated because it is in two physical groups, "
                           "physical_9 and front_panel"},
                          {replaced(kNew, "1 1 2 1 -7 3", "1 1 2 2 -7 9 3"), "surface 2 is in " + says},
                          {replaced(kNew, "1 1 2 1 -7 3", "1 1 2 2 9 7 3"), "surface 2 is in " + says},
                          {replaced(kNew, "1 1 2 1 -7 3", "1 1 2 3 9 7 8 3"),
                           "surface 2 is in two physical groups, front_panel and physical_8"},
                          {replaced(kNew, "1 0 2 1 9 0", "1 0 2 2 9 -7 0"), "surface 3 is in " + says}});
  // The same group twice, a sign for another orientation, groups of curves, and surfaces without elements.
  for (const std::string& text : {replaced(kNew, "1 1 2 1 -7 3", "1 1 2 2 -7 7 3"),
                                  replaced(kNew, "1 0 0 0 1 0 0 0 2 1 -1", "1 0 0 0 1 0 0 2 3 4 2 1 -1"),
                                  replaced(replaced(kNew, "$Entities\n1 1 5 0", "$Entities\n1 1 6 0"),
                                           "$EndEntities", "6 0 0 0 0 1 2 2 7 9 0\n$EndEntities")})
    EXPECT_EQ(parse_gmsh(text, "bag").panel_names,
              (std::vector<std::string>{"front_panel", "physical_9", "surface_5"}));
}

TEST(Gmsh, no_damaged_file_crashes) {
  for (const std::string* text : {&kOld, &kNew}) meshes::expect_no_crash(parse_gmsh, *text);
}

}  // namespace
}  // namespace gmsh
