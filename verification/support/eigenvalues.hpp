// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

// Eigenvalues by GSL: Eigen's own solvers take half a minute to compile.
namespace dense {

// Greatest eigenvalue of a symmetric matrix; its lower half is read.
double largest_eigenvalue(const Eigen::MatrixXd& symmetric);

// Largest magnitude of the eigenvalues of any square matrix.
double spectral_radius(const Eigen::MatrixXd& matrix);

}  // namespace dense
