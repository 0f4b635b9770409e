// SPDX-License-Identifier: Apache-2.0
#include "demmler_reinsch.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

namespace gas {
namespace {

constexpr double kGridRatio = 1.2589254117941673;  // ten values of lambda a decade
constexpr double kFewestDegrees = 3.01;            // degrees of freedom
constexpr double kParabola = 3.0;                  // coefficients that no lambda smooths

}  // namespace

Modes make_modes(gsl::Matrix gram, gsl::Matrix penalty) {
  const std::size_t n = gram->size1;
  gsl::check(gsl_linalg_cholesky_decomp1(gram.get()), "the readings do not determine it");
  gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1.0, gram.get(), penalty.get());
  gsl_blas_dtrsm(CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1.0, gram.get(), penalty.get());
  gsl::Vector values = gsl::vector(n);
  gsl::Matrix columns = gsl::matrix(n, n);
  gsl_eigen_symmv_workspace* work = gsl::allocated(gsl_eigen_symmv_alloc(n));
  const int code = gsl_eigen_symmv(penalty.get(), values.get(), columns.get(), work);
  gsl_eigen_symmv_free(work);
  gsl::check(code, "eigenvalues");
  gsl_blas_dtrsm(CblasLeft, CblasLower, CblasTrans, CblasNonUnit, 1.0, gram.get(), columns.get());
  Modes modes{std::move(columns), std::vector<double>(n)};
  for (std::size_t k = 0; k < n; ++k) modes.roughness[k] = std::max(0.0, gsl_vector_get(values.get(), k));
  return modes;
}

std::vector<double> Modes::amplitudes(std::span<const double> right) const {
  std::vector<double> result(right.size(), 0.0);
  for (std::size_t i = 0; i < right.size(); ++i)
    for (std::size_t k = 0; k < right.size(); ++k) result[k] += column(i, k) * right[i];
  return result;
}

std::vector<double> Modes::sum(std::span<const double> amplitudes, double scale) const {
  std::vector<double> result(amplitudes.size(), 0.0);
  for (std::size_t i = 0; i < amplitudes.size(); ++i)
    for (std::size_t k = 0; k < amplitudes.size(); ++k) result[i] += scale * column(i, k) * amplitudes[k];
  return result;
}

double Scores::degrees_of_freedom(double lambda) const {
  double sum = 0.0;
  for (const double s : roughness) sum += 1.0 / (1.0 + lambda * s);
  return sum;
}

double Scores::minus_log_likelihood(double lambda) const {  // (G.31)
  double sum = residual, logs = 0.0;
  for (std::size_t k = 0; k < roughness.size(); ++k) {
    if (roughness[k] <= smoothest) continue;
    const double lost = lambda * roughness[k] / (1.0 + lambda * roughness[k]);
    sum += amplitudes[k] * amplitudes[k] * lost;
    logs += elementary::log(lost);
  }
  return 0.5 * ((count - kParabola) * elementary::log(sum) - logs);
}

Lambdas Scores::likely() const {
  const double roughest = *std::ranges::max_element(roughness);
  // The grid ranges from a fit without smoothing to a fit that is a parabola.
  const double highest = 1e3 * roughest;
  Lambdas result;
  std::vector<double> logs;
  double least = INFINITY;
  for (double lambda = 1e-3 / roughest; lambda < highest; lambda *= kGridRatio) {
    if (degrees_of_freedom(lambda) < kFewestDegrees) break;
    result.values.push_back(lambda);
    logs.push_back(minus_log_likelihood(lambda));
    if (logs.back() < least) {
      least = logs.back();
      result.best = lambda;
    }
  }
  double sum = 0.0;
  for (const double l : logs) result.cumulative.push_back(sum += elementary::exp(least - l));
  for (double& c : result.cumulative) c /= sum;
  return result;
}

double Lambdas::quantile(double probability) const {
  const auto at = std::ranges::lower_bound(cumulative, probability);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(at - cumulative.begin()))];
}

std::vector<double> Posterior::coefficients() const {
  std::vector<double> smoothed = amplitudes;
  for (std::size_t k = 0; k < smoothed.size(); ++k) smoothed[k] /= 1.0 + lambdas.best * modes.roughness[k];
  return modes.sum(smoothed, scale);
}

SplinePoint Posterior::deviation(const SplineBasis& basis) const {
  SplinePoint variance{0.0, 0.0};
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    SplinePoint part{0.0, 0.0};
    for (std::size_t j = 0; j < SplineBasis::kOrder; ++j) {
      part.value += basis.value[j] * modes.column(basis.first + j, k);
      part.slope += basis.slope[j] * modes.column(basis.first + j, k);
    }
    const double left = 1.0 / (1.0 + lambdas.best * modes.roughness[k]);
    variance.value += left * part.value * part.value;
    variance.slope += left * part.slope * part.slope;
  }
  return {noise * scale * std::sqrt(variance.value), noise * scale * std::sqrt(variance.slope)};
}

std::vector<double> Posterior::draw(double lambda, std::span<const double> normals) const {
  std::vector<double> drawn(amplitudes.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const double left = 1.0 / (1.0 + lambda * modes.roughness[k]);
    drawn[k] = left * amplitudes[k] + std::sqrt(left) * noise * normals[k];
  }
  return modes.sum(drawn, scale);
}

}  // namespace gas
