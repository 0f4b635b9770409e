// SPDX-License-Identifier: Apache-2.0
// Legacy VTK files: what is read, what is refused and where.
#include "mesh/vtk.hpp"

#include <array>

#include "bad_text.hpp"
#include "mesh/surface_check.hpp"

namespace vtk {
namespace {

using mesh::Mesh;
using mesh::parse_vtk;
using meshes::replaced;

// A box of 2 x 1 x 1: one quad is a pixel, one two triangles; a node that nothing uses, a line and a vertex.
const std::string kPoints = "POINTS 9 float\n0 0 0 2 0 0 2 1 0 0 1 0\n0 0 1 2 0 1 2 1 1 0 1 1 9 9 9\n";
const std::string kGrid =
    "# vtk DataFile Version 3.0\nthe bag\nASCII\nDATASET UNSTRUCTURED_GRID\n" + kPoints +
    "CELLS 9 38\n2 0 1\n4 0 3 2 1\n4 4 5 7 6\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n3 3 0 4\n"
    "3 3 4 7\n1 0\nCELL_TYPES 9\n3 9 8 9 9 7 5 5 1\n"
    "CELL_DATA 9\nSCALARS stretch double\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9\n"
    "SCALARS part int 1\nLOOKUP_TABLE default\n0 1 1 2 2 2 7 7 0\n";

const std::string kPolyData =
    "# vtk DataFile Version 2.0\n\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
    "LINES 1 3\n2 0 1\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
    "CELL_DATA 5\nFIELD more 2\nvelocity 3 5 float\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\npanel 1 5 long\n9 0 "
    "0 1 1\n";

const std::string kVersion5 =
    "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 "
    "1\n"
    "METADATA\nINFORMATION 1\nNAME L2 LOCATION v\nDATA 2 0 1\n\n"
    "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 0 3 2\n"
    "POINT_DATA 4\nVECTORS v float\n0 0 0 0 0 0 0 0 0 0 0 0\n";

TEST(Vtk, grid_has_its_cells_and_panels) {
  const Mesh mesh = parse_vtk(kGrid, "bag");
  EXPECT_EQ(mesh.element_count(), 12);
  EXPECT_EQ(mesh.split_quads, 5);
  EXPECT_EQ(mesh.node_count(), 8);
  EXPECT_EQ(mesh.panel_names, (std::vector<std::string>{"part_1", "part_2", "part_7"}));
  EXPECT_EQ(mesh.panel, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2}));
  EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
  EXPECT_NEAR(mesh::enclosed_volume(mesh.nodes, mesh.elements), 2.0, 1e-15);
  EXPECT_EQ(mesh.line.front(), 10);  // of the first cell with an area
}

TEST(Vtk, scalars_have_as_many_components_as_they_say) {
  const Mesh mesh = parse_vtk(kGrid, "bag");
  for (const int components : {1, 2, 3, 4}) {
    std::string values;
    for (int i = 0; i < 9 * components; ++i) values += std::to_string(i) + ' ';
    const Mesh other =
        parse_vtk(replaced(replaced(kGrid, "stretch double", "stretch double " + std::to_string(components)),
                           "1 2 3 4 5 6 7 8 9\n", values + '\n'),
                  "bag");
    EXPECT_EQ(other.panel_names, mesh.panel_names) << components;
    EXPECT_EQ(other.panel, mesh.panel) << components;
  }
}

