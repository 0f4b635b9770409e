// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gas {

/// One reading is wrong; what() names series, value and what is allowed.
struct ReadingError : std::invalid_argument {
  ReadingError(std::string_view name, std::size_t at, const std::string& message)
      : std::invalid_argument(std::string(name) + ": " + message), series(name), index(at) {}
  std::string series;
  std::size_t index;
};

}  // namespace gas
