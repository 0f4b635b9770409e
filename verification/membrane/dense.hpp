// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "scenes.hpp"

// The true greatest omega^2 of a small bag: dense eigenvalue of M^-1/2 K M^-1/2 with K the numerical
// derivative of a force.
namespace scenes {

// Largest eigenvalue of a symmetric matrix; in a file of its own, since Eigen's solver is slow to compile.
double largest_eigenvalue(const Eigen::MatrixXd& symmetric);

// `force` maps positions to nodal forces (3 x nodes). Central differences with step h.
template <class Force>
double greatest_frequency(const membrane::BagModel& model, const Eigen::Matrix3Xd& x, Force&& force,
                          double h = 1e-7) {
  const Eigen::Index size = x.size();
  Eigen::MatrixXd k(size, size);
  Eigen::VectorXd mobility(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    Eigen::Matrix3Xd right = x, left = x;
    right(i % 3, i / 3) += h;
    left(i % 3, i / 3) -= h;
    const Eigen::Matrix3Xd slope = (force(left) - force(right)) / (2.0 * h);
    k.col(i) = slope.reshaped();
    mobility[i] = std::sqrt(model.inverse_mass[static_cast<std::size_t>(i / 3)]);
  }
  const Eigen::MatrixXd scaled = mobility.asDiagonal() * (0.5 * (k + k.transpose())) * mobility.asDiagonal();
  return largest_eigenvalue(scaled);
}

inline Eigen::Matrix3Xd membrane_force(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  return evaluated(model, x).membrane_force.map();
}

}  // namespace scenes
