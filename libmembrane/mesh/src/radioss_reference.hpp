// SPDX-License-Identifier: Apache-2.0
// Private to the reader of Radioss decks: cards of the reference state.
#pragma once

#include <string>
#include <string_view>

#include "deck_files.hpp"
#include "deck_mesh.hpp"

namespace mesh {

/// Cards of /XREF (a title, Nitrs, nodes of one part with their positions), /EREF/SHELL and /EREF/SH3N (a
/// title, shells with the nodes at which their corners are) and /REFSTA (a file of nodes with their
/// positions, then Nitrs and the file's format).
class RadiossReference {
 public:
  RadiossReference(DeckMesh& deck, DeckFiles& files) : deck_(deck), files_(files) {}

  /// False if the block is a different one. `part` reads the number of the block's part.
  template <class Part>
  bool begins(std::string_view line, const Part& part) {
    finish();
    block_ = line.starts_with("/XREF")      ? Block::nodes
             : line.starts_with("/EREF/SH") ? Block::shells
             : line.starts_with("/REFSTA")  ? Block::file
                                            : Block::none;
    heads_ = block_ == Block::nodes ? 2 : block_ == Block::shells ? 1 : 0;
    if (block_ == Block::nodes) deck_.reference.begin(part());
    return block_ != Block::none;
  }
  /// The next card; it may be blank.
  void read(std::string_view line, int file, std::size_t number);
  /// No card follows.
  void finish();

 private:
  enum class Block { none, nodes, shells, file };

  void include(bool is_short);
  void node(std::string_view line, int file, std::size_t number, bool is_short);

  DeckMesh& deck_;
  DeckFiles& files_;
  Block block_ = Block::none;
  int heads_ = 0;     // remaining cards of the block before its list
  std::string file_;  // file of /REFSTA, once named
  Place file_place_{};
  bool has_file_ = false;
};

}  // namespace mesh
