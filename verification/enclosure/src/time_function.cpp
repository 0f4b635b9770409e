// SPDX-License-Identifier: Apache-2.0
#include "time_function.hpp"

#include <arb_poly.h>

#include <algorithm>

#include "enclosure/enclose.hpp"

namespace enclosure {
namespace {

/// A polynomial of Arb that frees itself.
struct Polynomial {
  explicit Polynomial(const Balls& coefficients) {
    arb_poly_init(p);
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      arb_poly_set_coeff_arb(p, static_cast<slong>(i), coefficients[i].get());
  }
  Polynomial(const Polynomial&) = delete;
  Polynomial& operator=(const Polynomial&) = delete;
  ~Polynomial() { arb_poly_clear(p); }
  Balls coefficients() const {
    Balls result(static_cast<std::size_t>(std::max<slong>(1, arb_poly_length(p))));
    for (slong i = 0; i < arb_poly_length(p); ++i)
      arb_poly_get_coeff_arb(result[static_cast<std::size_t>(i)].get(), p, i);
    return result;
  }
  arb_poly_t p;
};

}  // namespace

Piecewise::Piecewise(const Curve& curve, const Ball& start, bool zero_outside) {
  const auto outside = [&](double value) {
    pieces_.push_back({Ball(0.0), {Ball(zero_outside && curve.size() > 1 ? 0.0 : value)}});
  };
  const auto time = [&](const Knot& knot) { return later(start, Ball(knot.at)); };
  outside(curve.front().value);
  if (curve.size() == 1) {
    if (!zero_outside || !upper(start).is_positive()) return;
    pieces_.insert(pieces_.begin(), {Ball(0.0), {Ball(0.0)}});  // a constant flow from firing on
    breaks_.push_back(start);
    return;
  }
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const Knot &a = curve[i], &b = curve[i + 1];
    if (b.at <= a.at) continue;
    const Ball slope = (Ball(b.value) - Ball(a.value)) / (Ball(b.at) - Ball(a.at));
    breaks_.push_back(time(a));
    pieces_.push_back({time(a), {Ball(a.value), slope}});
  }
  breaks_.push_back(time(curve.back()));
  outside(curve.back().value);
}

Piecewise Piecewise::switched(const Curve& curve, const Balls& times) {
  Piecewise result;
  const auto add = [&](const Ball& from, const Piece& piece) {
    result.breaks_.push_back(from);
    result.pieces_.push_back(piece);
  };
  result.pieces_.push_back({Ball(0.0), {Ball(0.0)}});
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Ball& from = times[i];
    if (i % 2 == 1) {
      add(from, result.pieces_[0]);
      continue;
    }
    const Piecewise open(curve, times[i], false);
    add(from, open.pieces_[open.piece_after(from)]);
    for (std::size_t k = open.piece_after(from); k < open.breaks_.size(); ++k) {
      if (i + 1 < times.size()) {
        const Ball left = times[i + 1] - open.breaks_[k];
        if (left.is_negative() || arb_is_zero(left.get())) break;
        if (!left.is_positive())
          throw Refusal("a hole's area has a knot within the uncertainty of its closing");
      }
      add(open.breaks_[k], open.pieces_[k + 1]);
    }
  }
  return result;
}

void Piecewise::bend(const std::vector<double>& bulges) {
  for (std::size_t i = 0; i < bulges.size(); ++i) {
    const Ball length = breaks_[i + 1] - breaks_[i], rise = Ball(4.0 * bulges[i]) / length;
    Balls& c = pieces_[i + 1].coefficients;
    c[1] = c[1] + rise;
    c.push_back(Ball(0.0) - rise / length);
  }
}

bool Piecewise::is_zero() const {
  for (const Piece& piece : pieces_)
    for (const Ball& c : piece.coefficients)
      if (!arb_is_zero(c.get())) return false;
  return true;
}

void Piecewise::evaluate(const Piece& piece, const Ball& t, arb_ptr coefficients, slong n) {
  const Polynomial f(piece.coefficients), shift({t - piece.origin, Ball(1.0)});
  arb_poly_t shifted;
  arb_poly_init(shifted);
  arb_poly_compose(shifted, f.p, shift.p, bits);
  for (slong k = 0; k < n; ++k) arb_poly_get_coeff_arb(coefficients + k, shifted, k);
  arb_poly_clear(shifted);
}

