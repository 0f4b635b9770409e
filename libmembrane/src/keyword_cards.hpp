// SPDX-License-Identifier: Apache-2.0
// Private to the keyword reader: a card cut into fields.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace membrane {

struct CardField {
  std::string_view text;  // without surrounding blanks, possibly empty
  std::size_t column;     // of its first character, from 1
};

/// Splits a card at its commas or, if it has none, into columns of the given widths. Text beyond the last
/// width is not read. The result has at least as many fields as there are widths; missing fields are empty
/// and stand at the card's end.
std::vector<CardField> card_fields(std::string_view card, std::span<const std::size_t> widths);

}  // namespace membrane
