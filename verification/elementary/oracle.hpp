// SPDX-License-Identifier: Apache-2.0
// MPFR's functions as functions of doubles: correctly rounded, subnormal results too.
#pragma once

#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace oracle {

class Number {
 public:
  Number() {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    mpfr_init2(value_, 53);
  }
  explicit Number(double x) : Number() { mpfr_set_d(value_, x, MPFR_RNDN); }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  mpfr_ptr get() { return value_; }
  double rounded(int ternary) {
    ternary = mpfr_check_range(value_, ternary, MPFR_RNDN);
    mpfr_subnormalize(value_, ternary, MPFR_RNDN);
    return mpfr_get_d(value_, MPFR_RNDN);
  }

 private:
  mpfr_t value_;
};

using One = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Two = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

inline double value(One function, double x) {
  Number a(x), result;
  const int ternary = function(result.get(), a.get(), MPFR_RNDN);
  return result.rounded(ternary);
}
inline double value(Two function, double x, double y) {
  Number a(x), b(y), result;
  const int ternary = function(result.get(), a.get(), b.get(), MPFR_RNDN);
  return result.rounded(ternary);
}

/// All numbers that are not numbers count as one.
inline bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Arguments, the same in each run.
class Arguments {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  int whole(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }
  /// Every finite double alike.
  double any() {
    double x;
    do x = std::bit_cast<double>(generator_());
    while (!std::isfinite(x));
    return x;
  }
  /// Of either sign, its exponent between `low` and `high`.
  double sized(int low, int high) {
    return std::ldexp((whole(2) == 0 ? 1.0 : -1.0) * between(1.0, 2.0), low + whole(high - low));
  }

 private:
  std::mt19937_64 generator_{1};
};

}  // namespace oracle
