// SPDX-License-Identifier: Apache-2.0
#include "keyword_reference.hpp"

#include <array>
#include <utility>

#include "deck_card.hpp"

namespace mesh {
namespace {

// Columns in the standard and in the long format.
using ColumnWidths = std::array<std::vector<std::size_t>, 2>;
const ColumnWidths kReferenceNodes{{{8, 16, 16, 16}, {20, 20, 20, 20}}};
const ColumnWidths kReferenceShells{{{8, 8, 8, 8, 8, 8}, {20, 20, 20, 20, 20, 20}}};
const ColumnWidths kReferenceScales{{{10, 10, 10, 10, 10}, {20, 20, 20, 20, 20}}};
const ColumnWidths kReferenceBirth{{{10}, {20}}};

}  // namespace

bool KeywordReference::begins(std::string_view word) {
  constexpr std::string_view nodes = "*AIRBAG_REFERENCE_GEOMETRY",
                             shells = "*AIRBAG_SHELL_REFERENCE_GEOMETRY";
  of_shells_ = word.starts_with(shells);
  if (!of_shells_ && !word.starts_with(nodes)) return false;
  has_id_ = has_birth_ = false;
  for (auto rest = word.substr(of_shells_ ? shells.size() : nodes.size()); !rest.empty();) {
    rest.remove_prefix(1);  // _
    const std::string_view option = rest.substr(0, rest.find('_'));
    if (option != "ID" && option != "BIRTH" && option != "RDT") return false;
    has_id_ = has_id_ || option == "ID";
    has_birth_ = has_birth_ || option == "BIRTH";
    rest.remove_prefix(option.size());
  }
  if (!of_shells_) deck_.reference.begin(0);
  return true;
}

void KeywordReference::read(std::string_view line, int file, std::size_t number, bool is_long) {
  if (std::exchange(has_id_, false)) return scales(line, file, number, is_long);
  if (std::exchange(has_birth_, false)) return birth(line, file, number, is_long);
  if (line.find_first_not_of(" \t") == std::string_view::npos) return;
  if (!of_shells_) {
    const DeckCard card(deck_, file, number, line, kReferenceNodes[is_long]);
    return deck_.reference.add_node(card.id(0, "the node's number"), card.point(1));
  }
  const DeckCard card(deck_, file, number, line, kReferenceShells[is_long]);
  std::vector<DeckCorner> corners{card.corner(2), card.corner(3), card.corner(4)};
  if (!card.blank_or_zero(5)) corners.push_back(card.corner(5));
  deck_.reference.add_shell(card.id(0, "the element's number"), std::move(corners));
}

void KeywordReference::scales(std::string_view line, int file, std::size_t number, bool is_long) {
  const DeckCard card(deck_, file, number, line, kReferenceScales[is_long]);
  Eigen::Vector3d scale;
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = card.number(i + 1);
    scale[static_cast<Eigen::Index>(i)] = value == 0.0 ? 1.0 : value;
  }
  if (!of_shells_)
    deck_.reference.begin(0, scale, card.whole(4).value_or(0));
  else if (scale != Eigen::Vector3d::Ones())
    deck_.neglect("SX, SY and SZ of *AIRBAG_SHELL_REFERENCE_GEOMETRY");
}

void KeywordReference::birth(std::string_view line, int file, std::size_t number, bool is_long) {
  if (DeckCard(deck_, file, number, line, kReferenceBirth[is_long]).number(0) > 0.0)
    deck_.neglect("BIRTH of *AIRBAG_REFERENCE_GEOMETRY, which acts from the start here");
}

}  // namespace mesh
