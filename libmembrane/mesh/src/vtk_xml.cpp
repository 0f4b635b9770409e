// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <utility>

#include "mesh/mesh_file.hpp"
#include "mesh/vtk.hpp"
#include "mesh_text.hpp"
#include "vtk_grid.hpp"
#include "vtk_xml_data.hpp"
#include "xml_tags.hpp"

namespace mesh {
namespace {

// A part of the data set, with its arrays by the section that they are in.
struct Piece {
  XmlTag tag;
  std::map<std::string_view, std::vector<VtkXmlArray>> sections;
};

// One kind of cells of a piece.
struct CellKind {
  std::string_view section, count;
  int type;  // 0: the section has their types
};
constexpr std::string_view kSections[] = {"Points", "Verts",    "Lines",     "Polys",    "Strips",
                                          "Cells",  "CellData", "PointData", "FieldData"};
constexpr CellKind kPolyCells[] = {{"Verts", "NumberOfVerts", 1},
                                   {"Lines", "NumberOfLines", VtkCell::line},
                                   {"Polys", "NumberOfPolys", VtkCell::polygon},
                                   {"Strips", "NumberOfStrips", VtkCell::strip}};
constexpr CellKind kGridCells[] = {{"Cells", "NumberOfCells", 0}};

class VtkXmlParser {
 public:
  VtkXmlParser(std::string_view text, const std::string& file) : tags_(text, file), text_(text) {
    grid_.file = file;
  }

  Mesh parse() {
    begin();
    scan();
    for (const Piece& piece : pieces_) read(piece);
    keep_common_arrays();
    return mesh_of_grid(grid_);
  }

 private:
  void begin() {
    XmlTag tag;
    if (!tags_.next(tag) || tag.name != "VTKFile") tags_.fail(0, "an XML file of VTK begins with <VTKFile>");
    const std::string_view type = tag["type"];
    if (type != "PolyData" && type != "UnstructuredGrid")
      tags_.fail(tag.begin,
                 "type " + shown(type) + " is not supported; allowed: PolyData or UnstructuredGrid");
    is_poly_ = type == "PolyData";
    if (tag["byte_order"] == "BigEndian") encoding_.order = ByteOrder::big;
    if (tag["header_type"] == "UInt64") encoding_.header_size = 8;
    encoding_.compressor = tag["compressor"];
  }

  // The tags up to the appended data.
  void scan() {
    XmlTag tag;
    std::string_view section;
    while (tags_.next(tag)) {
      if (tag.name == "AppendedData") return appended(tag);
      if (tag.name == "Piece" && !tag.ends) pieces_.push_back({tag, {}});
      if (tag.name == "DataArray" && !tag.ends && !pieces_.empty())
        pieces_.back().sections[section].emplace_back(tags_, tag);
      if (std::ranges::find(kSections, tag.name) != std::end(kSections)) section = tag.name;
    }
  }

  void appended(const XmlTag& tag) {
    const std::string_view encoding = tag["encoding"];
    if (encoding != "raw" && encoding != "base64")
      tags_.fail(tag.begin, "encoding " + shown(encoding) + ", allowed: raw or base64");
    encoding_.is_base64 = encoding == "base64";
    const std::size_t mark = text_.find('_', tag.content);
    if (mark == std::string_view::npos) tags_.fail(tag.begin, "the appended data has no _ before it");
    encoding_.appended = text_.substr(mark + 1);
  }

  // No file has more items than bits, times what compression saves; the rest of the limit is memory's.
  std::size_t count(const XmlTag& tag, std::string_view attribute) const {
    const std::string_view text = tag[attribute];
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    if (!text.empty() && (!is_number || value > largest_mesh_file))
      tags_.fail(tag.begin, std::string(attribute) + " is " + shown(text) +
                                ", allowed: a whole number up to " + std::to_string(largest_mesh_file));
    return value;
  }