std::size_t Piecewise::piece_after(const Ball& t) const {
  return static_cast<std::size_t>(std::upper_bound(breaks_.begin(), breaks_.end(), t, before) -
                                  breaks_.begin());
}

Ball Piecewise::mean(const Span& span) const {
  const std::size_t i = piece_after(span.begin);
  if ((i > 0 && before(span.begin, upper(breaks_[i - 1]))) ||
      (i < breaks_.size() && before(lower(breaks_[i]), span.end))) {
    Ball range;
    series(span, Mode::across, range.get(), 1);
    return range;
  }
  return polynomial(pieces_[i].coefficients, (span.begin + span.end) * Ball(0.5) - pieces_[i].origin);
}

void Piecewise::series(const Span& span, Mode mode, arb_ptr coefficients, slong n) const {
  if (mode == Mode::series || !before(span.begin, span.end)) {
    evaluate(pieces_[piece_after(span.begin)], span.ball(), coefficients, n);
    return;
  }
  const arb_ptr piece = _arb_vec_init(n);
  bool found = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    Ball t = span.ball();
    if (i > 0) {
      if (!before(lower(breaks_[i - 1]), span.end)) continue;
      arb_max(t.get(), t.get(), breaks_[i - 1].get(), bits);
    }
    if (i < breaks_.size()) {
      if (!before(span.begin, upper(breaks_[i]))) continue;
      arb_min(t.get(), t.get(), breaks_[i].get(), bits);
    }
    evaluate(pieces_[i], t, piece, n);
    for (slong k = 0; k < n; ++k)
      found ? arb_union(coefficients + k, coefficients + k, piece + k, bits)
            : arb_set(coefficients + k, piece + k);
    found = true;
  }
  _arb_vec_clear(piece, n);
}

Piecewise Piecewise::through(const Balls& below, const Balls& above, double joint) const {
  const auto composed = [](const Balls& outer, const Piece& inner) {
    const Polynomial f(outer), g(inner.coefficients);
    Polynomial h({});
    arb_poly_compose(h.p, f.p, g.p, bits);
    return Piece{inner.origin, h.coefficients()};
  };
  Piecewise result;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (i > 0) result.breaks_.push_back(breaks_[i - 1]);
    const bool varies = piece.coefficients.size() > 1 && !arb_is_zero(piece.coefficients[1].get());
    const Ball first = piece.coefficients[0];
    if (!varies) {
      result.pieces_.push_back(composed(first.middle() <= joint ? below : above, piece));
      continue;
    }
    const Ball at = piece.origin + (Ball(joint) - first) / piece.coefficients[1];
    const bool rises = piece.coefficients[1].is_positive();
    const bool inside = before(breaks_[i - 1], at) && before(at, breaks_[i]);
    const bool begins_below = inside ? rises : before(breaks_[i - 1], at) == rises;
    result.pieces_.push_back(composed(begins_below ? below : above, piece));
    if (!inside) continue;
    result.breaks_.push_back(at);
    result.pieces_.push_back(composed(begins_below ? above : below, piece));
  }
  return result;
}

void wave_series(const Wave& wave, const Span& span, arb_ptr coefficients, slong n) {
  Ball omega, scale(wave.amplitude), sine, cosine;
  arb_const_pi(omega.get(), bits);
  omega = omega * Ball(2.0) * Ball(wave.frequency);
  const Ball angle = omega * span.ball() + Ball(wave.phase);
  arb_sin_cos(sine.get(), cosine.get(), angle.get(), bits);
  for (slong k = 0; k < n; ++k) {
    if (k > 0) scale = scale * omega / Ball(static_cast<double>(k));
    Ball value = scale * (k % 2 ? cosine : sine);
    if (k % 4 >= 2) arb_neg(value.get(), value.get());
    if (k == 0) value = value + Ball(wave.mean);
    arb_set(coefficients + k, value.get());
  }
}

}  // namespace enclosure
