// SPDX-License-Identifier: Apache-2.0
#include "export/cards.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace driver {
namespace {

// "0.5e-05" becomes ".5e-5".
std::string without_idle_zeros(std::string text) {
  if (const auto e = text.find('e'); e != std::string::npos) {
    std::size_t from = e + 1;
    if (text[from] == '+') text.erase(from, 1);
    if (text[from] == '-') ++from;
    while (from + 1 < text.size() && text[from] == '0') text.erase(from, 1);
  }
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (text.size() > first + 1 && text[first] == '0' && text[first + 1] == '.') text.erase(first, 1);
  return text;
}

// The value, where -0 is 0.
double finite(double value) {
  if (!std::isfinite(value)) throw std::logic_error(fmt::format("a deck cannot represent {}", value));
  return value + 0.0;
}

}  // namespace

Field whole(long value, std::size_t width) {
  return {fmt::format("{}", value), width};
}

Field real(double value, std::size_t width) {
  value = finite(value);
  constexpr int digits = 15;
  for (int precision = digits; precision > 0; --precision) {
    std::string text = fmt::format("{:.{}g}", value, precision);
    if (text.find_first_of(".e") == std::string::npos) text += '.';  // some readers take "1" for an integer
    if (text.size() < width) return {std::move(text), width};
  }
  throw std::logic_error(fmt::format("{} does not fit {} columns", value, width));
}

Field narrow(double value) {
  value = finite(value);
  constexpr std::size_t width = 10;
  constexpr int digits = 15;
  std::string best;
  for (int precision = digits; precision > 0; --precision) {
    std::string text = without_idle_zeros(fmt::format("{:.{}g}", value, precision));
    if (text.find_first_of(".e") == std::string::npos) text += '.';
    if (text.size() > width) continue;
    const auto error = [value](const std::string& of) {
      return std::abs(std::strtod(of.c_str(), nullptr) - value);
    };
    if (best.empty() || (text.size() < best.size() && error(text) <= error(best))) best = std::move(text);
  }
  if (best.empty()) throw std::logic_error(fmt::format("{} does not fit {} columns", value, width));
  return {std::move(best), width};
}

Field blank(std::size_t width) {
  return {{}, width};
}

Field word(std::string_view text, std::size_t width) {
  return {std::string(text), width};
}

void Cards::label(std::string_view text, std::size_t columns) {
  std::string line;
  if (text.find_first_of("*/$#") == 0) line = "_";
  line.append(text);
  for (char& c : line)
    if (c < ' ' || c > '~') c = '_';
  this->line(std::string_view(line).substr(0, columns));
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
