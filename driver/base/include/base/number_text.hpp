// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace driver {

/// The finite number that makes up the whole `text`, as programs write it. A leading plus is allowed; a
/// number too small for a double is 0. Empty for other text.
std::optional<double> number_of(std::string_view text);
/// The same for a number in another program's file, also as Fortran writes it: 1.5D3, 1.234-101.
std::optional<double> file_number_of(std::string_view text);
/// As number_of, for a fraction, "0.02" or "2%".
std::optional<double> fraction_of(std::string_view text);

/// A positive value rounded down to three digits: a limit that stays valid when typed as printed.
double three_digits_below(double value);
/// The same, rounded up.
double three_digits_above(double value);

/// `value` for people: three digits, or as many as tell it from `other`, which stands beside it.
std::string digits_beside(double value, double other);

}  // namespace driver
