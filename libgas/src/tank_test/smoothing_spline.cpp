// SPDX-License-Identifier: Apache-2.0
#include "tank_test/smoothing_spline.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "demmler_reinsch.hpp"
#include "require.hpp"

namespace gas {
namespace {

constexpr std::size_t kOrder = SplineBasis::kOrder;
constexpr std::size_t kPenalisedDerivative = 3;
constexpr double kSmallestShare = 1e-6;  // of the largest reading
constexpr std::size_t kReadingsPerInterval = 4;
constexpr std::size_t kWeightReach = 4;  // readings on each side in the mean that sets a weight

void check_readings(std::span<const double> times, std::span<const double> readings, std::string_view name) {
  require(times.size() >= SmoothingSpline::kFewestReadings, "number of readings",
          static_cast<double>(times.size()), "20 or more are needed");
  require(readings.size() == times.size(), "number of readings", static_cast<double>(readings.size()),
          "must be one for each time");
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1]))
      throw ReadingError("time", i, to_text(times[i]) + " s: must be finite and later than the time before");
    if (!std::isfinite(readings[i]) || readings[i] <= 0.0)
      throw ReadingError(name, i, to_text(readings[i]) + ": must be above 0 and finite");
  }
  // Weights go with the inverse square: beyond this the normal equations have no digits left.
  const double least = kSmallestShare * *std::ranges::max_element(readings);
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (!(readings[i] >= least && std::isfinite(least)))
      throw ReadingError(name, i, to_text(readings[i]) + ": must not be below a millionth of the largest");
  if (!std::isfinite(times.back() - times.front()))
    throw ReadingError("time", times.size() - 1, "the record is too long");
}

/// 1/(mean of the readings near i): a weight from the reading itself would favour low ones.
std::vector<double> root_weights(std::span<const double> readings) {
  std::vector<double> weights(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::size_t reach = std::min({kWeightReach, i, readings.size() - 1 - i});
    double sum = 0.0;
    for (std::size_t j = i - reach; j <= i + reach; ++j) sum += readings[j];
    weights[i] = static_cast<double>(2 * reach + 1) / sum;
  }
  return weights;
}

/// Breakpoints at every n-th time, so that each interval holds readings however they are spaced.
gsl::Spline make_spline(std::span<const double> times, double length) {
  const std::size_t last = times.size() - 1;
  const std::size_t intervals = std::min(SmoothingSpline::kMostIntervals, last / kReadingsPerInterval);
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
  gsl::Matrix penalty();
};

/// int B_i''' B_j''' dx; the product is of degree 4, for which three Gauss points are exact.
gsl::Matrix SmoothingSpline::Workspace::penalty() {
  gsl::Matrix sum = gsl::matrix(size(), size());
  gsl_integration_glfixed_table* table = gsl::allocated(gsl_integration_glfixed_table_alloc(3));
  for (std::size_t i = 0; i + 1 < gsl_bspline_nbreak(spline.get()); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      double x = 0.0, weight = 0.0;
      gsl_integration_glfixed_point(gsl_bspline_breakpoint(i, spline.get()),
                                    gsl_bspline_breakpoint(i + 1, spline.get()), k, &x, &weight, table);
      add_square(x, kPenalisedDerivative, weight, sum.get());
    }
  gsl_integration_glfixed_table_free(table);
  return sum;
}

SplinePoint evaluate(const SplineBasis& basis, std::span<const double> coefficients) {
  SplinePoint point{0.0, 0.0};
  for (std::size_t j = 0; j < kOrder; ++j) {
    point.value += basis.value[j] * coefficients[basis.first + j];
    point.slope += basis.slope[j] * coefficients[basis.first + j];
  }
  return point;
}

SmoothingSpline::SmoothingSpline(std::span<const double> times, std::span<const double> readings,
                                 std::string_view name) {
  check_readings(times, readings, name);
  const gsl::ReturnCodes guard;
  begin_ = times.front();
  length_ = times.back() - times.front();
  workspace_ = std::make_unique<Workspace>(Workspace{make_spline(times, length_)});
  fit(times, readings);
}

SmoothingSpline::~SmoothingSpline() = default;
SmoothingSpline::SmoothingSpline(SmoothingSpline&&) noexcept = default;

void SmoothingSpline::fit(std::span<const double> times, std::span<const double> readings) {
  const std::size_t n = workspace_->size();
  const double scale = *std::ranges::max_element(readings);
  const std::vector<double> weights = root_weights(readings);
  gsl::Matrix gram = gsl::matrix(n, n);
  std::vector<double> right(n, 0.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double root = weights[i] * scale, weight = root * root;
    const std::size_t first = workspace_->add_square((times[i] - begin_) / length_, 0, weight, gram.get());
    for (std::size_t j = 0; j < kOrder; ++j)
      right[first + j] += weight * workspace_->value(j, 0) * readings[i] / scale;
  }
  const Modes modes = make_modes(std::move(gram), workspace_->penalty());
  std::vector<double> amplitudes = modes.amplitudes(right);
  const double rest = residual(times, readings, weights, modes.sum(amplitudes, scale));
  const auto count = static_cast<double>(times.size());
  const Scores scores{modes.roughness, amplitudes, rest, count};
  smoothing_ = scores.best();
  degrees_of_freedom_ = scores.degrees_of_freedom(smoothing_);
  for (std::size_t k = 0; k < n; ++k) amplitudes[k] /= 1.0 + smoothing_ * modes.roughness[k];
  coefficients_ = modes.sum(amplitudes, scale);
  noise_ = std::sqrt(residual(times, readings, weights, coefficients_) / (count - degrees_of_freedom_));
  spread_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      spread_[i * n + k] =
          noise_ * scale * modes.column(i, k) / std::sqrt(1.0 + smoothing_ * modes.roughness[k]);
}

/// Weighted sum of squares of what `coefficients` leave of the readings.
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

SplineBasis SmoothingSpline::basis(double time) const {
  SplineBasis basis{};
  basis.first = workspace_->evaluate(std::clamp((time - begin_) / length_, 0.0, 1.0));
  for (std::size_t j = 0; j < kOrder; ++j) {
    basis.value[j] = workspace_->value(j, 0);
    basis.slope[j] = workspace_->value(j, 1) / length_;
  }
  return basis;
}

void SmoothingSpline::draw(std::span<const double> normals, std::span<double> coefficients) const {
  const std::size_t n = coefficients_.size();
  for (std::size_t i = 0; i < n; ++i) {
    coefficients[i] = coefficients_[i];
    for (std::size_t k = 0; k < n; ++k) coefficients[i] += spread_[i * n + k] * normals[k];
  }
}

}  // namespace gas
