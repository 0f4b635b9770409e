// SPDX-License-Identifier: Apache-2.0
#include "bounds.hpp"

#include <flint/fmpz.h>

#include <algorithm>
#include <cmath>

namespace enclosure {
namespace {

/// Digits in which the ends of a ball may agree, and two more; at most 25.
int digits_of(const Ball& x) {
  if (arb_is_exact(x.get())) return 25;
  const double share = 2.0 * x.radius() / std::abs(x.middle());
  return share < 1.0 ? std::min(25, static_cast<int>(std::ceil(-std::log10(share))) + 2) : 3;
}

/// Lower (`down`) or upper end of a ball, rounded outward to decimal digits.
std::string decimal(const Ball& x, bool down) {
  if (arb_is_zero(x.get())) return "0";
  if (!x.is_finite()) return "nan";
  const double size = std::max(std::abs(lower(x).middle()), std::abs(upper(x).middle()));
  const int exponent = static_cast<int>(std::floor(std::log10(std::max(size, 1e-300))));
  const slong shift = digits_of(x) - 1 - exponent;
  Ball scale;
  arb_set_ui(scale.get(), 10);
  arb_pow_ui(scale.get(), scale.get(), static_cast<ulong>(std::abs(shift)), 2 * bits);
  Ball scaled;
  shift >= 0 ? arb_mul(scaled.get(), x.get(), scale.get(), 2 * bits)
             : arb_div(scaled.get(), x.get(), scale.get(), 2 * bits);
  const Ball end = down ? lower(scaled) : upper(scaled);
  fmpz_t whole;
  fmpz_init(whole);
  arf_get_fmpz(whole, arb_midref(end.get()), down ? ARF_RND_FLOOR : ARF_RND_CEIL);
  char* text = fmpz_get_str(nullptr, 10, whole);
  std::string result(text);
  flint_free(text);
  fmpz_clear(whole);
  if (result == "0") return result;
  const std::size_t sign = result.front() == '-' ? 1 : 0;
  const long power = static_cast<long>(result.size() - sign) - 1 - shift;
  result.insert(result.begin() + static_cast<long>(sign) + 1, '.');
  return result.append(1, 'e').append(std::to_string(power));
}

}  // namespace

Bounds bounds(const Ball& ball) {
  const Ball low = lower(ball), high = upper(ball);
  return {arf_get_d(arb_midref(low.get()), ARF_RND_FLOOR), arf_get_d(arb_midref(high.get()), ARF_RND_CEIL),
          decimal(ball, true), decimal(ball, false)};
}

}  // namespace enclosure
