// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: a card cut into fields.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "deck_mesh.hpp"

namespace mesh {

/// Cut at the commas of the line or, if it has none, into columns of the given widths, where a tab is
/// refused. Text beyond the last width is not read; a field that is missing is blank and stands at the line's
/// end.
class DeckCard {
 public:
  /// `deck` gives messages their file's name.
  DeckCard(const DeckMesh& deck, int file, std::size_t line, std::string_view text,
           std::span<const std::size_t> widths);

  bool blank_or_zero(std::size_t i) const { return fields_[i].text.empty() || fields_[i].text == "0"; }
  Place place(std::size_t i) const { return {file_, line_, fields_[i].column}; }
  /// A whole number above 0, or nothing.
  std::optional<DeckMesh::Id> whole(std::size_t i) const;
  /// Throw MeshFileError; `what` begins the message.
  DeckMesh::Id id(std::size_t i, const char* what) const;
  double number(std::size_t i) const;      // 0 if blank
  double coordinate(std::size_t i) const;  // 0 if blank, and refused if the line ends before it does
  Eigen::Vector3d point(std::size_t first) const;
  DeckMesh::Corner corner(std::size_t i) const { return {id(i, "a corner"), place(i)}; }

 private:
  struct Field {
    std::string_view text;  // without surrounding blanks, possibly empty
    std::size_t column;     // of its first character, from 1
    bool whole = true;      // false: the line ends before the field does
  };

  const DeckMesh& deck_;
  int file_;
  std::size_t line_;
  std::vector<Field> fields_;
};

}  // namespace mesh
