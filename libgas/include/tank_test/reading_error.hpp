// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gas {

/// One reading is wrong. what() names the series, the value and what is allowed.
struct ReadingError : std::invalid_argument {
  /// Reading `at` (from 0) of the series `name`. `message` gives its value and what is allowed.
  ReadingError(std::string_view name, std::size_t at, const std::string& message)
      : std::invalid_argument(std::string(name) + ": " + message), series(name), index(at) {}
  std::string series;  // "time", or the name given for the readings
  std::size_t index;   // of the reading, from 0
};

}  // namespace gas
