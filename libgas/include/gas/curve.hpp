// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace gas {

/// How a Curve goes on outside its knots.
enum class Outside {
  zero,  // zero (a mass flow)
  held,  // that of the nearest knot (a temperature)
};

/// Side of a jump.
enum class Side {
  before,  // value that the curve reaches
  after,   // value from which it goes on
};

/// Piecewise linear function of time through knots (t, value). Two knots at one time make a jump: the first
/// one is the value before it, the second the value from that time on. Vents, fabrics and the volume have
/// curves of the overpressure [Pa], which then stands for the time.
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
    /// Value at `time` [s]. Outside the piece its line is continued.
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

  /// Value at `time` [s]. Where the curve jumps, `side` selects the value. At the first and last knot a curve
  /// that is zero outside has its value inside.
  double value(double time, Side side = Side::after) const;
  /// The linear piece around `time` [s]; at a knot the one after it.
  Piece piece(double time) const;
  /// Time [s] of the first knot later than `time`; infinity if there is none or the curve is constant.
  double next_knot(double time) const;
  /// Time [s] of the knot nearest to `time`; infinity if the curve is constant.
  double nearest_knot(double time) const;
  /// Integral over [a, b], a <= b [s], exact to round-off.
  double integral(double a, double b) const;
  /// Time [s] of the first jump, if there is one.
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
