// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "gsl_objects.hpp"
#include "tank_test/smoothing_spline.hpp"

namespace gas {

/// Columns z_k with Z^T G Z = 1 and Z^T Omega Z = diag(s). In this basis each lambda is a scalar problem
/// (Demmler and Reinsch, Numer. Math. 24, 1975).
struct Modes {
  gsl::Matrix columns;
  std::vector<double> roughness;  // s_k >= 0

  double column(std::size_t i, std::size_t k) const { return gsl_matrix_get(columns.get(), i, k); }
  /// Amplitudes Z^T right of the modes, for a right side of the normal equations.
  std::vector<double> amplitudes(std::span<const double> right) const;
  /// Coefficients of the spline, scale Z amplitudes.
  std::vector<double> sum(std::span<const double> amplitudes, double scale) const;
};
/// Throws DomainError if G, the readings' Gram matrix, is not positive definite.
Modes make_modes(gsl::Matrix gram, gsl::Matrix penalty);

/// Posterior of lambda on a grid, given the readings.
struct Lambdas {
  double best = 0.0;               // [-] most likely value
  std::vector<double> values;      // [-] grid, rising
  std::vector<double> cumulative;  // [-] posterior probability up to each value
  /// Quantile of lambda at `probability`, 0 to 1.
  double quantile(double probability) const;
};

/// Data for (G.31): amplitudes of the modes in the readings, and the residual that no lambda removes.
struct Scores {
  std::span<const double> roughness;
  std::vector<double> amplitudes;
  double residual;  // weighted sum of squares of the fit with lambda = 0
  double count;     // number of readings
  /// Largest roughness of the three modes that make a parabola; zero but for round-off.
  double smoothest;

  double degrees_of_freedom(double lambda) const;
  double minus_log_likelihood(double lambda) const;
  /// The most likely lambda of a grid of ten values a decade, and the posterior over the grid.
  Lambdas likely() const;
};

/// Posterior of the spline given the readings (G.32), by modes.
struct Posterior {
  Modes modes;
  std::vector<double> amplitudes;  // amplitudes of the modes in the readings
  Lambdas lambdas;
  double scale;               // largest reading
  double degrees_of_freedom;  // [-] trace of the smoother
  double noise = 0.0;         // [-] standard deviation of a reading

  /// Coefficients of the most likely spline.
  std::vector<double> coefficients() const;
  SplinePoint deviation(const SplineBasis& basis) const;
  /// Coefficients of a draw at this lambda; `normals` has one number for each mode.
  std::vector<double> draw(double lambda, std::span<const double> normals) const;
};

}  // namespace gas
