// SPDX-License-Identifier: Apache-2.0
#include "moving_set.hpp"

#include <arb_mat.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enclosure {
namespace {

using Doubles = std::vector<double>;

/// Orthogonal matrix Q of Q R = A, by Householder's reflections. Rounding does no harm: any Q is valid.
Doubles orthogonal(Doubles a, std::size_t n) {
  Doubles q(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) q[i * n + i] = 1.0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    Doubles v(n, 0.0);
    double norm = 0.0;
    for (std::size_t i = k; i < n; ++i) norm = std::hypot(norm, v[i] = a[i * n + k]);
    if (!(norm > 0.0)) continue;
    for (double& x : v) x /= norm;
    v[k] += v[k] < 0.0 ? -1.0 : 1.0;
    const double square = std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
    for (std::size_t j = 0; j < n; ++j) {  // A := H A, Q := Q H
      double left = 0.0, right = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        left += v[i] * a[i * n + j];
        right += q[j * n + i] * v[i];
      }
      for (std::size_t i = 0; i < n; ++i) {
        a[i * n + j] -= 2.0 * left / square * v[i];
        q[j * n + i] -= 2.0 * right / square * v[i];
      }
    }
  }
  return q;
}

/// Exact matrix near A, with nearly orthogonal columns in units of `scale`; the longest column of A leads.
Matrix axes_along(const Matrix& a, const Balls& spread, const Doubles& scale) {
  const std::size_t n = a.n;
  Doubles lengths(n, 0.0), sorted(n * n);
  std::vector<std::size_t> order(n);
  for (std::size_t j = 0; j < n; ++j) {
    order[j] = j;
    for (std::size_t i = 0; i < n; ++i)
      lengths[j] = std::hypot(lengths[j], a.at(i, j).middle() / scale[i] * spread[j].radius());
  }
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return lengths[i] > lengths[j]; });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) sorted[i * n + j] = a.at(i, order[j]).middle() / scale[i];
  const Doubles q = orthogonal(sorted, n);
  Matrix axes(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) axes.at(i, j) = Ball(q[i * n + j] * scale[i]);
  return axes;
}

}  // namespace

Matrix Matrix::identity(std::size_t n) {
  Matrix one(n);
  for (std::size_t i = 0; i < n; ++i) one.at(i, i) = Ball(1.0);
  return one;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix c(a.n);
  for (std::size_t i = 0; i < a.n; ++i)
    for (std::size_t j = 0; j < a.n; ++j)
      for (std::size_t k = 0; k < a.n; ++k)
        arb_addmul(c.at(i, j).get(), a.at(i, k).get(), b.at(k, j).get(), bits);
  return c;
}

Balls operator*(const Matrix& a, const Balls& x) {
  Balls y(a.n);
  for (std::size_t i = 0; i < a.n; ++i)
    for (std::size_t j = 0; j < a.n; ++j) arb_addmul(y[i].get(), a.at(i, j).get(), x[j].get(), bits);
  return y;
}

Matrix inverse(const Matrix& a) {
  arb_mat_t in, out;
  const auto n = static_cast<slong>(a.n);
  arb_mat_init(in, n, n);
  arb_mat_init(out, n, n);
  for (std::size_t i = 0; i < a.entries.size(); ++i) arb_set(in->entries + i, a.entries[i].get());
  if (!arb_mat_inv(out, in, bits)) arb_mat_indeterminate(out);
  Matrix result(a.n);
  for (std::size_t i = 0; i < a.entries.size(); ++i) arb_set(result.entries[i].get(), out->entries + i);
  arb_mat_clear(in);
  arb_mat_clear(out);
  return result;
}

MovingSet::MovingSet(const Balls& box)
    : axes_(Matrix::identity(box.size())), inverse_(Matrix::identity(box.size())) {
  for (const Ball& x : box) {
    centre_.push_back(midpoint(x));
    spread_.push_back(enclosure::spread(x));
  }
}

Balls MovingSet::box() const {
  Balls x = axes_ * spread_;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + centre_[i];
  return x;
}

Ball MovingSet::deviation(const Balls& slopes) const {
  Ball sum;
  for (std::size_t j = 0; j < spread_.size(); ++j) {
    Ball along;
    for (std::size_t i = 0; i < slopes.size(); ++i) along = along + slopes[i] * axes_.at(i, j);
    sum = sum + along * spread_[j];
  }
  return sum;
}

void MovingSet::advance(const Balls& image, const Matrix& slopes, const std::vector<double>& scale) {
  const Matrix moved = slopes * axes_;
  axes_ = axes_along(moved, spread_, scale);
  inverse_ = inverse(axes_);
  spread_ = inverse_ * moved * spread_;
  centre_ = Balls(image.size());
  add(image);
}

void MovingSet::add(const Balls& step) {
  Balls rest(step.size());
  for (std::size_t i = 0; i < step.size(); ++i) {
    const Ball sum = centre_[i] + step[i];
    centre_[i] = midpoint(sum);
    rest[i] = enclosure::spread(sum);
  }
  const Balls turned = inverse_ * rest;
  for (std::size_t i = 0; i < step.size(); ++i) spread_[i] = spread_[i] + turned[i];
}

}  // namespace enclosure
