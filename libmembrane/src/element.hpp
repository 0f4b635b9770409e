// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "membrane/material.hpp"

// Pointwise formulas of one triangle, shared by the SIMD kernels and element_response.
namespace membrane {

// Columns of the deformation gradient in the element's frame (M.1): F e_k = sum_a x_a dN_a/dX_k, for one
// coordinate. ab and ac are the current sides from corner a.
template <class T>
T stretch_1(T ab, T gradient_b1) {
  return ab * gradient_b1;
}
template <class T>
T stretch_2(T ab, T ac, T gradient_b2, T gradient_c2) {
  return ab * gradient_b2 + ac * gradient_c2;
}

// Bound of omega^2 of the element at its current strain and stress (M.10):
//   omega^2 <= omega_0^2 (tangent factor) + h A max(0, S_1) lambda_max(G).
// The tangent of the relaxed energy is never above that of the taut one, so the bound holds for both
// compression laws.
template <class T>
T frequency_bound(T material_frequency, T geometric_frequency, T tangent_factor, T stress_1) {
  const T zero(0.0);
  return material_frequency * tangent_factor + geometric_frequency * select(stress_1 > zero, stress_1, zero);
}

}  // namespace membrane
