// SPDX-License-Identifier: Apache-2.0
#include "export/cards.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace driver {

Field whole(long value, std::size_t width) {
  return {fmt::format("{}", value), width};
}

Field real(double value, std::size_t width) {
  constexpr int digits = 15;
  for (int precision = digits; precision > 0; --precision) {
    std::string text = fmt::format("{:.{}g}", value, precision);
    if (text.find_first_of(".e") == std::string::npos)
      text += '.';  // some readers take "1" for a whole number
    if (text.size() < width) return {std::move(text), width};
  }
  throw std::logic_error(fmt::format("{} does not fit {} columns", value, width));
}

Field blank(std::size_t width) {
  return {{}, width};
}

Field word(std::string_view text, std::size_t width) {
  return {std::string(text), width};
}

void Cards::card(const std::vector<Field>& fields) {
  for (const auto& [text, width] : fields) {
    if (text.size() > width) throw std::logic_error(fmt::format("'{}' does not fit {} columns", text, width));
    text_.append(width - text.size(), ' ').append(text);
  }
  text_.push_back('\n');
}

void Cards::list(const std::vector<int>& values, std::size_t width, std::size_t per_line) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    text_ += fmt::format("{:>{}}", values[i], width);
    if ((i + 1) % per_line == 0 || i + 1 == values.size()) text_.push_back('\n');
  }
}

}  // namespace driver
