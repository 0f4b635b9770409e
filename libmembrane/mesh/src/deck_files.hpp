// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: files that include others, line by line.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "deck_mesh.hpp"
#include "mesh_text.hpp"

namespace mesh {

/// Removes the next line from a text; returns it without its end.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Reads included files, and stops files that include themselves.
class DeckFiles {
 public:
  explicit DeckFiles(const IncludedFile& read) : read_(read) {}

  /// Calls parse(text, name) for the file that a card at `place` names.
  template <class Parse>
  void include(const DeckMesh& deck, const Place& place, std::string_view card, const Parse& parse) {
    const std::size_t first = card.find_first_not_of(" \t");
    const std::string name(card.substr(first, card.find_last_not_of(" \t") + 1 - first));
    if (!read_) deck.fail(place, "include: this text has no folder for other files");
    if (depth_ == 16 || ++count_ > 1000)
      deck.fail(place, "include: more than 1000 files, or more than 16 nested ones");
    ++depth_;
    parse(text_of(deck, place, name), name);
    --depth_;
  }

 private:
  std::string text_of(const DeckMesh& deck, const Place& place, const std::string& name) const {
    try {
      return read_(name);
    } catch (const MeshFileError& error) {
      deck.fail(place, std::string("include: ") + error.what());
    }
  }

  const IncludedFile& read_;
  int depth_ = 0, count_ = 0;
};

}  // namespace mesh
