// SPDX-License-Identifier: Apache-2.0
// OFF text: layouts that are read, what is refused and where.
#include "mesh/off.hpp"

#include "bad_text.hpp"
#include "mesh/surface_check.hpp"

namespace off {
namespace {

using mesh::Mesh;
using mesh::parse_off;
using meshes::replaced;

// A pyramid of one quad and four triangles.
const std::string kOff =
    "OFF\n# a pyramid\n5 5 0\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 "
    "0 4\n";

std::string with(char blank, const std::string& text) {
  std::string result = text;
  for (char& c : result)
    if (c == ' ' || c == '\n') c = blank;
  return result;
}

TEST(Off, white_space_is_free) {
  const Mesh plain = parse_off(kOff, "bag");
  EXPECT_EQ(plain.element_count(), 6);
  EXPECT_EQ(plain.line, (std::vector<int>{10, 10, 11, 12, 13, 14}));
  EXPECT_TRUE(mesh::check_closed_surface(plain.nodes, plain.elements).ok());
  EXPECT_EQ(mesh::enclosed_volume(plain.nodes, plain.elements), 1.0 / 3.0);
  const std::string bare = replaced(kOff, "# a pyramid\n", "");
  for (const std::string& text :
       {with('\n', bare),  // a number a line
        with(' ', bare),   // all in one line
        with('\t', bare),
        replaced(kOff, "4 0 3 2 1\n3 0 1 4\n", "4\n0\n3\n2\n1\n3\n0\n1\n4\n"),  // an index a line
        replaced(kOff, "4 0 3 2 1\n3 0 1 4\n", "4 0 3\n2 1\n3\n0 1 4\n"),
        replaced(kOff, "4 0 3 2 1\n3 0 1 4\n", "4 0 3 2 1 3 0 1 4\n"),  // two faces a line
        replaced(kOff, "0 0 0\n1 0 0\n", "0 0 0 1 0 0\n"),              // two vertices a line
        replaced(kOff, "0 0 0\n1 0 0\n", "0\n0 0\n1 0\n0\n"),
        replaced(kOff, "OFF\n# a pyramid\n5 5 0\n", "OFF 5 5 0\n"),
        replaced(kOff, "5 5 0\n", "5 5\n"),  // no count of edges
        replaced(kOff, "5 5 0\n", "5\n5\n0\n"), replaced(kOff, "OFF", "off"),
        replaced(kOff, "5 5 0\n", "5 5 0 # counts\n# and no more\n")}) {
    const Mesh mesh = parse_off(text, "bag");
    EXPECT_TRUE(mesh.nodes == plain.nodes) << text;
    EXPECT_TRUE(mesh.elements == plain.elements) << text;
  }
}

TEST(Off, normals_and_colours_are_not_read) {
  const Mesh plain = parse_off(kOff, "bag");
  std::string colours =
      replaced(replaced(kOff, "3 0 1 4\n", "3 0 1 4 255 0 0\n"), "3 1 2 4\n", "3 1 2 4 0.5 0.5 0.5 1\n");
  for (const std::string& text :
       {colours, replaced(kOff, "3 0 1 4\n", "3 0 1 4 7 # of a colour map\n"),
        replaced(replaced(colours, "OFF", "COFF"), "1 0 0\n", "1 0 0 255 255 255 255\n"),
        replaced(replaced(kOff, "OFF", "NOFF"), "1 0 0\n", "1 0 0 0 0 1\n"),
        replaced(kOff, "1 0 0\n", "1 0 0 255 0 0 255\n"),
        replaced(replaced(kOff, "OFF", "STOFF"), "1 0 0\n", "1 0 0 0.5 0.5\n")}) {
    const Mesh mesh = parse_off(text, "bag");
    EXPECT_TRUE(mesh.nodes == plain.nodes) << text;
    EXPECT_TRUE(mesh.elements == plain.elements) << text;
  }
}

TEST(Off, bad_files_are_refused_with_line_and_column) {
  const std::string goes_on = "the header in line 3 announces 5 vertices and ";
  meshes::expect_refused(
      parse_off,
      {{"", "bag:1:1: the file ends here: OFF is missing"},
       {"OFF BINARY\n", "bag:1:5: binary OFF is not supported"},
       {replaced(kOff, "OFF", "4OFF"), "bag:1:1: \"4OFF\" is not supported"},
       {replaced(kOff, "5 5 0", "5 many 0"), "bag:3:3: the number of faces is \"many\""},
       {replaced(kOff, "5 5 0", "5 5000000000 0"), "bag:3:3: the number of faces is \"5000000000\""},
       {replaced(kOff, "1 0 0\n", "1 none 0\n"), "bag:6:3: a coordinate: \"none\" is not a number"},
       {replaced(kOff, "1 0 0\n", "1 inf 0\n"), "bag:6:3: a coordinate: \"inf\" is not finite"},
       {replaced(kOff, "1 0 0\n", "1 0\n"), "bag:6:1: the line ends before the third coordinate"},
       {replaced(kOff, "4 0 3 2 1", "4 0 3 2 7"),
        "bag:10:9: a corner is \"7\", allowed: a whole number from 0 to 4"},
       {replaced(kOff, "4 0 3 2 1", "4 0 3 2 -1"), "bag:10:9: a corner is \"-1\""},
       {replaced(kOff, "4 0 3 2 1", "5 0 3 2 1 4"), "bag:10:1: the polygon of 5 corners is not plane"},
       {replaced(kOff, "3 1 2 4", "3 1 2"), "bag:12:1: the line ends before the last corner"},
       // More faces than the header says, or fewer; and vertices.
       {kOff + "3 0 1 2\n", "bag:15:1: " + goes_on + "5 faces, but the file continues for 1 line here"},
       {kOff + "\n# more\n3 0 1 2\n3 0 1 2\n",
        "bag:17:1: " + goes_on + "5 faces, but the file continues for 2 lines"},
       {replaced(kOff, "5 5 0", "5 4 0"),
        "bag:14:1: " + goes_on + "4 faces, but the file continues for 1 line here"},
       {replaced(kOff, "5 5 0", "5 1 0"),
        "bag:11:1: " + goes_on + "1 faces, but the file continues for 4 lines"},
       {replaced(kOff, "5 5 0", "5 0 0"),
        "bag:10:1: " + goes_on + "0 faces, but the file continues for 5 lines"},
       {with('\n', replaced(kOff, "# a pyramid\n5 5", "5 4")),
        "5 vertices and 4 faces, but the file continues"},
       {replaced(kOff, "5 5 0", "5 6 0"),
        "bag:15:1: the file ends here, face 6 of the 6 of the header in line 3 is missing"},
       {replaced(kOff, "5 5 0", "6 5 0"), "is missing"},
       {replaced(kOff, "5 5 0", "4 5 0"), "bag:9:1: a face of 0 corners"},
       {replaced(replaced(kOff, "5 5 0", "4 5 0"), "0 0 1\n", "3 3 0\n"), "bag:9:1: the line ends before"},
       {kOff + "appendix\n", "bag:15:1: " + goes_on + "5 faces, but the file continues for 1 line here"},
       {"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "bag: the file has no elements"}});
}

TEST(Off, no_damaged_file_crashes) {
  meshes::expect_no_crash(parse_off, kOff);
}

}  // namespace
}  // namespace off
