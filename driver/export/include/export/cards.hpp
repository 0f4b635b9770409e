// SPDX-License-Identifier: Apache-2.0
// Lines of fields of fixed width.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace driver {

/// A field: text of at most its width, aligned to the right.
struct Field {
  std::string text;
  std::size_t width;
};

/// An integer.
Field whole(long value, std::size_t width);
/// A number with as many digits as fit, at most those of a double; one column stays blank.
Field real(double value, std::size_t width);
/// A number that may fill all of its ten columns: five digits or more, four if it is negative, without idle
/// zeros.
Field narrow(double value);
Field blank(std::size_t width);
Field word(std::string_view text, std::size_t width);

inline constexpr std::size_t title_columns = 80;  // width of a deck's title

/// Text of a deck that grows line by line.
class Cards {
 public:
  void line(std::string_view text) { text_.append(text).push_back('\n'); }
  /// A user's name in one line of `columns`: "_" replaces characters that are not printable ASCII, and
  /// precedes a character that would begin a keyword or a comment.
  void label(std::string_view text, std::size_t columns);
  /// Throws std::logic_error for a field longer than its width.
  void card(const std::vector<Field>& fields);
  /// Integers of one width, `per_line` in a line.
  void list(const std::vector<int>& values, std::size_t width, std::size_t per_line = 10);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace driver
