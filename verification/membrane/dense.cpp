// SPDX-License-Identifier: Apache-2.0
#include "dense.hpp"

#include <Eigen/Eigenvalues>

namespace scenes {

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace scenes
