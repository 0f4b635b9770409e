// SPDX-License-Identifier: Apache-2.0
#include "bounds.hpp"

#include <flint/fmpz.h>

#include <algorithm>
#include <cmath>

namespace enclosure {
namespace {

constexpr double digits_of_a_bit = 0.30102999566398120;  // log10(2)

/// Digits in which the ends of a ball may agree, and two more; at most 25. One if it contains 0.
int digits_of(const Ball& x) {
  if (arb_contains_zero(x.get())) return 1;
  const auto same = static_cast<double>(std::clamp<slong>(arb_rel_accuracy_bits(x.get()), 1, 100));
  return std::min(25, static_cast<int>(std::ceil(digits_of_a_bit * same)) + 2);
}

/// Power of ten below the largest number in a ball: a double would not hold all.
int exponent_of(const Ball& x) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, x.get());
  const double exponent = digits_of_a_bit * mag_get_d_log2_approx(size);
  mag_clear(size);
  return static_cast<int>(std::floor(exponent));
}

/// Lower (`down`) or upper end of a ball, rounded outward to decimal digits.
std::string decimal(const Ball& x, bool down) {
  if (arb_is_zero(x.get())) return "0";
  if (!x.is_finite()) return down ? "-inf" : "inf";
  if (arb_contains_zero(x.get()) && exponent_of(x) < -300) return down ? "-1e-300" : "1e-300";
  const slong shift = digits_of(x) - 1 - exponent_of(x);
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
  if (result.size() > sign + 1) result.insert(result.begin() + static_cast<long>(sign) + 1, '.');
  return result.append(1, 'e').append(std::to_string(power));
}

}  // namespace

Bounds bounds(const Ball& ball) {
  const Ball low = lower(ball), high = upper(ball);
  return {arf_get_d(arb_midref(low.get()), ARF_RND_FLOOR), arf_get_d(arb_midref(high.get()), ARF_RND_CEIL),
          decimal(ball, true), decimal(ball, false)};
}

}  // namespace enclosure
