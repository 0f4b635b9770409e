// SPDX-License-Identifier: Apache-2.0
#include "eigenvalues.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_matrix.h>

#include <complex>
#include <memory>

namespace dense {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

gsl_matrix_view view(RowMajor& matrix) {
  return gsl_matrix_view_array(matrix.data(), static_cast<std::size_t>(matrix.rows()),
                               static_cast<std::size_t>(matrix.cols()));
}

}  // namespace

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  RowMajor work = symmetric;
  Eigen::VectorXd values(work.rows());
  const auto size = static_cast<std::size_t>(work.rows());
  gsl_vector_view found = gsl_vector_view_array(values.data(), size);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> workspace(
      gsl_eigen_symm_alloc(size), &gsl_eigen_symm_free);
  gsl_matrix_view a = view(work);
  gsl_eigen_symm(&a.matrix, &found.vector, workspace.get());
  return values.maxCoeff();
}

double spectral_radius(const Eigen::MatrixXd& matrix) {
  RowMajor work = matrix;
  Eigen::VectorXcd values(work.rows());
  const auto size = static_cast<std::size_t>(work.rows());
  gsl_vector_complex_view found =
      gsl_vector_complex_view_array(reinterpret_cast<double*>(values.data()), size);
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> workspace(
      gsl_eigen_nonsymm_alloc(size), &gsl_eigen_nonsymm_free);
  gsl_matrix_view a = view(work);
  gsl_eigen_nonsymm(&a.matrix, &found.vector, workspace.get());
  return values.cwiseAbs().maxCoeff();
}

}  // namespace dense
