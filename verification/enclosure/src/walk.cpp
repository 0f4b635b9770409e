// SPDX-License-Identifier: Apache-2.0
// Steps by Taylor series, within one regime.
#include "walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "work.hpp"

namespace enclosure {
namespace {

Ball power(const Ball& h, slong n) {
  Ball result;
  arb_pow_ui(result.get(), h.get(), static_cast<ulong>(n), bits);
  return result;
}

/// A number with few digits, at most x > 0.
Ball rounded_down(const Ball& x) {
  Ball result;
  arf_set_round(arb_midref(result.get()), arb_midref(lower(x).get()), 30, ARF_RND_FLOOR);
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

Walk::Work& Walk::work(const Regime& regime) {
  auto& entry = works_[regime];
  if (!entry) entry = std::make_unique<Work>(tank_, regime);
  return *entry;
}

Walk::Walk(const Tank& tank, const Ball& start, const Balls& unknowns, double tolerance)
    : tank_(tank),
      unknowns_(tank.species() + 1),
      streams_(unknowns.size() - unknowns_),
      tolerance_(tolerance),
      time_(start),
      set_(unknowns) {}

Walk::~Walk() = default;

/// What widths are relative to: the mass that is and was there, the temperature, 1 for mass fractions.
std::vector<double> Walk::scales(const Balls& box) const {
  double mass = box[0].middle();
  for (std::size_t j = 0; j < streams_; ++j) mass = std::max(mass, std::abs(box[unknowns_ + j].middle()));
  std::vector<double> result(box.size(), mass);
  result[0] = box[0].middle();
  result[1] = box[1].middle();
  std::fill(result.begin() + 2, result.begin() + static_cast<long>(unknowns_), 1.0);
  return result;
}

Walk::Sides Walk::sides(const Balls& box, const Span& span) {
  Sides result(tank_.surfaces.size(), 0);
  bool first = true;
  const double t = box[1].middle(), r = box[1].radius();
  for (const bool high : {false, true}) {
    if (tank_.constant_cp ? high : high ? t + r < joint_temperature : t - r > joint_temperature + 1.0)
      continue;
    Regime any(tank_.surfaces.size(), true);
    for (std::size_t i = 0; i < any.size(); ++i)
      if (tank_.surfaces[i].kind == Surface::Kind::joint ||
          tank_.surfaces[i].kind == Surface::Kind::joint_energy)
        any[i] = high;
    Work& w = work(any);
    w.across.run(core(box), span, Mode::across);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Ball g = w.across.value(w.law.surfaces[i]);
      const int side = g.is_positive() ? 1 : g.is_negative() ? -1 : 0;
      result[i] = first || result[i] == side ? side : 0;
    }
    first = false;
  }
  return result;
}

Regime Walk::regime(const Sides& sides) {
  Regime result;
  for (int side : sides) result.push_back(side > 0);
  return result;
}

/// Length of a step whose last coefficients are a tenth of the tolerance.
Ball Walk::first_length(const Work& w, const Ball& end) const {
  const std::vector<double> scale = scales(set_.box());
  double length = (end - time_).middle();
  for (std::size_t i = 0; i < unknowns_; ++i)
    for (slong k = taylor_order - 2; k < taylor_order; ++k) {
      const double size = std::abs(w.coefficient(w.boxed, i, k).middle()) / scale[i];
      if (size > 0.0)
        length = std::min(length, std::pow(0.1 * tolerance_ / size, 1.0 / static_cast<double>(k)));
    }
  return rounded_down(Ball(length));
}

/// Exact step from [time, time + length] if it can be proved; else shortens `length` and returns false.
///
/// Existence and bounds: let c_0..c_{N-1} be the Taylor coefficients at the time of all solutions from the
/// set, and c_N(Y) those of order N over a box Y and the span. If sum c_k [0,h]^k + c_N(Y) [0,h]^N lies in Y,
/// each solution from the set exists over the span, is unique and stays in Y (G. F. Corliss and R. Rihm,
/// "Validating an a priori enclosure using high-order Taylor series", 1996; N. S. Nedialkov, K. R. Jackson
/// and J. D. Pryce, Reliable Computing 7 (2001) 449, theorem 4.1; for N = 1 it is Picard's and Lindelof's).
/// By Taylor's theorem with Lagrange's remainder its end is sum c_k h^k + c_N(Y) h^N.
bool Walk::try_length(Work& w, const Regime& regime, Ball& length) {
  const Balls box = set_.box();
  const std::vector<double> scale = scales(box);
  const Span span{time_, exact_sum(time_, length)};
  const Ball all = hull(Ball(0.0), length), h_n = power(length, taylor_order), all_n = hull(Ball(0.0), h_n);
  Balls reached, guess;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    const auto c = [&](slong k) { return w.coefficient(w.boxed, i, k); };
    reached.push_back(range(c, taylor_order, length));
    const double last = std::abs(c(taylor_order - 1).middle()) + c(taylor_order - 1).radius();
    guess.push_back(
        wider(reached[i], last * std::pow(length.middle(), static_cast<double>(taylor_order - 1)) +
                              1e-34 * scale[i] + 1e-4 * reached[i].radius()));
  }
  w.remainder.run(guess, span);
  double error = 0.0;
  for (std::size_t i = 0; i < unknowns_; ++i) {
    const Ball rest = w.coefficient(w.remainder, i, taylor_order);
    if (!guess[i].contains(reached[i] + all_n * rest)) {
      length = rounded_down(length * Ball(0.6));
      return false;
    }
    error = std::max(error, (h_n * rest).radius() / scale[i]);
  }
  for (std::size_t j = 0; j < streams_; ++j)
    error = std::max(error, (h_n * w.stream(w.remainder, j, taylor_order)).radius() / scale[unknowns_ + j]);
  if (!(error <= tolerance_)) {
    const double factor = 0.9 * std::pow(tolerance_ / error, 1.0 / static_cast<double>(taylor_order));
    length = rounded_down(length * Ball(std::clamp(factor, 0.3, 0.9)));
    return false;
  }
  Balls image;
  Matrix slopes = Matrix::identity(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    const bool inner = i < unknowns_;
    const std::size_t j = i - unknowns_;
    const auto c = [&](slong k) {
      return inner ? w.coefficient(w.thin, i, k) : k ? w.stream(w.thin, j, k) : set_.centre()[i];
    };
    const Ball rest =
        inner ? w.coefficient(w.remainder, i, taylor_order) : w.stream(w.remainder, j, taylor_order);
    image.push_back(horner(c, taylor_order, length) + h_n * rest);
    for (std::size_t l = 0; l < unknowns_; ++l) {
      const auto d = [&](slong k) {
        return inner ? w.coefficient_slope(w.boxed, i, l, k)
               : k   ? w.stream_slope(w.boxed, j, l, k)
                     : Ball(0.0);
      };
      slopes.at(i, l) = horner(d, taylor_order, length);
    }
  }
  // A solution stays on its side of a surface g = 0 if g keeps its sign over Y, or if g is monotone over Y
  // and has its sign at the end (event by monotonicity: the mean value theorem). The formula holds on both
  // sides of g = 0.
  MovingSet moved = set_;
  moved.advance(image, slopes, scale);
  const Sides after = sides(moved.box(), {span.end, span.end});
  for (std::size_t i = 0; i < regime.size(); ++i) {
    const Ball g = w.remainder.value(w.law.surfaces[i]), slope = w.remainder.value(w.law.surfaces[i], 1);
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

/// Where g of the centre's solution vanishes within the length, about; none if it does not.
std::optional<Ball> Walk::root(Work& w, std::size_t surface, const Ball& length) const {
  const auto g = [&](const Ball& at) {
    return midpoint(horner([&](slong k) { return midpoint(w.thin.value(w.law.surfaces[surface], k)); },
                           taylor_order - 1, at));
  };
  const bool sign = g(Ball(0.0)).is_positive();
  Ball a(0.0), b;
  bool found = false;
  constexpr int samples = 32;
  for (int i = 1; i <= samples && !found; ++i) {
    b = midpoint(length * Ball(static_cast<double>(i) / samples));
    found = g(b).is_positive() != sign;
    if (!found) a = b;
  }
  if (!found) return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const Ball middle = midpoint((a + b) * Ball(0.5));
    (g(middle).is_positive() == sign ? a : b) = middle;
  }
  return a;
}

/// The first of the roots of all surfaces within the length, and how uncertain it is.
std::optional<Ball> Walk::first_root(Work& w, const Ball& length, Ball& margin) const {
  std::optional<Ball> first;
  for (std::size_t i = 0; i < tank_.surfaces.size(); ++i) {
    const std::optional<Ball> at = root(w, i, first ? *first : length);
    if (!at) continue;
    first = at;
    const Ball g = w.boxed.value(w.law.surfaces[i]), slope = w.boxed.value(w.law.surfaces[i], 1);
    margin = *at * Ball(0x1p-60) + Ball(16.0 * g.radius() / std::abs(slope.middle()));
  }
  return first;
}

bool Walk::taylor(const Regime& regime, const Ball& end) {
  Work& w = work(regime);
  const Balls box = set_.box();
  w.thin.run(core(set_.centre()), {time_, time_});
  w.boxed.run(core(box), {time_, time_});
  Ball length = first_length(w, end);
  if (last_length_.is_positive() && (length - last_length_ * Ball(2.0)).is_positive())
    length = last_length_ * Ball(2.0);
  Ball margin;
  if (const std::optional<Ball> at = first_root(w, length, margin)) {
    if (cross(*at + *at + margin, end)) return true;
    length = rounded_down(*at - margin);
    if (length.is_positive() && try_length(w, regime, length)) {
      approach_ = margin;
      return true;
    }
    length = rounded_down(*at * Ball(0.7));
  }
  for (int tries = 0; tries < 200 && length.is_positive(); ++tries) {
    const bool last = arf_cmp(arb_midref(exact_sum(time_, length).get()), arb_midref(end.get())) >= 0;
    if (last) length = exact_difference(end, time_);
    if (!try_length(w, regime, length)) continue;
    if (!last) last_length_ = length;
    return true;
  }
  return false;
}

void Walk::step(const Ball& end) {
  const Sides now = sides(set_.box(), {time_, time_});
  const bool decided = std::find(now.begin(), now.end(), 0) == now.end();
  if (approach_.is_positive()) {
    const Ball margin = approach_;
    approach_ = Ball(0.0);
    if (cross(margin + margin, end)) return;
  }
  if (decided && taylor(regime(now), end)) {
    undecided_ = 0;
    return;
  }
  if (!decided && rest(now, end)) return;
  if (++undecided_ < 100 && cross((end - time_) * Ball(0x1p-80), end)) return;
  char text[200];
  std::snprintf(text, sizeof text,
                "at t = %.6g s the tube cannot be continued: it stays within its width of a switch of "
                "the law, or its width grows without bound",
                time_.middle());
  throw Refusal(text);
}

}  // namespace enclosure
