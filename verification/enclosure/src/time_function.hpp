// SPDX-License-Identifier: Apache-2.0
// Functions of time: piecewise polynomials, and the wave of a volume.
#pragma once

#include "enclosure/scene.hpp"
#include "tape.hpp"

namespace enclosure {

/// Polynomials between breaks. Break times are balls: some are roots.
class Piecewise {
 public:
  /// A curve that begins at time `start` [s]. Outside its knots it is zero or keeps the nearest value.
  Piecewise(const Curve& curve, const Ball& start, bool zero_outside);
  /// A curve that begins anew at each odd time, and is zero before it and from each even one.
  static Piecewise switched(const Curve& curve, const Balls& times);
  /// Makes the piece between knots i and i + 1 a parabola whose middle is bulges[i] further than before.
  void bend(const std::vector<double>& bulges);

  /// Taylor coefficients (see TimeSeries).
  void series(const Span& span, Mode mode, arb_ptr coefficients, slong n) const;
  /// Mean of a piecewise linear function over a span; its range if a break lies within.
  Ball mean(const Span& span) const;
  const Balls& breaks() const { return breaks_; }
  bool is_zero() const;  // everywhere

  /// The function where(f(t)): `below` as a polynomial of f up to f = joint, `above` from there on. The joint
  /// becomes a break where f passes it.
  Piecewise through(const Balls& below, const Balls& above, double joint) const;

 private:
  struct Piece {
    Ball origin;         // [s]
    Balls coefficients;  // powers of t - origin
  };
  Piecewise() = default;
  static void evaluate(const Piece& piece, const Ball& t, arb_ptr coefficients, slong n);
  std::size_t piece_after(const Ball& t) const;

  Balls breaks_;
  std::vector<Piece> pieces_;  // one more than breaks
};

/// Taylor coefficients of a wave (see TimeSeries): V^(k)/k! = amplitude omega^k/k! sin(omega t + phase + k
/// pi/2).
void wave_series(const Wave& wave, const Span& span, arb_ptr coefficients, slong n);

}  // namespace enclosure
