// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: words of a text with their positions, and bytes between them.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace mesh {

/// A word and its position.
struct MeshWord {
  std::string_view text;
  std::size_t line, column;  // from 1
};

inline std::string upper_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

/// Reads a text word by word. All faults are MeshFileError at the word.
class TokenReader {
 public:
  TokenReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  const std::string& name() const { return name_; }
  std::size_t line() const { return line_; }
  /// True if no word is left.
  bool at_end();
  /// Reads the next word. `what` describes it in the message if the file ends here.
  MeshWord word(const char* what);
  /// The next word, without reading it.
  MeshWord peek(const char* what);
  /// Reads the next word, which must be `text`, in capitals or not.
  MeshWord expect(std::string_view text);
  /// Reads a finite number.
  double number(const char* what);
  /// Reads an integer from `low` to `high`.
  long long integer(const char* what, long long low, long long high);
  /// Reads the number of items that follow. Throws if the rest of the file is too short for them, at two
  /// characters each.
  std::size_t count(const char* what);
  /// Reads the rest of the line, without white space at its ends.
  std::string_view rest_of_line();
  /// Goes to the line after this one.
  void next_line();
  /// The next `count` bytes, as they are. From now on places in messages are bytes.
  std::string_view bytes(std::size_t count, const char* what);
  /// Number of bytes that are left.
  std::size_t left() const { return text_.size() - at_; }
  /// True if `text` comes next: as a word, in capitals or not, or before any bytes.
  bool begins_with(std::string_view text);
  /// Goes to the next line that begins with `text`.
  void find_line(const std::string& text);
  [[noreturn]] void fail(const MeshWord& at, const std::string& message) const;

 private:
  void skip_blanks();

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, line_ = 1, line_begin_ = 0;
  bool has_bytes_ = false;
};

}  // namespace mesh
