// SPDX-License-Identifier: Apache-2.0
// Numbers in Fortran's notation.
#pragma once

#include <string>
#include <string_view>

namespace mesh {

/// The number in C's notation. Fortran writes 1.5D3 for 1.5e3, and omits the letter before an exponent of
/// three digits: 1.234-101. A sign begins an exponent only after digits with a point: 5-3 stays unchanged.
inline std::string without_fortran_exponent(std::string_view text) {
  std::string number(text);
  for (char& c : number)
    if (c == 'D' || c == 'd') c = 'e';
  const auto sign = number.find_last_of("+-");
  if (sign == std::string::npos || sign == 0) return number;
  const std::string_view digits = std::string_view(number).substr(0, sign);
  const auto first = digits.find_first_not_of("+-");
  if (first <= 1 && digits.find('.') != digits.npos && digits.find_first_of("0123456789") != digits.npos &&
      digits.find_first_not_of("0123456789.", first) == digits.npos)
    number.insert(sign, 1, 'e');
  return number;
}

}  // namespace mesh
