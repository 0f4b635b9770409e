// SPDX-License-Identifier: Apache-2.0
// A law with the series that a step needs of it.
#pragma once

#include "walk.hpp"

namespace enclosure {

inline constexpr slong taylor_order = 22;  // N: coefficients 0 to N-1, and a remainder of order N

struct Walk::Work {
  Work(const Tank& tank, const Regime& regime)
      : law(tank, regime),
        thin(law.tape(), law.rates, taylor_order - 1, false),
        boxed(law.tape(), law.rates, taylor_order - 1, true),
        remainder(law.tape(), law.rates, taylor_order, false),
        across(law.tape(), law.rates, 0, false) {}

  /// Coefficient k of unknown i, of the total of stream j (k > 0), and their partials by unknown l. Those of
  /// the state come from its rates: state k is rate k-1 over k.
  Ball coefficient(const Series& s, std::size_t i, slong k) const { return s.value(s.state(i), k); }
  Ball coefficient_slope(const Series& s, std::size_t i, std::size_t l, slong k) const {
    return s.partial(s.state(i), static_cast<int>(l), k);
  }
  Ball stream(const Series& s, std::size_t j, slong k) const {
    return s.value(law.streams[j], k - 1) / Ball(static_cast<double>(k));
  }
  Ball stream_slope(const Series& s, std::size_t j, std::size_t l, slong k) const {
    return s.partial(law.streams[j], static_cast<int>(l), k - 1) / Ball(static_cast<double>(k));
  }

  Law law;
  Series thin, boxed, remainder, across;
};

}  // namespace enclosure
