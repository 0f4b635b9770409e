// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

namespace support {

// Stability polynomials 1 + z + ... of explicit Runge-Kutta methods: of order p with p stages they are the
// truncated exponential; Dormand and Prince's six stages add z^6/600 (E. Hairer, S. P. Norsett, G. Wanner,
// Solving Ordinary Differential Equations I, sec. II.4).
inline const std::vector<double> kEulerPolynomial{1.0, 1.0};
inline const std::vector<double> kRungeKutta4Polynomial{1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0};
inline const std::vector<double> kDormandPrince5Polynomial{1.0,        1.0,         1.0 / 2.0,  1.0 / 6.0,
                                                           1.0 / 24.0, 1.0 / 120.0, 1.0 / 600.0};

// Limit of h |lambda| for lambda < 0: the least x > 0 with |R(-x)| > 1 beyond it, to 1e-12.
inline double real_axis_limit(const std::vector<double>& polynomial) {
  const auto grows = [&](double x) {
    double r = 0.0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) r = *c - x * r;
    return std::abs(r) > 1.0;
  };
  double stable = 1e-3, unstable = stable;
  while (!grows(unstable)) stable = unstable, unstable += 1e-2;  // of the first crossing
  while (unstable - stable > 1e-12) {
    const double middle = 0.5 * (stable + unstable);
    (grows(middle) ? unstable : stable) = middle;
  }
  return unstable;
}

}  // namespace support
