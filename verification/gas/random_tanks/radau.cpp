// SPDX-License-Identifier: Apache-2.0
#include "radau.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace random_tanks {
namespace {

constexpr std::size_t kStages = 3;
const double kRoot = std::sqrt(6.0);
const double kNodes[kStages] = {(4.0 - kRoot) / 10.0, (4.0 + kRoot) / 10.0, 1.0};
const double kWeights[kStages][kStages] = {
    {(88.0 - 7.0 * kRoot) / 360.0, (296.0 - 169.0 * kRoot) / 1800.0, (-2.0 + 3.0 * kRoot) / 225.0},
    {(296.0 + 169.0 * kRoot) / 1800.0, (88.0 + 7.0 * kRoot) / 360.0, (-2.0 - 3.0 * kRoot) / 225.0},
    {(16.0 - kRoot) / 36.0, (16.0 + kRoot) / 36.0, 1.0 / 9.0}};
constexpr int kMostNewtonIterations = 12;
// Newton's method ends at this share of the tolerance, or where rounding stops it.
constexpr double kShare = 0.01, kRounding = 2e-15;
constexpr double kFailed = std::numeric_limits<double>::infinity();  // error of a step that fails

}  // namespace

Radau::Radau(const Ode& ode, double tolerance)
    : ode_(ode),
      n_(ode.size()),
      tolerance_(tolerance),
      z_(kStages * n_),
      rate_(kStages * n_),
      right_(kStages * n_),
      matrix_(kStages * n_ * kStages * n_),
      block_(n_ * n_),
      point_(n_),
      size_(n_),
      whole_(n_),
      pivots_(kStages * n_) {}

/// I - h A x J, J of the start or, `full`, of each stage.
bool Radau::fill_matrix(double t, double h, std::span<const double> y, bool full) {
  const std::size_t all = kStages * n_;
  for (std::size_t j = 0; j < kStages; ++j) {
    if (full || j == 0) {
      for (std::size_t i = 0; i < n_; ++i) point_[i] = full ? y[i] + z_[j * n_ + i] : y[i];
      if (!ode_.jacobian(full ? t + kNodes[j] * h : t, point_, std::span(right_).first(n_), block_))
        return false;
    }
    for (std::size_t i = 0; i < kStages; ++i)
      for (std::size_t a = 0; a < n_; ++a)
        for (std::size_t b = 0; b < n_; ++b)
          matrix_[(i * n_ + a) * all + j * n_ + b] =
              (i == j && a == b ? 1.0 : 0.0) - h * kWeights[i][j] * block_[a * n_ + b];
  }
  return decompose();
}

bool Radau::decompose() {
  const std::size_t n = kStages * n_;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(matrix_[r * n + c]) > std::abs(matrix_[best * n + c])) best = r;
    if (!(std::abs(matrix_[best * n + c]) > 0.0)) return false;
    pivots_[c] = best;
    if (best != c) std::swap_ranges(&matrix_[c * n], &matrix_[c * n] + n, &matrix_[best * n]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double factor = matrix_[r * n + c] /= matrix_[c * n + c];
      if (factor == 0.0) continue;
      for (std::size_t k = c + 1; k < n; ++k) matrix_[r * n + k] -= factor * matrix_[c * n + k];
    }
  }
  return true;
}

void Radau::solve(std::vector<double>& b) const {
  const std::size_t n = kStages * n_;
  for (std::size_t c = 0; c < n; ++c) std::swap(b[c], b[pivots_[c]]);
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t k = 0; k < r; ++k) b[r] -= matrix_[r * n + k] * b[k];
  for (std::size_t r = n; r-- > 0;) {
    for (std::size_t k = r + 1; k < n; ++k) b[r] -= matrix_[r * n + k] * b[k];
    b[r] /= matrix_[r * n + r];
  }
}

