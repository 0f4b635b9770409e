// SPDX-License-Identifier: Apache-2.0
// Private to the reader of VTK files: sections of values at cells and points.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {

inline bool is_whole_number_type(const std::string& type) {
  static constexpr std::array<std::string_view, 12> types = {
      "BIT", "UNSIGNED_CHAR", "CHAR", "UNSIGNED_SHORT", "SHORT",        "UNSIGNED_INT",
      "INT", "UNSIGNED_LONG", "LONG", "VTKIDTYPE",      "VTKTYPEINT64", "VTKTYPEUINT64"};
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// Skips `count` words.
inline void skip(TokenReader& words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) words.word("a value");
}

/// An integer for each cell of a file, skipped cells first.
struct CellNumbers {
  std::string name;
  std::vector<std::string_view> values;
};

/// Reads sections of values, and keeps values of cells that may be panels.
class VtkAttributes {
 public:
  explicit VtkAttributes(TokenReader& words) : words_(words) {}

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
    else if (key == "TENSORS")
      skip_named(9);
    else if (key == "TEXTURE_COORDINATES" || key == "COLOR_SCALARS")
      skip_dimensioned(key == "TEXTURE_COORDINATES");
    else if (key == "LOOKUP_TABLE")
      skip_table();
    else
      return false;
    return true;
  }

  const std::vector<CellNumbers>& cell_numbers() const { return cell_numbers_; }

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
    const std::string type = upper_case(words_.word("a type").text);
    const std::string_view rest = words_.rest_of_line();
    const std::size_t components = rest.empty() ? 1 : rest == "1" ? 1 : rest == "2" ? 2 : rest == "3" ? 3 : 4;
    if (!words_.at_end() && upper_case(words_.peek("the values").text) == "LOOKUP_TABLE") skip(words_, 2);
    values(name, type, components, count_);
  }

  // A field may belong to the file, the cells or the points.
  void field() {
    words_.word("a name");
    const std::size_t arrays = words_.count("the number of arrays");
    for (std::size_t i = 0; i < arrays; ++i) {
      const std::string name = panel_name(words_.word("a name").text);
      const std::size_t components = words_.count("the number of components");
      const std::size_t count = words_.count("the number of values");
      const std::string type = upper_case(words_.word("a type").text);
      values(name, type, components, count);
      if (!words_.at_end() && upper_case(words_.peek("").text) == "METADATA") {
        words_.word("");
        metadata();
      }
    }
  }

  void values(const std::string& name, const std::string& type, std::size_t components, std::size_t count) {
    const bool are_kept =
        of_ == Of::cells && components == 1 && is_whole_number_type(type) && count == cells_;
    if (!are_kept) return skip(words_, components * count);
    cell_numbers_.push_back({name, {}});
    for (std::size_t i = 0; i < count; ++i)
      cell_numbers_.back().values.push_back(words_.word("a value").text);
  }

  // Skips to the next empty line.
  void metadata() {
    words_.rest_of_line();
    do words_.next_line();
    while (!words_.rest_of_line().empty());
  }

  void skip_named(std::size_t components) {
    skip(words_, 2);
    skip(words_, components * count_);
  }
  void skip_dimensioned(bool has_type) {
    words_.word("a name");
    const auto components = static_cast<std::size_t>(words_.integer("the number of components", 1, 4));
    if (has_type) words_.word("a type");
    skip(words_, components * count_);
  }
  void skip_table() {
    words_.word("a name");
    skip(words_, 4 * words_.count("the size of the table"));
  }

  TokenReader& words_;
  Of of_ = Of::none;
  std::size_t count_ = 0;  // number of values in the following sections
  std::size_t cells_ = 0;
  std::vector<CellNumbers> cell_numbers_;
};

}  // namespace mesh
