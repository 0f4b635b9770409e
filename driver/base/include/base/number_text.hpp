// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace driver {

/// The finite number that `text` is as a whole, as programs write it: a leading plus is allowed, what is too
/// small for a double is 0. Nothing for any other text.
std::optional<double> number_of(std::string_view text);
/// The same of a number in a file of another program, also as Fortran writes it: 1.5D3, 1.234-101.
std::optional<double> file_number_of(std::string_view text);
/// As number_of, of a fraction, "0.02" or "2%".
std::optional<double> fraction_of(std::string_view text);

/// A positive value to three digits, not above or not below it: limits that may be typed as they are printed.
double three_digits_below(double value);
/// See three_digits_below.
double three_digits_above(double value);

}  // namespace driver