  const VtkXmlArray* find(const Piece& piece, std::string_view section, std::string_view name) const {
    const auto found = piece.sections.find(section);
    if (found == piece.sections.end()) return nullptr;
    for (const VtkXmlArray& array : found->second)
      if (name.empty() || array.name() == name) return &array;
    return nullptr;
  }
  const VtkXmlArray& array(const Piece& piece, std::string_view section, std::string_view name) const {
    if (const VtkXmlArray* found = find(piece, section, name)) return *found;
    tags_.fail(piece.tag.begin,
               "the piece has no array " + std::string(name) + " in <" + std::string(section) + ">");
  }

  void read(const Piece& piece) {
    const std::size_t first_point = grid_.points.size(), first_cell = grid_.cells.size(),
                      points = count(piece.tag, "NumberOfPoints");
    if (points > 0) {
      const auto x = array(piece, "Points", "").reals(3 * points, encoding_);
      for (std::size_t i = 0; i < points; ++i) grid_.points.push_back({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
    }
    if (is_poly_)
      for (const CellKind& kind : kPolyCells) cells(piece, kind, first_point);
    else
      cells(piece, kGridCells[0], first_point);
    arrays(piece, grid_.cells.size() - first_cell);
  }

  void cells(const Piece& piece, const CellKind& kind, std::size_t first_point) {
    const std::size_t cells = count(piece.tag, kind.count), points = grid_.points.size() - first_point;
    if (cells == 0) return;
    const VtkXmlArray &offsets = array(piece, kind.section, "offsets"),
                      &nodes = array(piece, kind.section, "connectivity");
    const auto ends = offsets.wholes(cells, encoding_);
    for (std::size_t i = 0; i < cells; ++i)
      if (ends[i] < (i == 0 ? 0 : ends[i - 1])) tags_.fail(offsets.place(), "the offsets of cells fall");
    const auto last = static_cast<std::size_t>(ends.back());
    if (last > largest_mesh_file) tags_.fail(offsets.place(), "the offsets are beyond any mesh");
    const auto corners = nodes.wholes(last, encoding_);
    std::vector<long long> types(cells, kind.type);
    if (kind.type == 0) types = array(piece, kind.section, "types").wholes(cells, encoding_);
    for (std::size_t i = 0; i < cells; ++i) {
      VtkCell cell{{}, types[i] >= 0 && types[i] < 255 ? static_cast<int>(types[i]) : 255};
      for (auto k = i == 0 ? 0 : ends[i - 1]; k < ends[i]; ++k) {
        const long long node = corners[static_cast<std::size_t>(k)];
        if (node < 0 || node >= static_cast<long long>(points))
          tags_.fail(nodes.place(), "cell " + std::to_string(i) + ": node " + std::to_string(node) +
                                        " is out of range, 0 to " +
                                        std::to_string(static_cast<long long>(points) - 1));
        cell.nodes.push_back(node + static_cast<long long>(first_point));
      }
      grid_.cells.push_back(std::move(cell));
    }
  }

  void arrays(const Piece& piece, std::size_t cells) {
    const auto section = piece.sections.find("CellData");
    if (section == piece.sections.end() || cells == 0) return;
    for (const VtkXmlArray& array : section->second) {
      if (!array.is_whole_scalar()) continue;
      const std::string name = panel_name(array.name());
      auto values = array.wholes(cells, encoding_);
      const auto known = std::ranges::find(grid_.arrays, name, &VtkArray::name);
      if (known == grid_.arrays.end())
        grid_.arrays.push_back({name, std::move(values)});
      else
        known->values.insert(known->values.end(), values.begin(), values.end());
    }
  }

  // An array that not all pieces have says nothing.
  void keep_common_arrays() {
    std::erase_if(grid_.arrays,
                  [&](const VtkArray& array) { return array.values.size() != grid_.cells.size(); });
  }

  XmlTags tags_;
  std::string_view text_;
  bool is_poly_ = false;
  VtkEncoding encoding_;
  std::vector<Piece> pieces_;
  VtkGrid grid_;
};

}  // namespace

Mesh parse_vtk_xml(std::string_view text, const std::string& name) {
  return VtkXmlParser(text, name).parse();
}

}  // namespace mesh