bool Radau::newton(double t, double h, std::span<const double> y, std::span<double> end, bool full) {
  double before = kFailed;
  for (int iteration = 0; iteration < kMostNewtonIterations; ++iteration) {
    if ((full || iteration == 0) && !fill_matrix(t, h, y, full)) return false;
    for (std::size_t j = 0; j < kStages; ++j) {
      for (std::size_t i = 0; i < n_; ++i) point_[i] = y[i] + z_[j * n_ + i];
      if (!ode_.rates(t + kNodes[j] * h, point_, std::span(rate_).subspan(j * n_, n_))) return false;
    }
    for (std::size_t j = 0; j < kStages; ++j)
      for (std::size_t i = 0; i < n_; ++i) {
        double sum = -z_[j * n_ + i];
        for (std::size_t k = 0; k < kStages; ++k) sum += h * kWeights[j][k] * rate_[k * n_ + i];
        right_[j * n_ + i] = sum;
      }
    solve(right_);
    for (std::size_t i = 0; i < z_.size(); ++i) z_[i] += right_[i];
    for (std::size_t i = 0; i < n_; ++i) point_[i] = y[i] + z_[2 * n_ + i];
    ode_.sizes(t + h, point_, size_);
    double change = 0.0;
    for (std::size_t i = 0; i < z_.size(); ++i)
      change = std::max(change, std::abs(right_[i]) / size_[i % n_]);
    if (!std::isfinite(change)) return false;
    const double speed = change / before;
    if (iteration > 1 && speed > 0.9 && change > 10.0 * kRounding) return false;
    if (change <= kRounding ||
        (iteration > 0 &&
         change * std::min(1.0, speed / (1.0 - std::min(speed, 0.99))) <= kShare * tolerance_)) {
      for (std::size_t i = 0; i < n_; ++i) end[i] = y[i] + z_[2 * n_ + i];
      return true;
    }
    before = change;
  }
  return before <= 10.0 * kRounding;
}

/// Stages of a step of length h that begins at the share `from` of the course.
void Radau::guess(const Course& course, double from, double h) {
  std::ranges::fill(z_, 0.0);
  if (course.length == 0.0) return;
  const auto weight = [](std::size_t k, double x) {  // 1 at its node, 0 at the others and at the begin
    double w = x / kNodes[k];
    for (std::size_t j = 0; j < kStages; ++j)
      if (j != k) w *= (x - kNodes[j]) / (kNodes[k] - kNodes[j]);
    return w;
  };
  for (std::size_t j = 0; j < kStages; ++j)
    for (std::size_t k = 0; k < kStages; ++k) {
      const double w = weight(k, from + kNodes[j] * h / course.length) - weight(k, from);
      for (std::size_t i = 0; i < n_; ++i) z_[j * n_ + i] += w * course.changes[k * n_ + i];
    }
}

bool Radau::step_guessed(double t, double h, std::span<const double> y, std::span<double> end,
                         const Course& course, double from) {
  const bool empty = std::ranges::all_of(y, [](double v) { return v == 0.0; });
  guess(course, from, h);
  if (!empty && newton(t, h, y, end, false)) return true;
  for (const double share : {1.0, 0.0}) {
    std::ranges::fill(z_, 0.0);
    if (share > 0.0 && course.length > 0.0) guess(course, from, h);
    if (newton(t, h, y, end, true)) return true;
  }
  return false;
}

bool Radau::step(double t, double h, std::span<const double> y, std::span<double> end) {
  return step_guessed(t, h, y, end, before_, 1.0);
}

double Radau::pair(double t, double h, std::span<const double> y, std::span<double> middle,
                   std::span<double> end) {
  if (!step(t, h, y, whole_)) return kFailed;
  const Course course{h, z_};
  if (!step_guessed(t, 0.5 * h, y, middle, course, 0.0) ||
      !step_guessed(t + 0.5 * h, 0.5 * h, middle, end, course, 0.5))
    return kFailed;
  pair_end_ = {0.5 * h, z_};
  ode_.sizes(t + h, end, size_);
  double error = 0.0;
  for (std::size_t i = 0; i < n_; ++i) error = std::max(error, std::abs(end[i] - whole_[i]) / size_[i]);
  return std::isfinite(error) ? error / tolerance_ : kFailed;
}

void Radau::go_on() {
  before_ = pair_end_;
}

}  // namespace random_tanks
