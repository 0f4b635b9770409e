// SPDX-License-Identifier: Apache-2.0
#include "time_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/case_reader.hpp"
#include "base/number_text.hpp"

namespace driver::commands {

double parse_number(std::string_view text, const std::string& whole) {
  const auto value = number_of(text);
  if (!value) throw CaseError(fmt::format("{}: '{}' is not a finite number", whole, text));
  return *value;
}

std::vector<double> parse_times(const std::string& text) {
  if (text.empty()) return {};
  constexpr double most = 1e7;
  const CaseError refusal(fmt::format(
      "--times {}: is not a number, nor first:last:step with step > 0 and at most {:.0e} rows", text, most));
  std::vector<double> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(':', begin), text.size());
    const auto part = number_of(std::string_view(text).substr(begin, end - begin));
    if (!part) throw refusal;
    parts.push_back(*part);
    begin = end + 1;
  }
  if (parts.size() == 1) return parts;
  if (parts.size() != 3 || !(parts[2] > 0.0) || parts[1] < parts[0] ||
      (parts[1] - parts[0]) / parts[2] > most)
    throw refusal;
  std::vector<double> times;
  const auto count = static_cast<long>(std::floor((parts[1] - parts[0]) / parts[2] * (1.0 + 1e-12) + 1e-12));
  for (long i = 0; i <= count; ++i) times.push_back(parts[0] + static_cast<double>(i) * parts[2]);
  return times;
}

}  // namespace driver::commands
