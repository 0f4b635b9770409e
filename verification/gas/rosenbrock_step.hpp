// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <cstddef>
#include <vector>

namespace cases {

/// A step h of Rosenbrock 4 with the coefficients of Boost.Odeint (whose own stepper is no C++20), for two
/// unknowns that are not zero and rates of them alone; the Jacobian by central differences of 1e-5, off by
/// 1e-10.
template <class Rates>
std::array<double, 2> rosenbrock_step(const Rates& rates, const std::array<double, 2>& x, double h) {
  using State = std::array<double, 2>;
  const boost::numeric::odeint::default_rosenbrock_coefficients<double> c;
  const auto rate = [&](const State& at) {
    State r;
    rates(at, r, 0.0);
    return r;
  };
  double m[2][2];  // 1/(gamma h) - Jacobian
  for (std::size_t j = 0; j < 2; ++j) {
    State low = x, high = x;
    low[j] *= 1.0 - 1e-5, high[j] *= 1.0 + 1e-5;
    const State below = rate(low), above = rate(high);
    for (std::size_t i = 0; i < 2; ++i)
      m[i][j] = (i == j ? 1.0 / (c.gamma * h) : 0.0) - (above[i] - below[i]) / (high[j] - low[j]);
  }
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  std::vector<State> g;
  const auto stage = [&](const std::vector<double>& shifts, const std::vector<double>& weights) {
    State at = x;
    for (std::size_t s = 0; s < shifts.size(); ++s)
      for (std::size_t i = 0; i < 2; ++i) at[i] += shifts[s] * g[s][i];
    State right = rate(at);
    for (std::size_t s = 0; s < weights.size(); ++s)
      for (std::size_t i = 0; i < 2; ++i) right[i] += weights[s] * g[s][i] / h;
    g.push_back({(right[0] * m[1][1] - right[1] * m[0][1]) / determinant,
                 (right[1] * m[0][0] - right[0] * m[1][0]) / determinant});
    return State{at[0] + g.back()[0], at[1] + g.back()[1]};
  };
  stage({}, {});
  stage({c.a21}, {c.c21});
  stage({c.a31, c.a32}, {c.c31, c.c32});
  stage({c.a41, c.a42, c.a43}, {c.c41, c.c42, c.c43});
  stage({c.a51, c.a52, c.a53, c.a54}, {c.c51, c.c52, c.c53, c.c54});
  return stage({c.a51, c.a52, c.a53, c.a54, 1.0}, {c.c61, c.c62, c.c63, c.c64, c.c65});
}

}  // namespace cases
