// SPDX-License-Identifier: Apache-2.0
// Right-hand sides as lists of operations.
#pragma once

#include <functional>
#include <memory>

#include "ball.hpp"

namespace enclosure {

/// A span of time between two exact times [s]; both may be the same.
struct Span {
  Ball begin, end;
  Ball ball() const { return hull(begin, end); }
};

/// What is asked for over a span: Taylor coefficients, within one formula of the law; or coefficient 0 of the
/// rates, across switches of the law and breaks of functions of time: its range, or with the mean of each
/// inflow in place of its range. Rates are linear in the inflows, which are not negative, with factors that
/// no switch changes (but at 1000 K, where T is not asked for), so that step times rate then still encloses
/// the integral of the rate (mean value theorem of integrals).
enum class Mode { series, across, across_mean };

/// Writes coefficients 0 to n-1 of a function of time, which enclose those at every time of the span.
using TimeSeries = std::function<void(const Span& span, Mode mode, arb_ptr coefficients, slong n)>;

enum class Op {
  constant,
  time,
  state,
  add,
  subtract,
  multiply,
  divide,
  root,
  exponential,
  logarithm,
  within
};

/// One operation.
struct Node {
  Op op;
  int a = -1, b = -1;  // operands; of a state its number
  bool moves = false;  // depends on the state
  Ball low{}, high{};  // constant: its value (low); within: the bounds, if any
  bool has_low = false, has_high = false;
  TimeSeries series{};  // time
};

class Tape;

/// A value on a tape. Arithmetic adds to the tape.
struct Term {
  Tape* tape;
  int id;
};

/// Operations in the order in which they are computed.
class Tape {
 public:
  Term constant(const Ball& value);
  Term time(TimeSeries series);
  Term state(int number);
  Term add(Op op, int a, int b = -1);
  /// The same value. Where a series is asked across a switch, only the part of it that lies within bounds.
  Term within(Term a, const Ball* low, const Ball* high);
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::vector<Node> nodes_;
};

inline Term operator+(Term a, Term b) {
  return a.tape->add(Op::add, a.id, b.id);
}
inline Term operator-(Term a, Term b) {
  return a.tape->add(Op::subtract, a.id, b.id);
}
inline Term operator*(Term a, Term b) {
  return a.tape->add(Op::multiply, a.id, b.id);
}
inline Term operator/(Term a, Term b) {
  return a.tape->add(Op::divide, a.id, b.id);
}
inline Term operator+(Term a, const Ball& b) {
  return a + a.tape->constant(b);
}
inline Term operator-(Term a, const Ball& b) {
  return a - a.tape->constant(b);
}
inline Term operator*(Term a, const Ball& b) {
  return a * a.tape->constant(b);
}
inline Term operator/(Term a, const Ball& b) {
  return a / a.tape->constant(b);
}
inline Term operator-(const Ball& a, Term b) {
  return b.tape->constant(a) - b;
}
inline Term operator/(const Ball& a, Term b) {
  return b.tape->constant(a) / b;
}
inline Term sqrt(Term a) {
  return a.tape->add(Op::root, a.id);
}
inline Term exp(Term a) {
  return a.tape->add(Op::exponential, a.id);
}
inline Term log(Term a) {
  return a.tape->add(Op::logarithm, a.id);
}

}  // namespace enclosure
