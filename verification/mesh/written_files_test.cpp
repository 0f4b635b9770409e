// SPDX-License-Identifier: Apache-2.0
// One bag as VTK, meshio and Gmsh write it, in every kind of their files; and those files, damaged.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "bad_text.hpp"
#include "mesh/gmsh.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/vtk.hpp"

namespace written_files {
namespace {

using mesh::Mesh;
namespace fs = std::filesystem;

const fs::path kFolder = GASJET_WRITTEN_FILES;

std::vector<fs::path> files() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() != ".md") found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

meshes::Parser parser_of(const fs::path& file) {
  if (file.extension() == ".msh") return mesh::parse_gmsh;
  return file.extension() == ".vtk" ? mesh::parse_vtk : mesh::parse_vtk_xml;
}

// Its ends are 2 x 1 m and a gable of 0.7 m over 2 m; the walls run round them.
TEST(written_files, are_the_same_prism) {
  const double gable = std::hypot(1.0, 0.7), end = 2.0 + 0.7;
  EXPECT_EQ(files().size(), 11u);
  for (const fs::path& file : files()) {
    const Mesh mesh = mesh::read_mesh(file);
    EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok()) << file;
    EXPECT_NEAR(mesh::enclosed_volume(mesh.nodes, mesh.elements), 3.1 * end, 1e-14) << file;
    ASSERT_EQ(mesh.panel_names.size(), 2u) << file;
    const bool is_gmsh = file.extension() == ".msh";
    EXPECT_EQ(mesh.node_count(), is_gmsh ? 12 : 10) << file;  // Gmsh meshes its ends with a node in each
    EXPECT_EQ(mesh.split_polygons, is_gmsh ? 0 : 2) << file;
    ASSERT_EQ(mesh.node_sets.size(), is_gmsh ? 1u : 0u) << file;  // a physical curve round an end
    if (is_gmsh) {
      EXPECT_EQ(mesh.node_sets[0].name, "rim");
      EXPECT_EQ(mesh.node_sets[0].nodes, (std::vector<int>{0, 1, 2, 3, 4}));
    }
    EXPECT_EQ(mesh.panel_names[0], is_gmsh ? "ends" : "part_1") << file;
    EXPECT_EQ(mesh.panel_names[1], is_gmsh ? "walls" : "part_2") << file;
    EXPECT_NEAR(mesh::panel_areas(mesh)(0), 2.0 * end, 1e-14) << file;
    EXPECT_NEAR(mesh::panel_areas(mesh)(1), 3.1 * (2.0 + 2.0 + 2.0 * gable), 1e-13) << file;
  }
}

// The strings have lengths of one, two and more bytes.
TEST(written_files, say_where_a_binary_file_is_wrong) {
  const auto text = [](const char* name) { return content(kFolder / name); };
  const auto cut = [&](const char* name, std::size_t bytes) {
    const std::string all = text(name);
    return all.substr(0, all.size() - bytes);
  };
  meshes::expect_refused(mesh::parse_vtk,
                         {{cut("vtk_polydata_42.vtk", 9), "bag: at byte 6"},
                          {cut("vtk_polydata_42.vtk", 9), "the file ends here: a value is missing"}});
  meshes::expect_refused(mesh::parse_gmsh, {{cut("gmsh_22.msh", 40), "the file ends here"},
                                            {meshes::replaced(text("gmsh_41.msh"), "4.1 1 8", "4.1 1 4"),
                                             "bag:2:7: numbers of \"4\""},
                                            {meshes::replaced(text("gmsh_41.msh"), "4.1 1 8", "4.1 7 8"),
                                             "\"7\" is found instead of 0 for ASCII or 1 for binary"}});
  const std::string xml = text("vtk_raw_zlib.vtp"), plain = text("vtk_base64.vtu"),
                    words = text("vtk_ascii.vtp");
  meshes::expect_refused(
      mesh::parse_vtk_xml,
      {{cut("vtk_raw_zlib.vtp", 300), "the data ends too early"},
       {meshes::replaced(xml, "vtkZLibDataCompressor", "vtkLZ4DataCompressor"),
        "compressor \"vtkLZ4DataCompressor\" is not supported; write the file with vtkZLibDataCompressor"},
       {meshes::replaced(xml, "type=\"PolyData\"", "type=\"ImageData\""),
        "bag:1:1: type \"ImageData\" is not supported; allowed: PolyData or UnstructuredGrid"},
       {meshes::replaced(xml, "NumberOfPoints=\"11\"", "NumberOfPoints=\"12\""),
        "array \"Points\": has 264 bytes, needed are 288"},
       {meshes::replaced(xml, "encoding=\"raw\"", "encoding=\"hex\""), "encoding \"hex\""},
       {meshes::replaced(plain, "NumberOfCells=\"10\"", "NumberOfCells=\"9\""), "bytes, needed are"},
       {meshes::replaced(words, "\"Float64\" Name=\"Points\"", "\"Float128\" Name=\"Points\""),
        "type \"Float128\" is not a number of VTK"},
       {meshes::replaced(words, "NumberOfPoints=\"11\"", "NumberOfPoints=\"-1\""),
        "NumberOfPoints is \"-1\", allowed: a whole number"},
       {"<VTKFile type=\"PolyData\"", "the tag \"VTKFile\" does not end"},
       {"solid a", "bag:1:1: an XML file of VTK begins with <VTKFile>"},
       {"<VTKFile type=\"PolyData\"></VTKFile>", "bag: the file has no cells"}});
}

// Every one of them is a mesh, or is refused.
TEST(written_files, damaged_are_read_or_refused) {
  std::mt19937_64 random(1);
  for (const fs::path& file : files()) {
    const std::string good = content(file);
    int refused = 0;
    const auto attempt = [&](const std::string& bytes) {
      try {
        const Mesh mesh = parser_of(file)(bytes, "bag");
        EXPECT_GT(mesh.element_count(), 0);
        EXPECT_LT(mesh.elements.maxCoeff(), mesh.node_count());
        EXPECT_GE(mesh.elements.minCoeff(), 0);
        EXPECT_TRUE(mesh.nodes.allFinite());
      } catch (const mesh::MeshFileError&) {
        ++refused;
      }
    };
    for (std::size_t length = 0; length < good.size(); length += 7) attempt(good.substr(0, length));
    for (int i = 0; i < 2000; ++i) {
      std::string bytes = good;
      for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      attempt(bytes);
    }
    EXPECT_GT(refused, 0) << file;
  }
}

}  // namespace
}  // namespace written_files
