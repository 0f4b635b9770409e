// SPDX-License-Identifier: Apache-2.0
#include "deck_card.hpp"

#include <charconv>
#include <string>

#include "mesh/fortran_number.hpp"
#include "mesh_text.hpp"

namespace mesh {

DeckCard::DeckCard(const DeckMesh& deck, int file, std::size_t line, std::string_view text,
                   std::span<const std::size_t> widths)
    : deck_(deck), file_(file), line_(line) {
  const bool free = text.find(',') != std::string_view::npos;
  for (std::size_t begin = 0, i = 0; begin < text.size() && (free || i < widths.size()); ++i) {
    const std::size_t end = std::min(free ? text.find(',', begin) : begin + widths[i], text.size());
    const std::string_view whole = text.substr(begin, end - begin);
    const std::size_t first = whole.find_first_not_of(" \t");
    if (const auto tab = whole.find('\t'); !free && tab != std::string_view::npos)
      deck.fail({file, line, begin + tab + 1}, "a tab in fields of columns, allowed: blanks or commas");
    if (first == std::string_view::npos)
      fields_.push_back({{}, begin + 1, free || whole.size() == widths[i]});
    else
      fields_.push_back({whole.substr(first, whole.find_last_not_of(" \t") + 1 - first), begin + first + 1});
    begin = end + (free ? 1 : 0);
  }
  while (fields_.size() < widths.size()) fields_.push_back({{}, text.size() + 1, false});
}

DeckMesh::Id DeckCard::id(std::size_t i, const char* what) const {
  if (const auto value = whole(i)) return *value;
  const std::string_view text = fields_[i].text;
  deck_.fail(place(i), std::string(what) + " is " + (text.empty() ? "blank" : shown(text)) +
                           ", allowed: a whole number above 0");
}

std::optional<DeckMesh::Id> DeckCard::whole(std::size_t i) const {
  const std::string_view text = fields_[i].text;
  DeckMesh::Id value = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (text.empty() || error != std::errc() || end != last || value <= 0) return std::nullopt;
  return value;
}

Eigen::Vector3d DeckCard::point(std::size_t first) const {
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i) point[static_cast<Eigen::Index>(i)] = coordinate(first + i);
  return point;
}

double DeckCard::number(std::size_t i) const {
  double value = 0.0;
  if (fields_[i].text.empty()) return value;
  if (!number_fault(without_fortran_exponent(fields_[i].text), value).empty())
    deck_.fail(place(i), number_fault(fields_[i].text, value));
  return value;
}

double DeckCard::coordinate(std::size_t i) const {
  if (fields_[i].text.empty() && !fields_[i].whole)
    deck_.fail(place(i), "a coordinate is blank, and the line ends; a node needs x, y and z");
  return number(i);
}

}  // namespace mesh
