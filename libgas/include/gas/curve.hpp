// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace gas {

/// How a Curve goes on outside its knots.
enum class Outside {
  zero,  // it is zero (a mass flow)
  held,  // it keeps the value of the nearest knot (a temperature)
};

/// Side of a jump.
enum class Side {
  before,  // the value just before the jump
  after,   // the value just after the jump
};

/// Piecewise linear function of time through knots (t, value). Two knots at the same time make a jump: the
/// first is the value before it, the second the value after it. Curves of vents, fabrics and the volume may
/// have the overpressure [Pa] in place of time.
class Curve {
 public:
  /// A point of the curve.
  struct Knot {
    double time;   // [s]
    double value;  // in the unit of the quantity
  };
  /// One linear piece: value(t) = value + slope (t - origin).
  struct Piece {
    double origin;  // [s]
    double value;   // at the origin, in the unit of the quantity
    double slope;   // [unit/s]
    /// Value at `time` [s]. Outside the piece the line continues.
    template <class Number>
    Number at(const Number& time) const {
      return value + slope * (time - origin);
    }
  };

  /// Throws std::invalid_argument for
  /// - no knot (fewer than two if zero outside),
  /// - a number that is not finite,
  /// - a time earlier than the one before, or three knots at one time,
  /// - two knots so close that the slope between them overflows.
  Curve(std::vector<Knot> knots, Outside outside);
  /// A constant curve: one knot, held.
  static Curve constant(double value);

  /// Value at `time` [s]. Where the curve jumps, `side` selects the value. A curve that is zero outside still
  /// has its own value at the first and the last knot.
  double value(double time, Side side = Side::after) const;
  /// The linear piece around `time` [s]; at a knot the one after it.
  Piece piece(double time) const;
  /// Time [s] of the first knot later than `time`; infinity if there is none or the curve is constant.
  double next_knot(double time) const;
  /// Time [s] of the knot nearest to `time`; infinity if the curve is constant.
  double nearest_knot(double time) const;
  /// Integral over [a, b], a <= b [s], exact to round-off.
  double integral(double a, double b) const;
  /// Time [s] of the first jump; empty if there is none.
  std::optional<double> first_jump() const;

  /// The knots as given; their times do not fall.
  std::span<const Knot> knots() const { return knots_; }
  Outside outside() const { return outside_; }             // as given
  bool is_constant() const { return knots_.size() == 1; }  // one knot: the same value everywhere
  double minimum() const;                                  // smallest value at a knot
  double maximum() const;                                  // largest value at a knot

 private:
  std::vector<Knot> knots_;
  Outside outside_;
};

/// Integral of the product of two curves over [a, b], a <= b [s], exact to round-off.
double product_integral(const Curve& f, const Curve& g, double a, double b);

}  // namespace gas
