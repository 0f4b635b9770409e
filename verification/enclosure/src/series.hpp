// SPDX-License-Identifier: Apache-2.0
// Taylor coefficients of a tape.
#pragma once

#include "quick_ball.hpp"
#include "tape.hpp"

namespace enclosure {

/// Taylor coefficients in time of every value of a tape along the solution of x_i' = rate_i by the
/// recurrences of R. E. Moore, "Interval Analysis", 1966, ch. 11 (A. Griewank and A. Walther, "Evaluating
/// Derivatives", 2nd ed. 2008, table 13.1). Coefficient k encloses y^(k)(t) s^k/k! of every solution y that
/// is in the balls x at a time t of the span; time is counted in units of s = 2^unit seconds, which keeps
/// high coefficients from overflow. With partials, those by x_j too, which are the recurrences
/// differentiated.
template <class Number>
class SeriesOf {
 public:
  /// Coefficients 0 to `order` of the state and of what `rates` and `values` need.
  SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values, slong order);
  /// With partials by the state of what `rates` and `slopes` need.
  SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values, slong order,
           const std::vector<int>& slopes);
  SeriesOf(const SeriesOf&) = delete;
  SeriesOf& operator=(const SeriesOf&) = delete;

  /// Computes coefficients 0 to `last`; across switches only if of Arb's balls, and coefficient 0.
  void run(const Balls& x, const Span& span, slong last, Mode mode = Mode::series, slong unit = 0);
  /// Then their partials, to a `last` that is not beyond that.
  void run_partials(slong last);

  Ball value(int id, slong k = 0) const { return exact(row(id, 0)[k]); }
  Ball partial(int id, int j, slong k) const { return exact(row(id, j + 1)[k]); }
  /// Id of unknown i.
  int state(std::size_t i) const { return states_[i]; }

 private:
  std::size_t place(int id, int j) const {
    return (static_cast<std::size_t>(id) * rows_ + static_cast<std::size_t>(j)) *
           (static_cast<std::size_t>(order_) + 1);
  }
  Number* row(int id, int j) { return data_.data() + place(id, j); }
  const Number* row(int id, int j) const { return data_.data() + place(id, j); }
  SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values, slong order,
           std::size_t rows);
  std::vector<int> behind(const std::vector<int>& outputs) const;
  void begin(const Balls& x, const Span& span, slong last);
  void value_coefficient(int id, slong k);
  void product_coefficient(int id, slong k);
  void partial_coefficient(int id, int j, slong k);
  void next_of_state(int j, slong k);
  void within_bounds(Number& c, const Node& node) const;

  const Tape& tape_;
  const std::vector<int> rates_;
  const slong order_;
  const std::size_t rows_;  // of a value: itself and its partials
  Mode mode_ = Mode::series;
  slong unit_ = 0;
  std::vector<int> states_, needed_, sloped_;  // ids
  std::vector<Number> data_;
  std::vector<std::vector<Number>> weighted_;  // j times the coefficient j that exp and log need
};

using Series = SeriesOf<Ball>;
using QuickSeries = SeriesOf<QuickBall>;

}  // namespace enclosure
