// SPDX-License-Identifier: Apache-2.0
#include "import/deck_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/case_reader.hpp"
#include "deck_reader.hpp"
#include "mesh/fortran_number.hpp"

namespace driver::imported {
namespace {

bool reads(std::string_view text, double& value) {
  std::string number = mesh::without_fortran_exponent(text);
  if (number.starts_with('+')) number.erase(0, 1);
  const char* last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, value);
  return error == std::errc() && end == last && std::isfinite(value);
}

constexpr int long_width = 20;

}  // namespace

bool DeckFields::cut_at_commas(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    add(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return true;
}

DeckFields::DeckFields(const DeckText& deck, const DeckCard& card, const DeckLine& line,
                       std::initializer_list<int> widths)
    : deck_(&deck), at_(line.at.line > 0 ? line.at : card.at) {
  if (cut_at_commas(line.text)) return;
  std::size_t begin = 0;
  for (const int width : widths) {
    const auto columns = static_cast<std::size_t>(card.is_long ? long_width : width);
    add(begin < line.text.size() ? line.text.substr(begin, columns) : std::string_view());
    begin += columns;
  }
}

DeckFields::DeckFields(const DeckText& deck, const DeckCard& card, const DeckLine& line, int width)
    : deck_(&deck), at_(line.at.line > 0 ? line.at : card.at) {
  if (cut_at_commas(line.text)) return;
  const auto columns = static_cast<std::size_t>(card.is_long ? long_width : width);
  for (std::size_t begin = 0; begin < line.text.size(); begin += columns)
    add(line.text.substr(begin, columns));
}

void DeckFields::add(std::string_view text) {
  const std::string_view field = without_blanks(text);
  if (count_ < fields_.size())
    fields_[count_++] = field;
  else if (!field.empty())
    throw DeckFault(at_, fmt::format("has more than {} fields", fields_.size()));
}

double DeckFields::real(std::size_t i, const char* name, double fallback) const {
  const std::string_view field = text(i);
  if (field.empty()) return fallback;
  double value = 0.0;
  if (reads(field, value)) return value;
  const bool minus = field.starts_with("-&");
  if (minus || field.starts_with('&')) {
    const auto found = deck_->parameters.find(in_small_letters(without_blanks(field.substr(minus ? 2 : 1))));
    if (found != deck_->parameters.end()) return minus ? -found->second : found->second;
    throw DeckFault(at(), fmt::format("{} is the parameter {}, which the deck does not define", name, field));
  }
  throw DeckFault(at(), fmt::format("{} is '{}', allowed: a number", name, shortened(std::string(field))));
}

long DeckFields::whole(std::size_t i, const char* name, long fallback) const {
  const double value = real(i, name, static_cast<double>(fallback));
  constexpr double most = 1e15;
  if (value != std::floor(value) || std::abs(value) > most)
    throw DeckFault(at(), fmt::format("{} is '{}', allowed: a whole number", name, text(i)));
  return static_cast<long>(value);
}

std::vector<const DeckLine*> filled(const DeckCard& card, std::size_t from) {
  std::vector<const DeckLine*> lines;
  for (std::size_t i = from; i < card.lines.size(); ++i)
    if (!without_blanks(card.lines[i].text).empty()) lines.push_back(&card.lines[i]);
  return lines;
}

const DeckLine& line_or_blank(const DeckCard& card, std::size_t i) {
  static const DeckLine blank{};
  return i < card.lines.size() ? card.lines[i] : blank;
}

}  // namespace driver::imported
