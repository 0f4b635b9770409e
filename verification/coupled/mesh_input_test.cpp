// SPDX-License-Identifier: Apache-2.0
// Mesh files that are no control volume are refused by name and place.
#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "fault.hpp"

namespace {

using coupled::Folder;
using coupled::message_of;
using coupled::read;

struct BadMesh {
  const char* name;
  const char* text;
  const char* says;
};

void PrintTo(const BadMesh& mesh, std::ostream* out) {
  *out << mesh.name;
}

class bad_mesh : public testing::TestWithParam<BadMesh> {};

TEST_P(bad_mesh, is_refused) {
  const Folder folder;
  std::ofstream(folder.path / "bag.obj") << GetParam().text;
  std::string text = read(GASJET_SOURCE_DIR "/cases/sphere_inflation.toml");
  const std::string generator = "{ generator = \"icosphere\", radius = 0.3, levels = 3 }";
  text.replace(text.find(generator), generator.size(), "{ file = \"bag.obj\" }");
  std::ofstream(folder.path / "case.toml") << text;
  const std::string message = message_of(folder.path / "case.toml");
  EXPECT_EQ(message.substr(0, folder.path.string().size()), folder.path.string()) << message;
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
}

constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kClosed = std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string kHole = std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 2 3 4\n";
const std::string kTurned = std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n";
const std::string kRepeated = std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 2 3 3\nf 1 4 3\n";
const std::string kOutOfRange = std::string(kCorners) + "f 1 3 2\nf 1 2 4\nf 2 3 9\nf 1 4 3\n";
const std::string kInward = std::string(kCorners) + "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n";
const std::string kTwo = kClosed + "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n";
const std::string kNoArea = kClosed + "v 1 0 1\nv 2 0 2\nv 3 0 3\nf 5 6 7\n";
const BadMesh kMeshes[] = {
    {"hole", kHole.c_str(),
     "bag.obj:5:1: mesh: is not a closed control volume: 3 boundary edges (a hole in the surface): nodes 1-3 "
     "of elements in lines 5;"},
    {"orientation", kTurned.c_str(),
     "bag.obj:5:1: mesh: is not a closed control volume: 3 inconsistently oriented edges"},
    {"repeated_node", kRepeated.c_str(),
     "bag.obj:5:1: mesh: is not a closed control volume: 1 element left out, two corners of which coincide; "
     "3 "
     "boundary edges"},
    {"out_of_range", kOutOfRange.c_str(), "bag.obj:7:7: node index 9 is out of range: 4"},
    {"inward", kInward.c_str(), "bag.obj:5:1: mesh: is not a closed control volume: inward"},
    {"no_area", kNoArea.c_str(),
     "bag.obj:12:1: mesh: the element has no area: its nodes 5, 6 and 7 at (1, 0, 1), (2, 0, 2) and (3, 0, "
     "3) m "
     "lie on one line"},
    {"two_chambers", kTwo.c_str(), "2 disconnected components (a bag is one chamber, a sheet one piece)"},
    {"not_a_mesh", "hello world\n", "bag.obj:1:"},
    {"empty", "", "element"},
};
INSTANTIATE_TEST_SUITE_P(meshes, bad_mesh, testing::ValuesIn(kMeshes),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(missing_mesh, is_told_at_the_key_that_names_it) {
  const std::filesystem::path file = GASJET_SOURCE_DIR "/cases/bag_from_files.toml";
  for (const char* key : {"file", "initial_file"}) {
    const Folder folder;
    std::string text = read(file);
    const std::string name =
        key == std::string("file") ? "bag_from_files/design.obj" : "bag_from_files/start.obj";
    text.replace(text.find(name), name.size(), "none.obj");
    // The other files are where they were.
    std::filesystem::copy(file.parent_path() / "bag_from_files", folder.path / "bag_from_files");
    std::ofstream(folder.path / "case.toml") << text;
    const std::string message = message_of(folder.path / "case.toml");
    const auto at = text.find("none.obj") - std::string(" = \"").size() - std::string(key).size();
    EXPECT_EQ(message.substr(0, message.find(": ")), coupled::place_of(folder.path / "case.toml", text, at))
        << message;
    EXPECT_NE(message.find("cannot be opened"), std::string::npos) << message;
  }
}

TEST(good_input, closed_mesh_file_is_accepted) {
  // The control of bad_mesh: the same case with the closed tetrahedron.
  const Folder folder;
  std::ofstream(folder.path / "bag.obj") << kClosed;
  std::string text = read(GASJET_SOURCE_DIR "/cases/sphere_inflation.toml");
  const std::string generator = "{ generator = \"icosphere\", radius = 0.3, levels = 3 }";
  text.replace(text.find(generator), generator.size(), "{ file = \"bag.obj\", length_unit = 0.5 }");
  std::ofstream(folder.path / "case.toml") << text;
  EXPECT_EQ(message_of(folder.path / "case.toml"), "accepted");
}

}  // namespace
