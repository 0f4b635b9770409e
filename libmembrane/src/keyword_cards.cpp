// SPDX-License-Identifier: Apache-2.0
#include "keyword_cards.hpp"

#include <algorithm>

namespace membrane {
namespace {

CardField trimmed(std::string_view card, std::size_t begin, std::size_t end) {
  const auto is_blank = [&](std::size_t i) { return card[i] == ' ' || card[i] == '\t'; };
  std::size_t first = begin;
  while (first < end && is_blank(first)) ++first;
  while (end > first && is_blank(end - 1)) --end;
  return {card.substr(first, end - first), (first == end ? begin : first) + 1};
}

}  // namespace

std::vector<CardField> card_fields(std::string_view card, std::span<const std::size_t> widths) {
  std::vector<CardField> fields;
  const bool free = card.find(',') != std::string_view::npos;
  for (std::size_t begin = 0, i = 0; begin < card.size(); ++i) {
    if (!free && i == widths.size()) break;
    const std::size_t end = std::min(free ? card.find(',', begin) : begin + widths[i], card.size());
    fields.push_back(trimmed(card, begin, end));
    begin = end + (free ? 1 : 0);
  }
  while (fields.size() < widths.size()) fields.push_back({{}, card.size() + 1});
  return fields;
}

}  // namespace membrane
