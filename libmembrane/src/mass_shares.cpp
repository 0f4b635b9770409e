// SPDX-License-Identifier: Apache-2.0
#include "mass_shares.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "blocks.hpp"

namespace membrane {

namespace {

// Shares of one element and the stress pattern that excites it most, found along with them.
struct Share {
  Eigen::Vector3d mass;  // of the corners [kg]
  Eigen::Vector3d pattern = Eigen::Vector3d(1.0, 0.7, 0.3).normalized();
};

// Strain of a displacement of the corner with gradient g, and its transpose.
Eigen::Matrix<double, 3, 2> strain_operator(const Eigen::Vector2d& g) {
  Eigen::Matrix<double, 3, 2> b;
  b << g[0], 0.0, 0.0, g[1], g[1], g[0];
  return b;
}

// L^T B M^-1 B^T L: its greatest eigenvalue times the volume is omega^2.
Eigen::Matrix3d scaled_stiffness(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int a = 0; a < 3; ++a) {
    const Eigen::Matrix<double, 3, 2> b = e.factor.transpose() * strain_operator(e.gradient.col(a));
    sum += b * b.transpose() / mass[a];
  }
  return sum;
}

double material_frequency(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  return e.volume *
         Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled_stiffness(e, mass), Eigen::EigenvaluesOnly)
             .eigenvalues()[2];
}

// omega^2 per principal stress: larger eigenvalue of a 2 x 2 matrix.
double geometric_frequency(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  const Eigen::Matrix2d g = e.gradient * mass.cwiseInverse().asDiagonal() * e.gradient.transpose();
  return e.volume * (0.5 * (g(0, 0) + g(1, 1)) + std::hypot(0.5 * (g(0, 0) - g(1, 1)), g(0, 1)));
}

// One power step towards the greatest eigenvalue; each corner then asks for more of its node's mass the more
// the element exceeds others there, and the more of its energy is at that corner.
void update_share(const ElementStiffness& e, Share& share) {
  constexpr double corner_exponent = 0.05, floor = 1.0 / 6.0;  // by trial on the shipped bags
  Eigen::Vector3d part, next = Eigen::Vector3d::Zero();
  for (int a = 0; a < 3; ++a) {
    const Eigen::Matrix<double, 3, 2> b = strain_operator(e.gradient.col(a));
    const Eigen::Vector2d push = b.transpose() * (e.factor * share.pattern);
    part[a] = e.volume * push.squaredNorm() / share.mass[a];
    next += e.factor.transpose() * (b * push) / share.mass[a];
  }
  share.pattern = next.normalized();
  const double frequency = part.sum();
  for (int a = 0; a < 3; ++a) {
    const double demand = share.mass[a] * frequency;
    share.mass[a] = demand * std::pow((part[a] + floor * frequency) / demand, corner_exponent);
  }
}

// Scales the shares of each node to its mass.
void normalise(const BagModel& m, const std::vector<ElementStiffness>& fabric, std::vector<Share>& shares) {
  std::vector<double> sum(m.node_mass.size(), 0.0);
  const auto node = [&](std::size_t i, int a) {
    return static_cast<std::size_t>(m.description.elements(a, fabric[i].element));
  };
  for (std::size_t i = 0; i < fabric.size(); ++i)
    for (int a = 0; a < 3; ++a) sum[node(i, a)] += shares[i].mass[a];
  for (std::size_t i = 0; i < fabric.size(); ++i)
    for (int a = 0; a < 3; ++a) shares[i].mass[a] *= m.node_mass[node(i, a)] / sum[node(i, a)];
}

}  // namespace

void set_frequencies(BagModel& m, const std::vector<ElementStiffness>& fabric) {
  constexpr int rounds = 20;  // the step gains less than 1 % from more
  std::vector<Share> shares(fabric.size());
  for (std::size_t i = 0; i < fabric.size(); ++i) shares[i].mass.setConstant(fabric[i].mass / 3.0);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < fabric.size(); ++i) update_share(fabric[i], shares[i]);
    normalise(m, fabric, shares);
  }
  for (std::size_t i = 0; i < fabric.size(); ++i) {
    const auto [group, lane] = place_of(m.elements, static_cast<std::size_t>(fabric[i].element));
    m.elements.group[group].material_frequency[lane] = material_frequency(fabric[i], shares[i].mass);
    m.elements.group[group].geometric_frequency[lane] = geometric_frequency(fabric[i], shares[i].mass);
    m.fabric_frequency = std::max(m.fabric_frequency, m.elements.group[group].material_frequency[lane]);
  }
}

}  // namespace membrane
