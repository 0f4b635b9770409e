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

/// The same in three digits.
inline std::string to_short_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3);
  return {buffer, result.ptr};
}

/// Throws std::invalid_argument "field = value: allowed" unless `ok`.
inline void require(bool ok, std::string_view field, double value, std::string_view allowed) {
  if (ok) return;
  throw std::invalid_argument(std::string(field) + " = " + to_text(value) + ": " + std::string(allowed));
}

}  // namespace gas
