// SPDX-License-Identifier: Apache-2.0
// The set of states that the tube holds at one time.
#pragma once

#include "ball.hpp"

namespace enclosure {

/// Square matrix of balls, row by row.
struct Matrix {
  explicit Matrix(std::size_t size) : n(size), entries(size * size) {}
  static Matrix identity(std::size_t n);
  Ball& at(std::size_t i, std::size_t j) { return entries[i * n + j]; }
  const Ball& at(std::size_t i, std::size_t j) const { return entries[i * n + j]; }
  std::size_t n;
  Balls entries;
};
Matrix operator*(const Matrix& a, const Matrix& b);
Balls operator*(const Matrix& a, const Balls& x);
/// Encloses the inverse of every matrix in `a`; not finite if it cannot. Gauss's elimination in balls
/// (arb_mat_inv).
Matrix inverse(const Matrix& a);

/// The set { centre + B r : r in its balls } of R. J. Lohner, "Enclosing the solutions of ordinary initial
/// and boundary value problems", 1987: axes B that turn with the flow keep contraction, where a box would
/// swell by wrapping in each step.
class MovingSet {
 public:
  explicit MovingSet(const Balls& box);
  const Balls& centre() const { return centre_; }  // exact
  Balls box() const;                               // contains the set

  /// Encloses f(x) - f(centre) of each x in the set, by the mean value theorem with f'(x) of all x in box().
  Ball deviation(const Balls& slopes) const;
  /// Replaces the set by one that contains f(x) of each x in it. `image` holds f(centre), `slopes` f'(x) of
  /// all x in box(). By the mean value theorem f(x) lies in image + slopes (x - centre). `scale` has the unit
  /// of each component, in which the new axes are orthogonal: it should be such that errors of 1 matter
  /// alike.
  void advance(const Balls& image, const Matrix& slopes, const std::vector<double>& scale);
  /// Adds an interval vector.
  void add(const Balls& step);

 private:
  Balls centre_, spread_;
  Matrix axes_;     // exact
  Matrix inverse_;  // of the axes
};

}  // namespace enclosure
