// SPDX-License-Identifier: Apache-2.0
#include "many_runs/regression.hpp"

#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <memory>

#include "many_runs/statistics.hpp"

namespace driver {
namespace {

template <auto Free>
struct Freed {
  template <class T>
  void operator()(T* pointer) const {
    Free(pointer);
  }
};
using Matrix = std::unique_ptr<gsl_matrix, Freed<gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, Freed<gsl_vector_free>>;
using Workspace = std::unique_ptr<gsl_multifit_linear_workspace, Freed<gsl_multifit_linear_free>>;

std::vector<ResponseSurface::Term> terms_of(int factors) {
  std::vector<ResponseSurface::Term> terms(1);
  for (int i = 0; i < factors; ++i) terms.push_back({{i}, 0.0, 0.0});
  for (int i = 0; i < factors; ++i)
    for (int j = i; j < factors; ++j) terms.push_back({{i, j}, 0.0, 0.0});
  return terms;
}

double product(const ResponseSurface::Term& term, const std::vector<double>& point) {
  double value = 1.0;
  for (const int factor : term.factors) value *= point[static_cast<std::size_t>(factor)];
  return value;
}

// Limit and coefficient of a given order, by linear least squares.
Convergence at_order(const std::vector<double>& sizes, const std::vector<double>& values, double order) {
  const double n = static_cast<double>(sizes.size());
  double mean_power = 0.0, mean_value = 0.0, square = 0.0, mixed = 0.0;
  std::vector<double> powers;
  for (const double size : sizes) powers.push_back(elementary::pow(size / sizes.front(), order));
  for (std::size_t i = 0; i < sizes.size(); ++i) mean_power += powers[i] / n, mean_value += values[i] / n;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    square += (powers[i] - mean_power) * (powers[i] - mean_power);
    mixed += (powers[i] - mean_power) * (values[i] - mean_value);
  }
  Convergence fit;
  fit.order = order;
  const double slope = mixed / square;
  fit.limit = mean_value - slope * mean_power;
  fit.coefficient = slope / elementary::pow(sizes.front(), order);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    fit.residual = std::max(fit.residual, std::abs(values[i] - fit.limit - slope * powers[i]));
  return fit;
}

double squares(const std::vector<double>& sizes, const std::vector<double>& values, double order) {
  const Convergence fit = at_order(sizes, values, order);
  double sum = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double off = values[i] - fit.limit - fit.coefficient * elementary::pow(sizes[i], order);
    sum += off * off;
  }
  return sum;
}

}  // namespace

double ResponseSurface::at(const std::vector<double>& point) const {
  double sum = 0.0;
  for (const Term& term : terms) sum += term.coefficient * product(term, point);
  return sum;
}

std::optional<ResponseSurface> fit_surface(const std::vector<std::vector<double>>& points,
                                           const std::vector<double>& values) {
  if (points.empty()) return std::nullopt;
  ResponseSurface surface;
  surface.terms = terms_of(static_cast<int>(points.front().size()));
  const std::size_t n = points.size(), p = surface.terms.size();
  if (n < p + 1) return std::nullopt;
  const Matrix design(gsl_matrix_alloc(n, p)), covariance(gsl_matrix_alloc(p, p));
  const Vector y(gsl_vector_alloc(n)), c(gsl_vector_alloc(p));
  for (std::size_t i = 0; i < n; ++i) {
    gsl_vector_set(y.get(), i, values[i]);
    for (std::size_t k = 0; k < p; ++k)
      gsl_matrix_set(design.get(), i, k, product(surface.terms[k], points[i]));
  }
  const Workspace workspace(gsl_multifit_linear_alloc(n, p));
  double chi = 0.0;
  std::size_t rank = 0;
  gsl_multifit_linear_tsvd(design.get(), y.get(), 1e-10, c.get(), covariance.get(), &chi, &rank,
                           workspace.get());
  if (rank < p) return std::nullopt;  // points that cannot tell the terms apart
  for (std::size_t k = 0; k < p; ++k) {
    surface.terms[k].coefficient = gsl_vector_get(c.get(), k);
    surface.terms[k].standard_error = std::sqrt(gsl_matrix_get(covariance.get(), k, k));
  }
  const double mean = statistics(values).mean;
  double total = 0.0;
  for (const double value : values) total += (value - mean) * (value - mean);
  surface.residual_deviation = std::sqrt(chi / static_cast<double>(n - p));
  surface.explained = total > 0.0 ? 1.0 - chi / total : 0.0;
  return surface;
}

std::optional<Convergence> fit_convergence(const std::vector<double>& sizes,
                                           const std::vector<double>& values) {
  constexpr double lowest = 0.1, highest = 8.0;
  constexpr int steps = 400;
  if (sizes.size() < 3) return std::nullopt;
  const auto order_at = [](int i) { return lowest + (highest - lowest) * i / steps; };
  int best = 0;
  for (int i = 1; i <= steps; ++i)
    if (squares(sizes, values, order_at(i)) < squares(sizes, values, order_at(best))) best = i;
  if (best == 0 || best == steps) return std::nullopt;
  // Golden section between the neighbours, to the square root of a double's accuracy.
  double a = order_at(best - 1), b = order_at(best + 1);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (b - a > 1e-8) {
    const double left = b - golden * (b - a), right = a + golden * (b - a);
    (squares(sizes, values, left) < squares(sizes, values, right) ? b : a) =
        squares(sizes, values, left) < squares(sizes, values, right) ? right : left;
  }
  return at_order(sizes, values, 0.5 * (a + b));
}

}  // namespace driver
