// SPDX-License-Identifier: Apache-2.0
#include "tank_test/smoothing_spline.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <elementary/error_function.hpp>
#include <string>

#include "demmler_reinsch.hpp"
#include "readings.hpp"
#include "require.hpp"

namespace gas {
namespace {

constexpr std::size_t kOrder = SplineBasis::kOrder;
constexpr std::size_t kPenalisedDerivative = 3;
constexpr std::size_t kReadingsPerInterval = 4;
constexpr std::size_t kFineIntervals = 160;  // up to this number intervals may hold two readings, for short
                                             // records
constexpr int kRounds = 2;                   // the first finds where the spline bends
constexpr double kLeastRoughness = 1e-3;     // share of the largest: so that no part of the record is forced
                                             // straight

/// Breakpoints at every n-th time, so that each interval holds readings.
gsl::Spline make_spline(std::span<const double> times, double length) {
  const std::size_t last = times.size() - 1;
  const std::size_t intervals =
      std::max(std::min(SmoothingSpline::kMostIntervals, last / kReadingsPerInterval),
               std::min(kFineIntervals, last / 2));
  gsl::Spline spline(gsl::allocated(gsl_bspline_alloc(kOrder, intervals + 1)));
  gsl::Vector breaks = gsl::vector(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i)
    gsl_vector_set(breaks.get(), i, (times[i * last / intervals] - times[0]) / length);
  gsl::check(gsl_bspline_knots(breaks.get(), spline.get()), "knots");
  return spline;
}

}  // namespace

struct SmoothingSpline::Workspace {
  gsl::Spline spline;
  gsl::Matrix values = gsl::matrix(kOrder, kPenalisedDerivative + 1);

  std::size_t size() const { return gsl_bspline_ncoeffs(spline.get()); }
  /// Fills `values` (basis function by derivative) at x; returns the first function's number.
  std::size_t evaluate(double x) {
    std::size_t first = 0, last = 0;
    gsl::check(
        gsl_bspline_deriv_eval_nonzero(x, kPenalisedDerivative, values.get(), &first, &last, spline.get()),
        "evaluation");
    return first;
  }
  double value(std::size_t j, std::size_t derivative) const {
    return gsl_matrix_get(values.get(), j, derivative);
  }
  /// Adds factor v v^T of the functions' `derivative` at x; returns the first function's number.
  std::size_t add_square(double x, std::size_t derivative, double factor, gsl_matrix* sum) {
    const std::size_t first = evaluate(x);
    for (std::size_t i = 0; i < kOrder; ++i)
      for (std::size_t j = 0; j < kOrder; ++j)
        *gsl_matrix_ptr(sum, first + i, first + j) += factor * value(i, derivative) * value(j, derivative);
    return first;
  }
  gsl::Matrix penalty(std::span<const double> stiffness);
  std::size_t intervals() const { return gsl_bspline_nbreak(spline.get()) - 1; }
  std::vector<double> roughness(std::span<const double> coefficients, std::size_t reach);
};

/// int w B_i''' B_j''' dx; the product is of degree 4, for which three Gauss points are exact.
gsl::Matrix SmoothingSpline::Workspace::penalty(std::span<const double> stiffness) {
  gsl::Matrix sum = gsl::matrix(size(), size());
  gsl_integration_glfixed_table* table = gsl::allocated(gsl_integration_glfixed_table_alloc(3));
  for (std::size_t i = 0; i + 1 < gsl_bspline_nbreak(spline.get()); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      double x = 0.0, weight = 0.0;
      gsl_integration_glfixed_point(gsl_bspline_breakpoint(i, spline.get()),
                                    gsl_bspline_breakpoint(i + 1, spline.get()), k, &x, &weight, table);
      add_square(x, kPenalisedDerivative, weight * stiffness[i], sum.get());
    }
  gsl_integration_glfixed_table_free(table);
  return sum;
}

/// s'''^2 by intervals, averaged over `reach` intervals on each side.
std::vector<double> SmoothingSpline::Workspace::roughness(std::span<const double> coefficients,
                                                          std::size_t reach) {
  std::vector<double> square, mean;
  for (std::size_t i = 0; i < intervals(); ++i) {
    const std::size_t first = evaluate(
        0.5 * (gsl_bspline_breakpoint(i, spline.get()) + gsl_bspline_breakpoint(i + 1, spline.get())));
    double third = 0.0;
    for (std::size_t j = 0; j < kOrder; ++j)
      third += value(j, kPenalisedDerivative) * coefficients[first + j];
    square.push_back(third * third);
  }
  for (std::size_t i = 0; i < square.size(); ++i) {
    const std::size_t low = i - std::min(i, reach), high = std::min(square.size() - 1, i + reach);
    double sum = 0.0;
    for (std::size_t j = low; j <= high; ++j) sum += square[j];
    mean.push_back(sum / static_cast<double>(high - low + 1));
  }
  return mean;
}

SplinePoint evaluate(const SplineBasis& basis, std::span<const double> coefficients) {
  require(basis.first + kOrder <= coefficients.size(), "number of coefficients",
          static_cast<double>(coefficients.size()), "the basis needs more");
  SplinePoint point{0.0, 0.0};
  for (std::size_t j = 0; j < kOrder; ++j) {
    point.value += basis.value[j] * coefficients[basis.first + j];
    point.slope += basis.slope[j] * coefficients[basis.first + j];
  }
  return point;
}

SmoothingSpline::SmoothingSpline(std::span<const double> times, std::span<const double> readings,
                                 std::string_view name, Noise noise) {
  check_readings(times, readings, name, noise);
  const gsl::ReturnCodes guard;
  begin_ = times.front();
  length_ = times.back() - times.front();
  workspace_ = std::make_unique<Workspace>(Workspace{make_spline(times, length_)});
  fit(times, readings, noise);
}

SmoothingSpline::~SmoothingSpline() = default;
SmoothingSpline::SmoothingSpline(SmoothingSpline&&) noexcept = default;

void SmoothingSpline::fit(std::span<const double> times, std::span<const double> readings, Noise noise) {
  const std::size_t n = workspace_->size();
  const double scale = *std::ranges::max_element(readings);
  const std::vector<double> weights = root_weights(readings, noise);
  gsl::Matrix gram = gsl::matrix(n, n);
  std::vector<double> right(n, 0.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double root = weights[i] * scale, weight = root * root;
    const std::size_t first = workspace_->add_square((times[i] - begin_) / length_, 0, weight, gram.get());
    for (std::size_t j = 0; j < kOrder; ++j)
      right[first + j] += weight * workspace_->value(j, 0) * readings[i] / scale;
  }
  std::vector<double> stiffness(workspace_->intervals(), 1.0);
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) {
      const double top = *std::ranges::max_element(roughness_);
      if (!(top > 0.0)) break;  // a parabola
      for (std::size_t i = 0; i < stiffness.size(); ++i)
        stiffness[i] = 1.0 / std::sqrt(roughness_[i] / top + kLeastRoughness);
    }
    gsl::Matrix copy = gsl::matrix(n, n);
    gsl_matrix_memcpy(copy.get(), gram.get());
    Modes modes = make_modes(std::move(copy), workspace_->penalty(stiffness));
    std::vector<double> amplitudes = modes.amplitudes(right);
    const double rest = residual(times, readings, weights, modes.sum(amplitudes, scale));
    const auto count = static_cast<double>(times.size());
    std::vector<double> sorted = modes.roughness;
    std::ranges::nth_element(sorted, sorted.begin() + 2);
    const Scores scores{modes.roughness, amplitudes, rest, count, sorted[2]};
    Lambdas lambdas = scores.likely();
    const double degrees = scores.degrees_of_freedom(lambdas.best);
    posterior_ = std::make_unique<Posterior>(
        Posterior{std::move(modes), std::move(amplitudes), std::move(lambdas), scale, degrees});
    coefficients_ = posterior_->coefficients();
    posterior_->noise = std::sqrt(residual(times, readings, weights, coefficients_) / (count - degrees));
    const double cell = static_cast<double>(stiffness.size()) / degrees;
    roughness_ = workspace_->roughness(coefficients_, static_cast<std::size_t>(0.5 * cell));
  }
}

