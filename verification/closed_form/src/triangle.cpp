// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "check.hpp"
#include "closed_form/stability.hpp"

namespace closed_form {
namespace {

// Greatest eigenvalue of a symmetric 6 x 6 matrix.
double largest_eigenvalue(std::array<double, 36> matrix) {
  std::array<double, 6> values{};
  gsl_matrix_view a = gsl_matrix_view_array(matrix.data(), 6, 6);
  gsl_vector_view w = gsl_vector_view_array(values.data(), 6);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> workspace(
      gsl_eigen_symm_alloc(6), &gsl_eigen_symm_free);
  gsl_eigen_symm(&a.matrix, &w.vector, workspace.get());
  return gsl_vector_max(&w.vector);
}

double checked_modulus(const Sheet& sheet, const char* name, double length) {
  check::sheet(sheet, true);
  check::positive(name, length);
  return sheet.young_modulus / sheet.density;
}

}  // namespace

double triangle_frequency(const Sheet& sheet, double base, double apex, double height) {
  checked_modulus(sheet, "base", base);
  check::finite("apex", apex);
  check::positive("height", height);
  const double twice_area = base * height;
  const std::array<double, 3> dx{-height / twice_area, height / twice_area, 0.0};  // dN/dx
  const std::array<double, 3> dy{(apex - base) / twice_area, -apex / twice_area, base / twice_area};
  const double nu = sheet.poisson_ratio;
  const double d11 = sheet.young_modulus / (1.0 - nu * nu);
  const double d12 = nu * d11;
  const double d33 = 0.5 * (1.0 - nu) * d11;
  std::array<double, 36> stiffness{};  // B^T D B, unknowns u0 u1 u2 v0 v1 v2
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      stiffness[6 * i + j] = d11 * dx[i] * dx[j] + d33 * dy[i] * dy[j];
      stiffness[6 * (i + 3) + j + 3] = d11 * dy[i] * dy[j] + d33 * dx[i] * dx[j];
      stiffness[6 * i + j + 3] = d12 * dx[i] * dy[j] + d33 * dy[i] * dx[j];
      stiffness[6 * (j + 3) + i] = stiffness[6 * i + j + 3];
    }
  return std::sqrt(3.0 / sheet.density * largest_eigenvalue(stiffness));
}

double equilateral_triangle_frequency(const Sheet& sheet, double side) {
  const double modulus = checked_modulus(sheet, "side", side);
  return std::sqrt(6.0 * modulus / (1.0 - sheet.poisson_ratio)) / side;
}

double right_triangle_frequency(const Sheet& sheet, double leg) {
  const double modulus = checked_modulus(sheet, "leg", leg);
  const double k = modulus / (1.0 - sheet.poisson_ratio);
  const double g = modulus / (2.0 * (1.0 + sheet.poisson_ratio));
  const double sum = k + 2.0 * g;
  return std::sqrt(3.0 * (sum + std::sqrt(sum * sum - 6.0 * k * g))) / leg;
}

double equilateral_mesh_frequency(const Sheet& sheet, double side) {
  const double modulus = checked_modulus(sheet, "side", side);
  const double nu = sheet.poisson_ratio;
  return std::sqrt(16.0 * modulus / (3.0 * (1.0 - nu * nu))) / side;
}

double right_mesh_frequency(const Sheet& sheet, double leg) {
  const double modulus = checked_modulus(sheet, "leg", leg);
  const double nu = sheet.poisson_ratio;
  return std::sqrt(8.0 * modulus / (1.0 - nu * nu)) / leg;
}

}  // namespace closed_form
