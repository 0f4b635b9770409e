// SPDX-License-Identifier: Apache-2.0
#include "mesh/vtk.hpp"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "mesh/merge.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"
#include "vtk_attributes.hpp"

namespace mesh {
namespace {

struct Cell {
  std::vector<long long> nodes;
  std::size_t line, column;
  int type;  // type in VTK; 0: a polygon
};

class VtkParser {
 public:
  VtkParser(std::string_view text, const std::string& name) : words_(text, name) {}

  Mesh parse() {
    header();
    while (!words_.at_end()) section();
    return build();
  }

 private:
  void header() {
    const MeshWord begin = words_.peek("# vtk DataFile Version");
    if (!words_.rest_of_line().starts_with("# vtk DataFile Version"))
      words_.fail(begin, "a legacy VTK file begins with # vtk DataFile Version");
    words_.next_line();
    words_.rest_of_line();  // the title
    const MeshWord format = words_.word("ASCII");
    if (upper_case(format.text) != "ASCII")
      words_.fail(format, shown(format.text) + " is not supported; write the file as ASCII");
    const MeshWord dataset = words_.word("DATASET");
    const MeshWord kind = words_.word("POLYDATA or UNSTRUCTURED_GRID");
    const std::string type = upper_case(kind.text);
    if (upper_case(dataset.text) != "DATASET" || (type != "POLYDATA" && type != "UNSTRUCTURED_GRID"))
      words_.fail(kind,
                  shown(kind.text) + " is not supported; allowed: DATASET POLYDATA or UNSTRUCTURED_GRID");
  }

  void section() {
    const MeshWord word = words_.word("a section");
    const std::string key = upper_case(word.text);
    if (key == "POINTS") return points(word);
    if (key == "POLYGONS" || key == "CELLS") return cells(word, key);
    if (key == "CELL_TYPES") return types(word);
    if (key == "VERTICES" || key == "LINES") return skip_cells();
    if (!attributes_.read(key, word, polygons_.size() + skipped_, points_.size()))
      words_.fail(word, shown(word.text) + " is not a supported section");
  }

  void points(const MeshWord& at) {
    if (!points_.empty()) words_.fail(at, "the points are repeated");
    const std::size_t count = words_.count("the number of points");
    words_.word("the type of the points");
    for (std::size_t i = 0; i < count; ++i) {
      const double x = words_.number("x"), y = words_.number("y"), z = words_.number("z");
      points_.push_back({x, y, z});
    }
  }

  long long node() { return words_.integer("a node", 0, static_cast<long long>(points_.size()) - 1); }

  void cells(const MeshWord& at, const std::string& key) {
    if (points_.empty()) words_.fail(at, shown(at.text) + " comes before the points");
    if (!polygons_.empty()) words_.fail(at, "the cells are repeated");
    are_typed_ = key == "CELLS";
    const std::size_t count = words_.count("the number of cells"),
                      size = words_.count("the size of the list");
    if (upper_case(words_.peek("the cells").text) == "OFFSETS") return offsets(count, size);
    std::size_t read = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const MeshWord place = words_.peek("a cell");
      const auto corners =
          static_cast<std::size_t>(words_.integer("the number of corners", 0, static_cast<long long>(size)));
      Cell cell{{}, place.line, place.column, 0};
      for (std::size_t k = 0; k < corners; ++k) cell.nodes.push_back(node());
      read += corners + 1;
      polygons_.push_back(std::move(cell));
    }
    if (read != size)
      words_.fail(at, "the cells have " + std::to_string(read) + " numbers, not the " + std::to_string(size) +
                          " announced");
  }

  // Version 5: the begin of each cell, then the nodes of all.
  void offsets(std::size_t count, std::size_t size) {
    words_.word("OFFSETS");
    words_.word("the type of the offsets");
    std::vector<long long> begin;
    for (std::size_t i = 0; i < count; ++i)
      begin.push_back(
          words_.integer("an offset", begin.empty() ? 0 : begin.back(), static_cast<long long>(size)));
    const MeshWord at = words_.word("CONNECTIVITY");
    if (upper_case(at.text) != "CONNECTIVITY")
      words_.fail(at, shown(at.text) + " is found instead of CONNECTIVITY");
    words_.word("the type of the connectivity");
    if (count == 0 || begin.front() != 0 || begin.back() != static_cast<long long>(size))
      words_.fail(at, "the offsets do not go from 0 to the number of nodes, " + std::to_string(size));
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const MeshWord place = words_.peek("a cell");
      Cell cell{{}, place.line, place.column, 0};
      for (auto k = begin[i]; k < begin[i + 1]; ++k) cell.nodes.push_back(node());
      polygons_.push_back(std::move(cell));
    }
  }

