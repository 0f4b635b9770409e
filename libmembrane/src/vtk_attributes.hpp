// SPDX-License-Identifier: Apache-2.0
// Private to the reader of VTK files: sections of values at cells and points.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace membrane {

inline std::string upper_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

inline bool is_whole_number_type(const std::string& type) {
  static constexpr std::array<std::string_view, 12> types = {
      "BIT", "UNSIGNED_CHAR", "CHAR", "UNSIGNED_SHORT", "SHORT",        "UNSIGNED_INT",
      "INT", "UNSIGNED_LONG", "LONG", "VTKIDTYPE",      "VTKTYPEINT64", "VTKTYPEUINT64"};
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// Passes over so many words.
inline void skip(TokenReader& words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) words.word("a value");
}

/// Sections of values. The first whole number of each cell names its panel.
class VtkAttributes {
 public:
  explicit VtkAttributes(TokenReader& words) : words_(words) {}

  /// Reads the section `key`, if it is one of values; `cells` and `points` are those of the file so far.
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

  /// Name of the panel of each cell, skipped ones first; empty if the file names none.
  const std::vector<std::string>& panels() const { return panels_; }

 private:
  enum class Of { none, cells, points };

  void begin(const MeshWord& at, Of of, std::size_t expected) {
    of_ = of;
    count_ = words_.count("the number of values");
    if (count_ != expected)
      words_.fail(at, std::to_string(count_) + " values for " + std::to_string(expected) +
                          (of == Of::cells ? " cells" : " points"));
  }

  void scalars(const MeshWord& at) {
    if (of_ == Of::none) words_.fail(at, "SCALARS stands before CELL_DATA and POINT_DATA");
    const std::string name = panel_name(words_.word("a name").text);
    const std::string type = upper_case(words_.word("a type").text);
    const std::string_view rest = words_.rest_of_line();
    const std::size_t components = rest.empty() ? 1 : rest == "1" ? 1 : rest == "2" ? 2 : rest == "3" ? 3 : 4;
    if (upper_case(words_.peek("the values").text) == "LOOKUP_TABLE") skip(words_, 2);
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
    const bool are_panels = of_ == Of::cells && panels_.empty() && components == 1 &&
                            is_whole_number_type(type) && count == cells_;
    if (!are_panels) return skip(words_, components * count);
    for (std::size_t i = 0; i < count; ++i)
      panels_.push_back(name + "_" + std::string(words_.word("a value").text));
  }

  // Up to the next empty line.
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
  std::size_t count_ = 0;  // of values in the sections that follow
  std::size_t cells_ = 0;
  std::vector<std::string> panels_;
};

}  // namespace membrane