/// Weighted sum of squares of the readings minus the spline.
double SmoothingSpline::residual(std::span<const double> times, std::span<const double> readings,
                                 std::span<const double> weights,
                                 std::span<const double> coefficients) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double miss = weights[i] * (readings[i] - evaluate(basis(times[i]), coefficients).value);
    sum += miss * miss;
  }
  return sum;
}

double SmoothingSpline::smoothing() const {
  return posterior_->lambdas.best;
}

double SmoothingSpline::degrees_of_freedom() const {
  return posterior_->degrees_of_freedom;
}

double SmoothingSpline::noise() const {
  return posterior_->noise;
}

SplineBasis SmoothingSpline::basis(double time) const {
  require(std::isfinite(time), "time [s]", time, "must be finite");
  const gsl::ReturnCodes guard;
  SplineBasis basis{};
  basis.first = workspace_->evaluate(std::clamp((time - begin_) / length_, 0.0, 1.0));
  for (std::size_t j = 0; j < kOrder; ++j) {
    basis.value[j] = workspace_->value(j, 0);
    basis.slope[j] = workspace_->value(j, 1) / length_;
  }
  return basis;
}

double SmoothingSpline::roughness(double time) const {
  require(std::isfinite(time), "time [s]", time, "must be finite");
  const double x = (time - begin_) / length_;
  std::size_t i = 0;
  while (i + 1 < roughness_.size() && gsl_bspline_breakpoint(i + 1, workspace_->spline.get()) < x) ++i;
  return roughness_[i];
}

SplinePoint SmoothingSpline::deviation(const SplineBasis& basis) const {
  const std::size_t n = coefficients_.size();
  require(basis.first + kOrder <= n, "basis", static_cast<double>(basis.first), "is not of this spline");
  return posterior_->deviation(basis);
}

void SmoothingSpline::draw(std::span<const double> normals, double undersmoothing,
                           std::span<double> coefficients) const {
  const std::size_t n = coefficients_.size();
  require(normals.size() == n + 1, "number of normal numbers", static_cast<double>(normals.size()),
          "must be one more than the coefficients");
  require(std::isfinite(undersmoothing) && undersmoothing > 0.0, "undersmoothing", undersmoothing,
          "must be above 0 and finite");
  require(coefficients.size() == n, "number of coefficients", static_cast<double>(coefficients.size()),
          "must be the spline's");
  for (const double number : normals)
    require(std::isfinite(number), "normal number", number, "must be finite");
  const double probability = 0.5 * elementary::erfc(-normals[n] / std::sqrt(2.0));
  const double lambda = posterior_->lambdas.quantile(probability) / undersmoothing;
  std::ranges::copy(posterior_->draw(lambda, normals), coefficients.begin());
}

}  // namespace gas
