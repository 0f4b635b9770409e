// SPDX-License-Identifier: Apache-2.0
// Lines of fields of fixed width.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace driver {

/// A field: text of at most its width, to the right of it.
struct Field {
  std::string text;
  std::size_t width;
};

/// A whole number.
Field whole(long value, std::size_t width);
/// A number with as many digits as fit, up to those that a double has; one column is left blank.
Field real(double value, std::size_t width);
/// A number in ten columns, all of which it may fill: five digits or more, four if it is negative. Zeros that
/// say nothing are left out of it.
Field narrow(double value);
Field blank(std::size_t width);
Field word(std::string_view text, std::size_t width);

inline constexpr std::size_t title_columns = 80;  // of a deck

/// Text of a deck that grows line by line.
class Cards {
 public:
  void line(std::string_view text) { text_.append(text).push_back('\n'); }
  /// A name of the user's in one line of `columns`: "_" stands for what is not printable ASCII, and before
  /// what would begin a keyword or a comment.
  void label(std::string_view text, std::size_t columns);
  /// Throws std::logic_error for a field that is longer than its width.
  void card(const std::vector<Field>& fields);
  /// Whole numbers of one width, `per_line` in a line.
  void list(const std::vector<int>& values, std::size_t width, std::size_t per_line = 10);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace driver
