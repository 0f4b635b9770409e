// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "scenes.hpp"

namespace scenes {

// Checks every component of a force at x against the derivative of its energy, by steps of 1e-6 m.
template <class Energy>
void expect_eq_minus_derivative(const Eigen::Matrix3Xd& force, const Eigen::Matrix3Xd& x,
                                const Energy& energy, double tolerance) {
  const double h = 1e-6;
  for (Eigen::Index n = 0; n < x.cols(); ++n)
    for (int c = 0; c < 3; ++c) {
      Eigen::Matrix3Xd right = x, left = x;
      right(c, n) += h;
      left(c, n) -= h;
      const double slope = (energy(right) - energy(left)) / (2.0 * h);
      EXPECT_NEAR(force(c, n), -slope, tolerance);
    }
}

// The fabric's force at x (M.4).
inline void expect_force_eq_minus_energy_derivative(const membrane::BagModel& model,
                                                    const Eigen::Matrix3Xd& x) {
  const Eigen::Matrix3Xd force = evaluated(model, x).membrane_force.map();
  // Rounding eps W / h with W < 500 J is 1e-7 N; curvature jumps at wrinkle borders and third derivatives
  // E h / side give at most 3e4 N/m x h; forces are some 1000 N.
  expect_eq_minus_derivative(
      force, x, [&](const Eigen::Matrix3Xd& at) { return evaluated(model, at).forces.strain_energy; },
      1e-5 * force.cwiseAbs().maxCoeff() + 1e-6);
}

// Forces, energy and step bound at x have the same bits by every instruction set.
inline void expect_same_bits(membrane::BagDescription d, const Eigen::Matrix3Xd& x) {
  d.isa = membrane::Isa::scalar;
  const auto scalar = evaluated(make_model(d), x);
  for (const auto isa : {membrane::Isa::baseline, membrane::best_isa()}) {
    d.isa = isa;
    const auto lanes = evaluated(make_model(d), x);
    const Eigen::Matrix3Xd a = scalar.membrane_force.map(), b = lanes.membrane_force.map();
    EXPECT_EQ(std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)), 0);
    EXPECT_EQ(scalar.forces.strain_energy, lanes.forces.strain_energy);
    EXPECT_EQ(scalar.forces.element_frequency, lanes.forces.element_frequency);
  }
}

}  // namespace scenes
