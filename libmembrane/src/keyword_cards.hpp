// SPDX-License-Identifier: Apache-2.0
// Private to the keyword reader: a card cut into fields.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace membrane {

struct CardField {
  std::string_view text;  // without the blanks around it, possibly empty
  std::size_t column;     // of its first character, from 1
};

/// Cuts a card at its commas if it has one, else into columns of the given widths; what lies beyond the last
/// width is not read. The result has at least as many fields as there are widths, the missing ones empty at
/// the card's end.
std::vector<CardField> card_fields(std::string_view card, std::span<const std::size_t> widths);

}  // namespace membrane