  void types(const MeshWord& at) {
    const std::size_t count = words_.count("the number of cells");
    if (!are_typed_ || count != polygons_.size())
      words_.fail(at, std::to_string(count) + " types for " + std::to_string(polygons_.size()) + " cells");
    for (Cell& cell : polygons_) cell.type = static_cast<int>(words_.integer("the type of a cell", 0, 100));
    has_types_ = true;
  }

  void skip_cells() {
    const std::size_t count = words_.count("the number of cells"),
                      size = words_.count("the size of the list");
    const bool has_offsets = size > 0 && upper_case(words_.peek("the cells").text) == "OFFSETS";
    skip(words_, size + (has_offsets ? count + 4 : 0));
    skipped_ += has_offsets ? count - (count > 0 ? 1 : 0) : count;
  }

  // True for cells without area, which are skipped.
  bool is_skipped(const Cell& cell) const { return cell.type >= 1 && cell.type <= 4; }

  void check(const Cell& cell) const {
    const MeshWord at{{}, cell.line, cell.column};
    const std::size_t corners = cell.nodes.size();
    const bool is_known = cell.type == 0 || cell.type == 5 || (cell.type >= 7 && cell.type <= 9);
    if (!is_known)
      words_.fail(
          at, "cell type " + std::to_string(cell.type) +
                  " is not supported; allowed: 5 triangle, 7 polygon, 8 pixel, 9 quad (1 to 4 are skipped)");
    if (corners != 3 && corners != 4)
      words_.fail(at, "a cell of " + std::to_string(corners) + " corners, allowed: 3 or 4");
    if ((cell.type == 5 && corners != 3) || (cell.type >= 8 && corners != 4))
      words_.fail(at,
                  "cell type " + std::to_string(cell.type) + " with " + std::to_string(corners) + " corners");
  }

  // Meaning of an array of the cells: panels, or identifiers of cells, which VTK's filters leave behind.
  enum class Meaning { panels, one_panel, identifiers };
  Meaning meaning_of(const CellNumbers& numbers) const {
    if (numbers.name.starts_with("vtkOriginal") || numbers.name.starts_with("vtkGhost"))
      return Meaning::identifiers;
    std::unordered_set<std::string_view> values;
    std::size_t cells = 0;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      if (is_skipped(polygons_[i])) continue;
      values.insert(numbers.values[skipped_ + i]);
      ++cells;
    }
    if (values.size() == 1) return Meaning::one_panel;
    return 2 * values.size() > cells ? Meaning::identifiers : Meaning::panels;
  }

  // The first array with several panels, otherwise the first with one panel; null if there is neither.
  const CellNumbers* panels(std::vector<std::string>& identifiers) const {
    const CellNumbers* one = nullptr;
    for (const CellNumbers& numbers : attributes_.cell_numbers()) {
      const Meaning meaning = meaning_of(numbers);
      if (meaning == Meaning::panels) return &numbers;
      if (meaning == Meaning::identifiers) identifiers.push_back("cell array " + numbers.name);
      if (meaning == Meaning::one_panel && !one) one = &numbers;
    }
    return one;
  }

  Mesh build() {
    const MeshWord end{{}, words_.line(), 1};
    if (polygons_.empty()) throw MeshFileError(words_.name(), 0, 0, "the file has no cells");
    if (are_typed_ && !has_types_) words_.fail(end, "the file ends here: CELL_TYPES is missing");
    for (const CellNumbers& numbers : attributes_.cell_numbers())
      if (numbers.values.size() != polygons_.size() + skipped_)
        words_.fail(end, "array " + numbers.name + " comes before the end of the cells");
    std::vector<std::string> identifiers;
    const CellNumbers* numbers = panels(identifiers);
    MeshBuilder mesh;
    for (const Eigen::Vector3d& x : points_) mesh.add_node(x);
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const Cell& cell = polygons_[i];
      if (is_skipped(cell)) continue;
      check(cell);
      std::vector<int> corners(cell.nodes.begin(), cell.nodes.end());
      if (cell.type == 8) std::swap(corners[2], corners[3]);
      // Values of vertices and lines come first, in any order of the sections.
      mesh.add_polygon(corners,
                       numbers ? numbers->name + "_" + std::string(numbers->values[skipped_ + i]) : "default",
                       cell.line);
    }
    if (mesh.empty()) throw MeshFileError(words_.name(), 0, 0, "the file has no cells with an area");
    Mesh result = used_nodes(std::move(mesh).finish());
    result.skipped = std::move(identifiers);
    return result;
  }

  TokenReader words_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Cell> polygons_;
  VtkAttributes attributes_{words_};
  bool are_typed_ = false, has_types_ = false;
  std::size_t skipped_ = 0;  // vertices and lines of polydata
};

}  // namespace

Mesh parse_vtk(std::string_view text, const std::string& name) {
  return VtkParser(text, name).parse();
}

}  // namespace mesh
