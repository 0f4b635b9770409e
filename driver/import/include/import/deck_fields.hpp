// SPDX-License-Identifier: Apache-2.0
// Fields of a line of a deck: columns or commas, numbers in Fortran's notation, parameters by name.
#pragma once

#include <array>
#include <initializer_list>
#include <string>

#include "import/deck_text.hpp"

namespace driver::imported {

/// A line cut into fields. Fields beyond its end are blank.
class DeckFields {
 public:
  /// Columns of these widths, or what is between commas. In long format all fields have 20 columns.
  DeckFields(const DeckText& deck, const DeckCard& card, const DeckLine& line,
             std::initializer_list<int> widths);
  /// As many fields of one width as the line has.
  DeckFields(const DeckText& deck, const DeckCard& card, const DeckLine& line, int width);

  std::size_t size() const { return count_; }
  Place at() const { return at_; }
  bool blank(std::size_t i) const { return text(i).empty(); }
  std::string_view text(std::size_t i) const { return i < count_ ? fields_[i] : std::string_view(); }
  /// These throw DeckFault for other text; a blank field has the fallback. `name` is the field's, for
  /// messages.
  double real(std::size_t i, const char* name, double fallback = 0.0) const;
  long whole(std::size_t i, const char* name, long fallback = 0) const;

 private:
  bool cut_at_commas(std::string_view text);
  void add(std::string_view text);

  const DeckText* deck_;
  Place at_;
  std::array<std::string_view, 24> fields_;
  std::size_t count_ = 0;
};

/// A factor, for which a blank field or 0 means 1.
inline double or_one(double value) {
  return value == 0.0 ? 1.0 : value;
}

/// The lines of a card that are not blank.
std::vector<const DeckLine*> filled(const DeckCard& card, std::size_t from = 0);

/// The line of this number; blank beyond the end of the card.
const DeckLine& line_or_blank(const DeckCard& card, std::size_t i);

}  // namespace driver::imported
