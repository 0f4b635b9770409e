// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: a card cut into fields.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "deck_mesh.hpp"

namespace mesh {

/// Cuts a line at its commas or, if it has none, into columns of the given widths, which may not have tabs.
/// Text beyond the last width is not read; a missing field is blank, at the line's end.
class DeckCard {
 public:
  /// `deck` gives the file's name for messages.
  DeckCard(const DeckMesh& deck, int file, std::size_t line, std::string_view text,
           std::span<const std::size_t> widths);

  bool blank_or_zero(std::size_t i) const { return fields_[i].text.empty() || fields_[i].text == "0"; }
  Place place(std::size_t i) const { return {file_, line_, fields_[i].column}; }
  /// An integer above 0; empty for other text.
  std::optional<DeckMesh::Id> whole(std::size_t i) const;
  /// Throw MeshFileError; `what` begins the message.
  DeckMesh::Id id(std::size_t i, const char* what) const;
  double number(std::size_t i) const;      // 0 if blank
  double coordinate(std::size_t i) const;  // 0 if blank; throws if the line ends within the field
  Eigen::Vector3d point(std::size_t first) const;
  DeckMesh::Corner corner(std::size_t i) const { return {id(i, "a corner"), place(i)}; }

 private:
  struct Field {
    std::string_view text;  // without surrounding blanks, possibly empty
    std::size_t column;     // column of its first character, from 1
    bool whole = true;      // false: the line ends within the field
  };

  const DeckMesh& deck_;
  int file_;
  std::size_t line_;
  std::vector<Field> fields_;
};

}  // namespace mesh
