// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace gas {

/// Value of a Curve outside its knots.
enum class Outside {
  zero,  // zero (a mass flow)
  held,  // that of the nearest knot (a temperature)
};

/// Which value of a curve where it jumps.
enum class Side {
  before,  // that which it comes to
  after,   // that from which it goes on
};

/// Piecewise linear function of time through knots (t, value). Two knots at one time are a jump: the first is
/// the value that the curve comes to, the second the value from that time on.
class Curve {
 public:
  /// A point of the curve.
  struct Knot {
    double time;   // [s]
    double value;  // in the unit of the quantity
  };
  /// value(t) = value + slope (t - origin) on one piece.
  struct Piece {
    double origin;  // [s]
    double value;   // at the origin, in the unit of the quantity
    double slope;   // [unit/s]
    /// Value at `time` [s], on the piece's line even outside the piece.
    double at(double time) const { return value + slope * (time - origin); }
  };

  /// Throws std::invalid_argument if there is no knot (zero outside: fewer than two), a number is not finite,
  /// a time is earlier than the one before, or three knots stand at one time.
  Curve(std::vector<Knot> knots, Outside outside);
  /// The same value at all times.
  static Curve constant(double value);

  /// Value at time t; where it jumps, on that side. At the first and the last knot of a curve that is zero
  /// outside the value inside.
  double value(double time, Side side = Side::after) const;
  /// The linear piece that holds in the neighbourhood of `time`, which is not a knot.
  Piece piece(double time) const;
  /// First knot later than `time`, or infinity.
  double next_knot(double time) const;
  /// The knot nearest to `time`, infinitely far if there is none (a constant).
  double nearest_knot(double time) const;
  /// Integral over [a, b], a <= b, exact to round-off.
  double integral(double a, double b) const;
  /// Where it jumps for the first time, if it does.
  std::optional<double> first_jump() const;

  /// As given; no time is earlier than the one before.
  std::span<const Knot> knots() const { return knots_; }
  Outside outside() const { return outside_; }             // as given
  bool is_constant() const { return knots_.size() == 1; }  // one knot: the same everywhere
  double minimum() const;                                  // smallest value at a knot
  double maximum() const;                                  // largest value at a knot

 private:
  std::vector<Knot> knots_;
  Outside outside_;
};

/// Integral of the product of two curves over [a, b], a <= b, exact to round-off.
double product_integral(const Curve& f, const Curve& g, double a, double b);

}  // namespace gas
