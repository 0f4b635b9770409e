// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "eigenvalues.hpp"
#include "scenes.hpp"

// The true greatest omega^2 of a small bag: dense eigenvalue of M^-1/2 K M^-1/2 with K the numerical
// derivative of a force.
namespace scenes {

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
    mobility[i] = std::sqrt(model.inverse_mass.map()(i % 3, i / 3));
  }
  const Eigen::MatrixXd scaled = mobility.asDiagonal() * (0.5 * (k + k.transpose())) * mobility.asDiagonal();
  return dense::largest_eigenvalue(scaled);
}

inline Eigen::Matrix3Xd membrane_force(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  return evaluated(model, x).membrane_force.map();
}

// A generated bag of the paper's fabric, held at its attachment; it carries compression, so that no state is
// slack.
inline membrane::BagDescription describe_shipped(const mesh::Mesh& mesh,
                                                 const std::vector<std::string>& null_panels) {
  auto d = describe(mesh, membrane::Compression::linear);
  for (const auto& panel : null_panels)
    for (const int e : mesh::panel_elements(mesh, panel))
      d.properties[static_cast<std::size_t>(e)] = {.null_panel = true};
  d.fixed_nodes = mesh::panel_nodes(mesh, "attachment");
  return d;
}

// Rayleigh quotient of M^-1/2 K M^-1/2 after some power steps, K by differences of the fabric's force: below
// the greatest omega^2, and some percent off it at most.
inline double power_estimate(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  const Eigen::Matrix3Xd mobility = model.inverse_mass.map().cwiseSqrt();
  auto state = membrane::make_state(model, x);
  const auto force = [&](const Eigen::Matrix3Xd& at) -> Eigen::Matrix3Xd {
    state.position.map() = at;
    membrane::membrane_forces(model, state);
    return state.membrane_force.map();
  };
  const double h = 1e-7;
  Eigen::Matrix3Xd u = Random(5).vectors(x.cols()), image;
  double quotient = 0.0;
  for (int i = 0; i < 400; ++i) {
    u /= u.norm();
    const Eigen::Matrix3Xd v = h * u.cwiseProduct(mobility);
    image = (force(x - v) - force(x + v)) / (2.0 * h);
    image = image.cwiseProduct(mobility);
    quotient = u.cwiseProduct(image).sum();
    u = image;
  }
  return quotient;
}

}  // namespace scenes
