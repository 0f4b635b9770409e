// SPDX-License-Identifier: Apache-2.0
#include "demmler_reinsch.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>

namespace gas {
namespace {

constexpr double kGridRatio = 1.2589254117941673;  // ten values of lambda a decade
constexpr double kFewestDegrees = 3.01;            // of freedom; a parabola, which no lambda smooths, has 3

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

double Scores::residual_sum(double lambda) const {
  double sum = residual;
  for (std::size_t k = 0; k < roughness.size(); ++k) {
    const double lost = amplitudes[k] * lambda * roughness[k] / (1.0 + lambda * roughness[k]);
    sum += lost * lost;
  }
  return sum;
}

double Scores::cross_validation(double lambda) const {  // (G.31)
  const double free = count - degrees_of_freedom(lambda);
  return count * residual_sum(lambda) / (free * free);
}

double Scores::best() const {
  const double roughest = *std::ranges::max_element(roughness);
  // From a fit that smooths no mode to one that leaves nothing but a parabola.
  const double highest = 1e3 * roughest;
  double best = 1e-3 / roughest;
  for (double lambda = best; lambda < highest; lambda *= kGridRatio) {
    if (degrees_of_freedom(lambda) < kFewestDegrees) break;
    if (cross_validation(lambda) < cross_validation(best)) best = lambda;
  }
  return best;
}

}  // namespace gas