// Filters of VTK number the cells; what they leave behind stands before or after the parts.
TEST(Vtk, identifiers_of_cells_are_no_panels) {
  const Mesh plain = parse_vtk(kGrid, "bag");
  const std::string part = "SCALARS part int 1", ids = "0 1 2 3 4 5 6 7 8\n";
  const auto array = [](const std::string& name, const std::string& type, const std::string& values) {
    return "SCALARS " + name + " " + type + " 1\nLOOKUP_TABLE default\n" + values;
  };
  const auto skips = [](const Mesh& mesh, const char* name) {
    return mesh.skipped == std::vector<std::string>{std::string("cell array ") + name};
  };
  for (const auto& [name, type, values] :
       {std::array<std::string, 3>{"vtkOriginalCellIds", "vtkIdType", ids},
        std::array<std::string, 3>{"vtkOriginalCellIds", "vtkIdType", "0 0 0 0 0 0 0 1 1\n"},
        std::array<std::string, 3>{"vtkGhostType", "unsigned_char", "0 0 0 0 0 0 0 1 1\n"},
        std::array<std::string, 3>{"GlobalElementId", "long", "11 12 13 14 15 16 17 18 19\n"},
        std::array<std::string, 3>{"cell", "int", "1 1 2 2 3 3 4 4 5\n"}}) {
    const Mesh mesh = parse_vtk(replaced(kGrid, part, array(name, type, values) + part), "bag");
    EXPECT_EQ(mesh.panel_names, plain.panel_names) << name;
    EXPECT_EQ(mesh.panel, plain.panel) << name;
    EXPECT_TRUE(skips(mesh, name.c_str())) << name;
    EXPECT_EQ(parse_vtk(kGrid + array(name, type, values), "bag").panel_names, plain.panel_names) << name;
  }
  // Alone they leave one panel, and an array of one value names it.
  const Mesh alone = parse_vtk(replaced(kGrid, "0 1 1 2 2 2 7 7 0\n", ids), "bag");
  EXPECT_EQ(alone.panel_names, std::vector<std::string>{"default"});
  EXPECT_TRUE(skips(alone, "part"));
  const std::string ones = "3 3 3 3 3 3 3 3 3\n";
  EXPECT_EQ(parse_vtk(replaced(kGrid, part, array("domain", "int", ones) + part), "bag").panel_names,
            plain.panel_names);
  EXPECT_EQ(parse_vtk(replaced(kGrid, "0 1 1 2 2 2 7 7 0\n", ones), "bag").panel_names,
            std::vector<std::string>{"part_3"});
  const std::string attributes = "GLOBAL_IDS ids int\n" + ids + "PEDIGREE_IDS more vtkIdType\n" + ids;
  EXPECT_EQ(parse_vtk(replaced(kGrid, part, attributes + part), "bag").panel, plain.panel);
}

// The values that a cell has are counted without its lines and vertices: 0, 0, 1, 1 here.
TEST(Vtk, skipped_cells_have_no_part_in_what_is_an_identifier) {
  EXPECT_EQ(parse_vtk(kPolyData, "bag").panel_names, (std::vector<std::string>{"panel_0", "panel_1"}));
}

TEST(Vtk, sections_without_values_are_read) {
  const std::string bare = kGrid.substr(0, kGrid.find("CELL_DATA"));
  for (const char* rest :
       {"CELL_DATA 0\n", "CELL_DATA 9\n", "CELL_DATA 9\nFIELD FieldData 0\n", "CELL_DATA 0\nPOINT_DATA 0\n",
        "CELL_DATA 9\nPOINT_DATA 9\n", "POINT_DATA 0\nCELL_DATA 0\nFIELD f 0\n",
        "CELL_DATA 0\nFIELD f 1\npart 1 0 int\n", "CELL_DATA 0\nSCALARS part int\nLOOKUP_TABLE default\n",
        "CELL_DATA 0\nSCALARS part int 1\n", "CELL_DATA 0\nVECTORS v float\nNORMALS n float\n",
        "CELL_DATA 0\nMETADATA\nINFORMATION 0\n\nPOINT_DATA 0\n"}) {
    const Mesh mesh = parse_vtk(bare + rest, "bag");
    EXPECT_EQ(mesh.element_count(), 12) << rest;
    EXPECT_EQ(mesh.panel_names, std::vector<std::string>{"default"}) << rest;
  }
  meshes::expect_refused(parse_vtk, {{bare + "CELL_DATA 0\nSCALARS part int 1\nLOOKUP_TABLE default\n1 2 3\n",
                                      "\"1\" is not a supported section"}});
}

