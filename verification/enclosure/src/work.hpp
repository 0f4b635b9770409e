// SPDX-License-Identifier: Apache-2.0
// A law with the series that a step needs of it.
#pragma once

#include "series.hpp"
#include "walk.hpp"

namespace enclosure {

inline constexpr slong taylor_order = 22;  // N: coefficients 0 to N-1, and a remainder of order N
static_assert(taylor_order < 50, "sums of QuickBall are proved for 50 products");

/// A number with few digits, at most x > 0.
inline Ball rounded_down(const Ball& x) {
  Ball result;
  arf_set_round(arb_midref(result.get()), arb_midref(lower(x).get()), 30, ARF_RND_FLOOR);
  return result;
}

/// Series of all solutions from a set, and of all in a box, for the remainder.
template <class Number>
struct SetSeries {
  explicit SetSeries(const Law& law)
      : boxed(law.tape(), law.rates, law.outputs(), taylor_order - 1, law.streams),
        remainder(law.tape(), law.rates, law.outputs(), taylor_order) {}
  SeriesOf<Number> boxed, remainder;
};

struct Walk::Work {
  Work(const Tank& tank, const Regime& regime)
      : law(tank, regime, false),
        wide(tank, regime, true),
        thin(law.tape(), law.rates, law.outputs(), taylor_order - 1),
        across(wide.tape(), wide.rates, wide.outputs(), 0),
        quick(law) {}

  /// The box and its slopes may be wide by roundings, which are multiplied with what is small; doubles do but
  /// right at a switch.
  SetSeries<Ball>& exact() {
    if (!exact_) exact_ = std::make_unique<SetSeries<Ball>>(law);
    return *exact_;
  }

  /// Coefficient k of unknown i, of the total of stream j (k > 0), and their partials by unknown l. Those of
  /// the state come from its rates: state k is rate k-1 over k.
  template <class S>
  Ball coefficient(const S& s, std::size_t i, slong k) const {
    return s.value(s.state(i), k);
  }
  template <class S>
  Ball coefficient_slope(const S& s, std::size_t i, std::size_t l, slong k) const {
    return s.partial(s.state(i), static_cast<int>(l), k);
  }
  template <class S>
  Ball stream(const S& s, std::size_t j, slong k) const {
    return in_seconds(s.value(law.streams[j], k - 1) / Ball(static_cast<double>(k)));
  }
  template <class S>
  Ball stream_slope(const S& s, std::size_t j, std::size_t l, slong k) const {
    return in_seconds(s.partial(law.streams[j], static_cast<int>(l), k - 1) / Ball(static_cast<double>(k)));
  }
  /// A time in units of the series, and back.
  Ball in_units(Ball t) const {
    into::shift(t, t, -unit);
    return t;
  }
  Ball in_seconds(Ball t) const {
    into::shift(t, t, unit);
    return t;
  }

  Law law, wide;  // of steps, of crossings
  Series thin, across;
  SetSeries<QuickBall> quick;
  slong unit = 0;  // 2^unit s is that of the series

 private:
  std::unique_ptr<SetSeries<Ball>> exact_;
};

}  // namespace enclosure
