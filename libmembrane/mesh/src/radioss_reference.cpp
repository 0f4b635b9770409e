// SPDX-License-Identifier: Apache-2.0
#include "radioss_reference.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "deck_card.hpp"

namespace mesh {
namespace {

bool holds_nothing(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

// RunnameRS0, beside Runname_0000.rad.
std::string default_name(const std::string& deck) {
  std::string run = std::filesystem::path(deck).stem().string();
  if (const auto number = run.rfind('_'); number != std::string::npos) run.resize(number);
  return run + "RS0";
}

}  // namespace

void RadiossReference::read(std::string_view line, int file, std::size_t number) {
  if (block_ == Block::file) {
    if (!std::exchange(has_file_, true)) {
      file_ = holds_nothing(line) ? default_name(deck_.first_file()) : std::string(line);
      file_place_ = {file, number, 1};
      return;
    }
    const DeckCard card(deck_, file, number, line, std::array<std::size_t, 2>{10, 10});
    const bool is_short = card.whole(1) == 1;
    block_ = Block::none;
    return include(is_short);
  }
  if (heads_ > 0) {
    constexpr std::size_t nitrs_end = 10;
    const bool is_node =
        line.find(',') != line.npos || !holds_nothing(line.substr(std::min(nitrs_end, line.size())));
    if (--heads_ == 0 && block_ == Block::nodes && is_node)
      deck_.fail({file, number, 1}, "the card of Nitrs is missing before the nodes of /XREF");
    return;
  }
  if (holds_nothing(line)) return;
  if (block_ == Block::nodes) return node(line, file, number, false);
  const DeckCard card(deck_, file, number, line, std::array<std::size_t, 5>{10, 10, 10, 10, 10});
  std::vector<DeckCorner> corners{card.corner(1), card.corner(2), card.corner(3)};
  if (!card.blank_or_zero(4)) corners.push_back(card.corner(4));
  deck_.reference.add_shell(card.id(0, "the element's number"), std::move(corners));
}

void RadiossReference::finish() {
  if (block_ == Block::file && has_file_) include(false);
  block_ = Block::none;
}

void RadiossReference::include(bool is_short) {
  has_file_ = false;
  deck_.reference.begin(0);
  files_.include(deck_, file_place_, file_, [&](std::string_view text, const std::string& name) {
    const int file = deck_.open(name);
    for (std::size_t line = 1; !text.empty(); ++line)
      if (const auto card = take_line(text); !card.starts_with('#') && !holds_nothing(card))
        node(card, file, line, is_short);
  });
}

void RadiossReference::node(std::string_view line, int file, std::size_t number, bool is_short) {
  const std::size_t of_id = is_short ? 8 : 10, of_place = is_short ? 16 : 20;
  const DeckCard card(deck_, file, number, line, std::array{of_id, of_place, of_place, of_place});
  deck_.reference.add_node(card.id(0, "the node's number"), card.point(1));
}

}  // namespace mesh
