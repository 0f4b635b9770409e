// SPDX-License-Identifier: Apache-2.0
// Private to the reader of legacy VTK files: sections of values at cells and points.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_text.hpp"
#include "mesh_tokens.hpp"
#include "vtk_grid.hpp"
#include "vtk_numbers.hpp"

namespace mesh {

/// Reads sections of values, and keeps values of cells that may be panels.
class VtkAttributes {
 public:
  VtkAttributes(TokenReader& words, VtkNumbers& numbers) : words_(words), numbers_(numbers) {}

  /// Reads the section `key` if it has values; `cells` and `points` are their numbers in the file so far.
  bool read(const std::string& key, const MeshWord& word, std::size_t cells, std::size_t points) {
    cells_ = cells;
    if (key == "CELL_DATA")
      begin(word, Of::cells, cells);
    else if (key == "POINT_DATA")
      begin(word, Of::points, points);
    else if (key == "SCALARS")
      scalars(word);
    else if (key == "FIELD")
      field();
    else if (key == "METADATA")
      metadata();
    else if (key == "VECTORS" || key == "NORMALS")
      skip_named(3);
    else if (key == "GLOBAL_IDS" || key == "PEDIGREE_IDS")
      skip_named(1);
    else if (key == "TENSORS" || key == "TENSORS6")
      skip_named(key == "TENSORS" ? 9 : 6);
    else if (key == "TEXTURE_COORDINATES" || key == "COLOR_SCALARS")
      skip_dimensioned(key == "TEXTURE_COORDINATES");
    else if (key == "LOOKUP_TABLE")
      skip_table();
    else
      return false;
    return true;
  }

  std::vector<VtkArray>& arrays() { return arrays_; }

 private:
  enum class Of { none, cells, points };

  void begin(const MeshWord& at, Of of, std::size_t expected) {
    of_ = of;
    count_ = static_cast<std::size_t>(
        words_.integer("the number of values", 0, std::numeric_limits<int>::max()));  // nothing has to follow
    if (count_ != expected && count_ != 0)
      words_.fail(at, std::to_string(count_) + " values for " + std::to_string(expected) +
                          (of == Of::cells ? " cells" : " points"));
  }

  void scalars(const MeshWord& at) {
    if (of_ == Of::none) words_.fail(at, "SCALARS comes before CELL_DATA and POINT_DATA");
    const std::string name = panel_name(words_.word("a name").text);
    const VtkType type = numbers_.type("a type");
    const std::string_view rest = words_.rest_of_line();
    const std::size_t components = rest.empty() ? 1 : rest == "1" ? 1 : rest == "2" ? 2 : rest == "3" ? 3 : 4;
    if (numbers_.is_binary() ||
        (!words_.at_end() && upper_case(words_.peek("the values").text) == "LOOKUP_TABLE")) {
      words_.expect("LOOKUP_TABLE");
      words_.word("the name of a table");
    }
    values(name, type, components, count_);
  }

  // A field may belong to the file, the cells or the points.
  void field() {
    words_.word("a name");
    const std::size_t arrays = words_.count("the number of arrays");
    for (std::size_t i = 0; i < arrays; ++i) {
      const std::string name = panel_name(words_.word("a name").text);
      const std::size_t components = words_.count("the number of components");
      const auto count = static_cast<std::size_t>(
          words_.integer("the number of values", 0, std::numeric_limits<int>::max()));
      const VtkType type = numbers_.type("a type");
      values(name, type, components, count);
      if (!words_.at_end() && upper_case(words_.peek("").text) == "METADATA") {
        words_.word("");
        metadata();
      }
    }
  }

  void values(const std::string& name, const VtkType& type, std::size_t components, std::size_t count) {
    const bool are_kept = of_ == Of::cells && components == 1 && type.is_whole() && count == cells_;
    if (!are_kept) return numbers_.skip(components * count, type);
    arrays_.push_back({name, numbers_.wholes(count, type)});
  }

  // Skips to the next empty line.
  void metadata() {
    words_.rest_of_line();
    do words_.next_line();
    while (!words_.rest_of_line().empty());
  }

  void skip_named(std::size_t components) {
    words_.word("a name");
    const VtkType type = numbers_.type("a type");
    numbers_.skip(components * count_, type);
  }
  // Colours are numbers from 0 to 1 in words, and bytes in a binary file.
  void skip_dimensioned(bool has_type) {
    words_.word("a name");
    const auto components = static_cast<std::size_t>(words_.integer("the number of components", 1, 4));
    const VtkType type = has_type ? numbers_.type("a type") : byte_;
    numbers_.skip(components * count_, type);
  }
  void skip_table() {
    words_.word("a name");
    const std::size_t size = words_.count("the size of the table");
    numbers_.skip(4 * size, byte_);
  }

  const VtkType byte_{"UNSIGNED_CHAR", {NumberType::Kind::unsigned_whole, 1}};
  TokenReader& words_;
  VtkNumbers& numbers_;
  Of of_ = Of::none;
  std::size_t count_ = 0;  // number of values in the following sections
  std::size_t cells_ = 0;
  std::vector<VtkArray> arrays_;
};

}  // namespace mesh
