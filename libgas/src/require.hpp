// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gas {

/// Shortest decimal text that reads back as `value`.
inline std::string to_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

/// The same in `digits` digits, unless all of them take no more room: 6000 rather than 6e+03.
inline std::string to_short_text(double value, int digits = 3) {
  char buffer[32];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  const std::string text = to_text(value), rounded(buffer, result.ptr);
  return text.size() <= rounded.size() ? text : rounded;
}

/// `value` in three digits, or in more if `other` would have the same text.
inline std::string to_text_beside(double value, double other) {
  int digits = 3;
  while (digits < 17 && value != other && to_short_text(value, digits) == to_short_text(other, digits))
    ++digits;
  return to_short_text(value, digits);
}

/// A positive limit in three digits, rounded down: the text read as a number is within the limit.
inline std::string to_text_below(double limit) {
  const std::string text = to_short_text(limit);
  double nearest = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), nearest);
  return nearest <= limit ? text : to_short_text(0.995 * limit);
}

/// Throws std::invalid_argument "field = value: allowed" unless `ok`.
inline void require(bool ok, std::string_view field, double value, std::string_view allowed) {
  if (ok) return;
  throw std::invalid_argument(std::string(field) + " = " + to_text(value) + ": " + std::string(allowed));
}

}  // namespace gas