TEST(Vtk, polydata_of_both_versions_are_the_same_tetrahedron) {
  const Mesh old = parse_vtk(kPolyData, "bag"), young = parse_vtk(kVersion5, "bag");
  EXPECT_TRUE(old.nodes == young.nodes);
  EXPECT_TRUE(old.elements == young.elements);
  EXPECT_TRUE(mesh::check_closed_surface(old.nodes, old.elements).ok());
  EXPECT_EQ(old.panel_names, (std::vector<std::string>{"panel_0", "panel_1"}));  // the line has the value 9
  EXPECT_EQ(old.panel, (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(young.panel_names, (std::vector<std::string>{"default"}));
}

TEST(Vtk, bad_files_are_refused_with_line_and_column) {
  meshes::expect_refused(
      parse_vtk,
      {{"", "bag:1:1: the file ends here"},
       {"solid a", "bag:1:1: a legacy VTK file begins with # vtk DataFile Version"},
       {replaced(kGrid, "ASCII", "HEX"), "bag:3:1: \"HEX\" is not supported; allowed: ASCII or BINARY"},
       {replaced(kGrid, "UNSTRUCTURED_GRID", "STRUCTURED_GRID"),
        "bag:4:9: \"STRUCTURED_GRID\" is not supported"},
       {replaced(kGrid, "2 1 0 0 1 0\n", "2 1 0 0 one 0\n"), "bag:6:21: y: \"one\" is not a number"},
       {replaced(kGrid, "2 1 0 0 1 0\n", "2 1 0 0 nan 0\n"), "bag:6:21: y: \"nan\" is not finite"},
       {replaced(kGrid, "POINTS 9", "POINTS 999999999999"),
        "bag:5:8: the number of points is \"999999999999\""},
       {replaced(kGrid, "4 0 3 2 1", "4 0 3 2 9"),
        "bag:10:9: a node is \"9\", allowed: a whole number from 0 to 8"},
       {replaced(kGrid, "CELLS 9 38", "CELLS 9 39"),
        "bag:8:1: the cells have 38 numbers, not the 39 announced"},
       {replaced(kGrid, "3 9 8 9", "3 12 8 9"), "bag:10:1: cell type 12 is not supported"},
       {replaced(kGrid, "3 9 8 9", "3 5 8 9"), "bag:10:1: cell type 5 with 4 corners"},
       {replaced(kGrid, "CELL_TYPES 9", "CELL_TYPES 8"), "bag:18:1: 8 types for 9 cells"},
       {replaced(kGrid, "CELL_DATA 9", "CELL_DATA 8"), "bag:20:1: 8 values for 9 cells"},
       {replaced(kGrid, "SCALARS part", "COLOURS part"), "\"COLOURS\" is not a supported section"},
       {replaced(kPolyData, "POLYGONS 4 16\n3 0 2 1", "POLYGONS 4 15\n2 0 2"),
        "a cell of 2 corners, allowed: 3 or more"},
       {replaced(kVersion5, "0 3 6 9 12", "0 3 6 9 11"),
        "the offsets do not go from 0 to the number of nodes, 12"},
       {replaced(kVersion5, "0 3 6 9 12", "0 6 3 9 12"), "bag:14:5: an offset is \"3\""},
       {kPolyData + "LINES 1 3\n2 0 1\n", "bag:22:1: array panel comes before the end of the cells"},
       {kGrid.substr(0, kGrid.find("CELL_TYPES")), "CELL_TYPES is missing"},
       {kGrid.substr(0, kGrid.find("CELLS")), "bag: the file has no cells"}});
}

TEST(Vtk, no_damaged_file_crashes) {
  for (const std::string* text : {&kGrid, &kPolyData, &kVersion5}) meshes::expect_no_crash(parse_vtk, *text);
}

}  // namespace
}  // namespace vtk
