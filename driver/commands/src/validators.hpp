// SPDX-License-Identifier: Apache-2.0
// Validators with our messages. CLI11's ranges accept NaN and print all digits of their ends.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <string>

namespace driver::commands {

inline CLI::Validator finite_above(double least, const std::string& allowed) {
  const auto fault = [least, allowed](std::string& text) {
    double value = 0.0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > least;
    return good ? std::string() : text + ": allowed: " + allowed;
  };
  return {fault, ""};
}
inline const CLI::Validator positive = finite_above(0.0, "a finite number above 0");

inline CLI::Validator within(double low, double high, const std::string& allowed) {
  const auto fault = [low, high, allowed](std::string& text) {
    double value = 0.0;
    const bool good =
        CLI::detail::lexical_cast(text, value) && value >= low && value <= high;  // false for NaN
    return good ? std::string() : text + ": allowed: " + allowed;
  };
  return {fault, ""};
}

inline const CLI::Validator not_negative =
    within(0.0, std::numeric_limits<double>::max(), "a finite number from 0");

inline CLI::Validator not_empty(const std::string& needed) {
  const std::string fault = "is empty, needed: " + needed;
  return {[fault](std::string& text) { return text.empty() ? fault : std::string(); }, ""};
}
inline const CLI::Validator named = not_empty("a name");
inline const CLI::Validator given = not_empty("a value");  // an empty text would be read as the number 0

}  // namespace driver::commands
