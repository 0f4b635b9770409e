// SPDX-License-Identifier: Apache-2.0
#include "mesh/vtk.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "mesh_text.hpp"
#include "mesh_tokens.hpp"
#include "vtk_attributes.hpp"
#include "vtk_grid.hpp"
#include "vtk_numbers.hpp"

namespace mesh {
namespace {

class VtkParser {
 public:
  VtkParser(std::string_view text, const std::string& name) : words_(text, name) { grid_.file = name; }

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
    const MeshWord format = words_.word("ASCII or BINARY");
    const std::string form = upper_case(format.text);
    if (form == "BINARY")
      numbers_.set_binary();
    else if (form != "ASCII")
      words_.fail(format, shown(format.text) + " is not supported; allowed: ASCII or BINARY");
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
    if (key == "CELLS") return cells(word, typed_, 0);
    if (key == "POLYGONS") return cells(word, polygons_, VtkCell::polygon);
    if (key == "TRIANGLE_STRIPS") return cells(word, strips_, VtkCell::strip);
    if (key == "CELL_TYPES") return types(word);
    if (key == "VERTICES" || key == "LINES") return cells(word, lines_, VtkCell::line);
    if (!attributes_.read(key, word, cell_count(), grid_.points.size()))
      words_.fail(word, shown(word.text) + " is not a supported section");
  }

  std::size_t cell_count() const { return typed_.size() + lines_.size() + polygons_.size() + strips_.size(); }

  void points(const MeshWord& at) {
    if (!grid_.points.empty()) words_.fail(at, "the points are repeated");
    const std::size_t count = words_.count("the number of points");
    const VtkType type = numbers_.type("the type of the points");
    numbers_.begin();
    for (std::size_t i = 0; i < count; ++i) {
      const double x = numbers_.real("x", type), y = numbers_.real("y", type), z = numbers_.real("z", type);
      grid_.points.push_back({x, y, z});
    }
  }

  void cells(const MeshWord& at, std::vector<VtkCell>& list, int type) {
    if (grid_.points.empty()) words_.fail(at, shown(at.text) + " comes before the points");
    if (!list.empty() && &list != &lines_) words_.fail(at, "the cells are repeated");
    const std::size_t count = words_.count("the number of cells"),
                      size = words_.count("the size of the list");
    if (numbers_.is_binary()) words_.next_line();
    words_.begins_with("OFFSETS") ? offsets(count, size, list, type) : counted(at, count, size, list, type);
  }

  // A node of the list of cells.
  long long node(const VtkType& type) {
    return numbers_.whole("a node", type, 0, static_cast<long long>(grid_.points.size()) - 1);
  }
  VtkCell begin_cell(int type) {
    if (numbers_.is_binary()) return {{}, type};
    const MeshWord place = words_.peek("a cell");
    return {{}, type, place.line, place.column};
  }

  // Each cell has the number of its nodes before them.
  void counted(const MeshWord& at, std::size_t count, std::size_t size, std::vector<VtkCell>& list,
               int type) {
    std::size_t read = 0;
    for (std::size_t i = 0; i < count; ++i) {
      VtkCell cell = begin_cell(type);
      const auto corners = static_cast<std::size_t>(
          numbers_.whole("the number of corners", int_, 0, static_cast<long long>(size)));
      for (std::size_t k = 0; k < corners; ++k) cell.nodes.push_back(node(int_));
      read += corners + 1;
      list.push_back(std::move(cell));
    }
    if (read != size)
      words_.fail(at, "the cells have " + std::to_string(read) + " numbers, not the " + std::to_string(size) +
                          " announced");
  }

  // Version 5: the begin of each cell, then the nodes of all.
  void offsets(std::size_t count, std::size_t size, std::vector<VtkCell>& list, int type) {
    words_.word("OFFSETS");
    const VtkType of_offset = numbers_.type("the type of the offsets");
    numbers_.begin();
    std::vector<long long> begin;
    for (std::size_t i = 0; i < count; ++i)
      begin.push_back(numbers_.whole("an offset", of_offset, begin.empty() ? 0 : begin.back(),
                                     static_cast<long long>(size)));
    const MeshWord at = words_.word("CONNECTIVITY");
    if (upper_case(at.text) != "CONNECTIVITY")
      words_.fail(at, shown(at.text) + " is found instead of CONNECTIVITY");
    const VtkType of_node = numbers_.type("the type of the connectivity");
    if (count == 0 ? size != 0 : begin.front() != 0 || begin.back() != static_cast<long long>(size))
      words_.fail(at, "the offsets do not go from 0 to the number of nodes, " + std::to_string(size));
    numbers_.begin();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      VtkCell cell = begin_cell(type);
      for (auto k = begin[i]; k < begin[i + 1]; ++k) cell.nodes.push_back(node(of_node));
      list.push_back(std::move(cell));
    }
  }

  void types(const MeshWord& at) {
    const std::size_t count = words_.count("the number of cells");
    if (typed_.empty() || count != typed_.size())
      words_.fail(at, std::to_string(count) + " types for " + std::to_string(typed_.size()) + " cells");
    numbers_.begin();
    for (VtkCell& cell : typed_)
      cell.type = static_cast<int>(numbers_.whole("the type of a cell", int_, 0, 100));
    has_types_ = true;
  }

  Mesh build() {
    const MeshWord end{{}, words_.line(), 1};
    if (!typed_.empty() && !has_types_) words_.fail(end, "the file ends here: CELL_TYPES is missing");
    // The values of polydata are in this order, whatever the order of the sections.
    for (auto* list : {&typed_, &lines_, &polygons_, &strips_})
      std::ranges::move(*list, std::back_inserter(grid_.cells));
    for (const VtkArray& array : attributes_.arrays())
      if (array.values.size() != grid_.cells.size())
        words_.fail(end, "array " + array.name + " comes before the end of the cells");
    grid_.arrays = std::move(attributes_.arrays());
    return mesh_of_grid(grid_);
  }

  const VtkType int_{"INT", {NumberType::Kind::whole, 4}};
  TokenReader words_;
  VtkNumbers numbers_{words_};
  VtkAttributes attributes_{words_, numbers_};
  VtkGrid grid_;
  std::vector<VtkCell> typed_, lines_, polygons_, strips_;
  bool has_types_ = false;
};

}  // namespace

Mesh parse_vtk(std::string_view text, const std::string& name) {
  return VtkParser(text, name).parse();
}

}  // namespace mesh
