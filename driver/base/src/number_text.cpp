// SPDX-License-Identifier: Apache-2.0
#include "base/number_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "mesh/fortran_number.hpp"

namespace driver {
namespace {

template <class Number>
std::errc parse(std::string_view text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop != end ? std::errc::invalid_argument : error;
}

}  // namespace

std::optional<double> number_of(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const std::errc error = parse(text, value);
  if (error == std::errc{} && std::isfinite(value)) return value;
  // Outside the range of double: too large, or nearly 0?
  long double wide = 1.0L;
  if (error == std::errc::result_out_of_range && parse(text, wide) == std::errc{} && std::abs(wide) < 1.0L)
    return 0.0;
  return std::nullopt;
}

std::optional<double> file_number_of(std::string_view text) {
  if (const auto value = number_of(text)) return value;
  // An exponent without its letter has three digits; 1.5-2 is a slip.
  const auto sign = text.find_last_of("+-");
  if (text.find_first_of("dD") == text.npos && (sign == text.npos || text.size() != sign + 4))
    return std::nullopt;
  return number_of(mesh::without_fortran_exponent(text));
}

std::optional<double> fraction_of(std::string_view text) {
  const bool percent = text.ends_with('%');
  auto value = number_of(text.substr(0, text.size() - (percent ? 1 : 0)));
  if (value && percent) *value /= 100.0;
  return value;
}

namespace {

// The nearest value of three digits, and one unit of its last digit.
std::pair<double, double> three_digits(double value) {
  const std::string text = fmt::format("{:.2e}", value);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  return {std::stod(text), std::stod(fmt::format("1e{}", exponent - 2))};
}

}  // namespace

double three_digits_below(double value) {
  const auto [nearest, unit] = three_digits(value);
  return nearest <= value ? nearest : nearest - unit;
}

double three_digits_above(double value) {
  const auto [nearest, unit] = three_digits(value);
  return nearest >= value ? nearest : nearest + unit;
}

std::string digits_beside(double value, double other) {
  int digits = 3;
  while (digits < 17 && value != other &&
         fmt::format("{:.{}g}", value, digits) == fmt::format("{:.{}g}", other, digits))
    ++digits;
  const std::string text = fmt::format("{}", value), rounded = fmt::format("{:.{}g}", value, digits);
  return text.size() <= rounded.size() ? text : rounded;  // 20000 rather than 2e+04
}

}  // namespace driver
