// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "elementary/exponential.hpp"

namespace elementary {

/// 1 - 2/sqrt(pi) integral of e^(-t^2) from 0 to x.
inline double erfc(double x) {
  if (std::isnan(x)) return x;
  if (x < -6.0) return 2.0;
  if (x > 28.0) return 0.0;
  using Number = Wide<Digits128>;
  const Number one = Number::one(), size = Number::of(std::fabs(x)), square = size * size;
  // 2/sqrt(pi) e^(-x^2)
  const Number scale = exp(-square) * Number::of(0x906eba8214db688d, 0x71d48a7f6bfec344, 0);
  Number sum;
  if (std::fabs(x) < 2.0) {
    // erf = scale (x + x 2x^2/3 + x (2x^2)^2/(3 5) + ...): 60 terms leave 2^-130.
    const Number twice = square + square;
    for (int n = 60; n > 0; --n) sum = twice * (one + sum) / Number::of(2 * n + 1);
    const Number erf = scale * size * (one + sum);
    return (x < 0.0 ? one + erf : one - erf).rounded();
  }
  // erfc = scale/2 / (x + (1/2)/(x + (2/2)/(x + (3/2)/(x + ...)))): 500 fractions leave 2^-120 at 2.
  for (int n = 500; n > 0; --n) sum = Number::of(0.5 * n) / (size + sum);
  const Number erfc = (scale / (size + sum)).times_power_of_two(-1);
  return (x < 0.0 ? Number::of(2.0) - erfc : erfc).rounded();
}

}  // namespace elementary
