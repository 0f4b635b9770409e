// SPDX-License-Identifier: Apache-2.0
// A step by Taylor series within one regime, with its proof.
#include <algorithm>
#include <cmath>

#include "work.hpp"

namespace enclosure {
namespace {

Ball power(const Ball& h, slong n) {
  Ball result;
  arb_pow_ui(result.get(), h.get(), static_cast<ulong>(n), bits);
  return result;
}

template <class Coefficient>
Ball horner(Coefficient&& coefficient, slong n, const Ball& at) {
  Ball value;
  for (slong k = n; k-- > 0;) value = value * at + coefficient(k);
  return value;
}

/// Encloses a polynomial over [0, h], in eight parts: Horner's scheme over all of it at once is wide.
template <class Coefficient>
Ball range(Coefficient&& coefficient, slong n, const Ball& h) {
  constexpr int parts = 8;
  Ball all, left(0.0);
  for (int i = 1; i <= parts; ++i) {
    const Ball right = h * Ball(static_cast<double>(i) / parts);
    const Ball part = horner(coefficient, n, hull(left, right));
    all = i == 1 ? part : hull(all, part);
    left = right;
  }
  return all;
}

}  // namespace

/// First of the coefficients which over the box add so little width that they need neither the mean value
/// theorem nor many digits.
template <class Number>
slong Walk::first_narrow(const Work& w, const SeriesOf<Number>& boxed, const Ball& h,
                         const std::vector<double>& scale) const {
  double width = 0.0;
  for (slong k = taylor_order; k-- > 1;) {
    const double h_k = std::pow(h.middle(), static_cast<double>(k));
    double largest = 0.0;
    for (std::size_t i = 0; i < unknowns_; ++i)
      largest = std::max(largest, w.coefficient(boxed, i, k).radius() / scale[i]);
    for (std::size_t j = 0; j < streams_; ++j)
      largest = std::max(largest, w.stream(boxed, j, k).radius() / scale[unknowns_ + j]);
    width += largest * h_k;
    if (!(width < 0.1 * std::min(tolerance_, 1e-6))) return k + 1;
  }
  return 1;
}

/// Exact step from [time, time + length] if it can be proved; else shortens `length` and returns false.
///
/// Existence and bounds: let c_0..c_{N-1} be the Taylor coefficients at the time of all solutions from the
/// set, and c_N(Y) those of order N over a box Y and the span. If sum c_k [0,h]^k + c_N(Y) [0,h]^N lies in Y,
/// each solution from the set exists over the span, is unique and stays in Y (G. F. Corliss and R. Rihm,
/// "Validating an a priori enclosure using high-order Taylor series", 1996; N. S. Nedialkov, K. R. Jackson
/// and J. D. Pryce, Reliable Computing 7 (2001) 449, theorem 4.1; for N = 1 it is Picard's and Lindelof's).
/// By Taylor's theorem with Lagrange's remainder its end is sum c_k h^k + c_N(Y) h^N. Of the first few c_k
/// the mean value theorem tells how they vary over the set; the others are those of the whole box.
template <class Number>
bool Walk::try_length(Work& w, SetSeries<Number>& series, const Regime& regime, Ball& length) {
  const Balls box = set_.box();
  const std::vector<double> scale = scales(box);
  const Span span{time_, exact_sum(time_, length)};
  const Ball h = w.in_units(length), h_n = power(h, taylor_order), all_n = hull(Ball(0.0), h_n);
  Balls reached, guess;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    const auto c = [&](slong k) { return w.coefficient(series.boxed, i, k); };
    reached.push_back(range(c, taylor_order, h));
    const double last = std::abs(c(taylor_order - 1).middle()) + c(taylor_order - 1).radius();
    guess.push_back(wider(reached[i], last * std::pow(h.middle(), static_cast<double>(taylor_order - 1)) +
                                          1e-34 * scale[i] + 1e-4 * reached[i].radius()));
  }
  series.remainder.run(guess, span, taylor_order, Mode::series, w.unit);
  double error = 0.0;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    const Ball rest = w.coefficient(series.remainder, i, taylor_order);
    if (!guess[i].contains(reached[i] + all_n * rest)) {
      length = rounded_down(length * Ball(0.6));
      return false;
    }
    error = std::max(error, (h_n * rest).radius() / scale[i]);
  }
  for (std::size_t j = 0; j < streams_; ++j)
    error =
        std::max(error, (h_n * w.stream(series.remainder, j, taylor_order)).radius() / scale[unknowns_ + j]);
  if (!(error <= tolerance_)) {
    const double factor = 0.9 * std::pow(tolerance_ / error, 1.0 / static_cast<double>(taylor_order));
    length = rounded_down(length * Ball(std::clamp(factor, 0.3, 0.9)));
    return false;
  }
  const slong split = first_narrow(w, series.boxed, h, scale), last = std::max<slong>(split - 1, 0);
  w.thin.run(core(set_.centre()), {time_, time_}, last, Mode::series, w.unit);
  series.boxed.run_partials(last);
  Balls image;
  Matrix slopes = Matrix::identity(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    const bool inner = i < unknowns_;
    const std::size_t j = i - unknowns_;
    const auto c = [&](slong k) {
      if (!inner && k == 0) return set_.centre()[i];
      if (k < split) return inner ? w.coefficient(w.thin, i, k) : w.stream(w.thin, j, k);
      return inner ? w.coefficient(series.boxed, i, k) : w.stream(series.boxed, j, k);
    };
    const Ball rest = inner ? w.coefficient(series.remainder, i, taylor_order)
                            : w.stream(series.remainder, j, taylor_order);
    image.push_back(horner(c, taylor_order, h) + h_n * rest);
    for (std::size_t l = 0; l < unknowns_; ++l) {
      const auto d = [&](slong k) {
        return inner ? w.coefficient_slope(series.boxed, i, l, k)
               : k   ? w.stream_slope(series.boxed, j, l, k)
                     : Ball(0.0);
      };
      slopes.at(i, l) = horner(d, split, h);
    }
  }
  // A solution stays on its side of a surface g = 0 if g keeps its sign over Y, or if g is monotone over Y
  // and has its sign at the end (event by monotonicity: the mean value theorem). The formula holds on both
  // sides of g = 0.
  MovingSet moved = set_;
  moved.advance(image, slopes, scale);
  const Sides after = sides(moved.box(), {span.end, span.end});
  for (std::size_t i = 0; i < regime.size(); ++i) {
    const Ball g = series.remainder.value(w.law.surfaces[i]),
               slope = series.remainder.value(w.law.surfaces[i], 1);
    if (regime[i] ? g.is_positive() : g.is_negative()) continue;
    if ((slope.is_positive() || slope.is_negative()) && after[i] == (regime[i] ? 1 : -1)) continue;
    length = rounded_down(length * Ball(0.6));
    return false;
  }
  set_ = moved;
  time_ = span.end;
  ++steps;
  return true;
}

template bool Walk::try_length(Work&, SetSeries<Ball>&, const Regime&, Ball&);
template bool Walk::try_length(Work&, SetSeries<QuickBall>&, const Regime&, Ball&);

}  // namespace enclosure
