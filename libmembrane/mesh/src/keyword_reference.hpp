// SPDX-License-Identifier: Apache-2.0
// Private to the reader of keyword files: cards of the reference geometry.
#pragma once

#include <string_view>

#include "deck_mesh.hpp"

namespace mesh {

/// Cards of *AIRBAG_REFERENCE_GEOMETRY and *AIRBAG_SHELL_REFERENCE_GEOMETRY: with _ID a card of scales and
/// the node they are about, with _BIRTH a card with a time, then nodes with their positions, or shells with
/// the nodes at which their corners are. _RDT, about time steps, adds no card.
class KeywordReference {
 public:
  explicit KeywordReference(DeckMesh& deck) : deck_(deck) {}

  /// False if the keyword is another one.
  bool begins(std::string_view word);
  /// The next card; it may be blank. Cards of the long format have 20 columns a field.
  void read(std::string_view line, int file, std::size_t number, bool is_long);

 private:
  void scales(std::string_view line, int file, std::size_t number, bool is_long);
  void birth(std::string_view line, int file, std::size_t number, bool is_long);

  DeckMesh& deck_;
  bool of_shells_ = false, has_id_ = false, has_birth_ = false;  // what the keyword has
};

}  // namespace mesh
