// SPDX-License-Identifier: Apache-2.0
#include "closed_form/stability.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "check.hpp"

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

// Relative change of volume below which drifts are power series: logarithms cancel there.
constexpr double kSmallDelta = 0.15;

// Sum from k = `first` on of coefficient(k) x^k, |coefficient| <= 2^k/k, |x| <= 0.15.
template <class Coefficient>
double sum_of_powers(double x, int first, const Coefficient& coefficient) {
  double sum = 0.0;
  for (int k = first + 40; k-- > first;) sum = sum * x + coefficient(k);
  return sum * std::pow(x, first);
}

double checked_modulus(const Sheet& sheet, const char* name, double length) {
  check::sheet(sheet, true);
  check::positive(name, length);
  return sheet.young_modulus / sheet.density;
}

}  // namespace

CentralDifference central_difference(double omega_dt) {
  check::positive("omega_dt", omega_dt);
  CentralDifference result;
  result.energy_amplitude = 0.25 * omega_dt * omega_dt;
  if (omega_dt <= 2.0) {
    result.frequency_ratio = 2.0 * std::asin(0.5 * omega_dt) / omega_dt;
    return result;
  }
  result.frequency_ratio = std::numbers::pi / omega_dt;
  const double excess = 0.5 * (omega_dt - 2.0) * (omega_dt + 2.0);  // W^2/2 - 2
  result.growth_per_step = 1.0 + excess + std::sqrt(excess * (excess + 2.0));
  return result;
}

double critical_time_step(double angular_frequency) {
  return 2.0 / check::positive("angular_frequency", angular_frequency);
}

double gas_breathing_frequency(const EnclosedGas& bag) {
  check::gas(bag.gas);
  check::positive("pressure", bag.pressure, "volume", bag.volume, "area", bag.area, "area_density",
                  bag.area_density);
  return std::sqrt(bag.gas.heat_capacity_ratio * bag.pressure * bag.area / (bag.volume * bag.area_density));
}

double lagged_pressure_growth(double omega_structure_dt, double omega_gas_dt) {
  check::non_negative("omega_structure_dt", omega_structure_dt, "omega_gas_dt", omega_gas_dt);
  const double half = 1.0 - 0.5 * omega_structure_dt * omega_structure_dt;
  const double product = 1.0 + omega_gas_dt * omega_gas_dt;
  const double discriminant = half * half - product;
  if (discriminant <= 0.0) return std::sqrt(product);
  return std::abs(half) + std::sqrt(discriminant);
}

double euler_volume_work_drift(double heat_capacity_ratio, double delta) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  if (!(delta > -1.0 && (gamma - 1.0) * delta < 1.0))
    check::refuse("delta", delta, "must be > -1 and < 1/(gamma - 1)");
  const double a = gamma - 1.0;
  if (std::abs(delta) > kSmallDelta) return std::log1p(-a * delta) + a * std::log1p(delta);
  return sum_of_powers(delta, 2, [a](int k) { return -(std::pow(a, k) + (k % 2 == 0 ? a : -a)) / k; });
}

double trapezoid_volume_work_drift(double heat_capacity_ratio, double delta) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  if (!(delta > -1.0 && 0.5 * (gamma - 1.0) * delta < 1.0 && 0.5 * (gamma + 1.0) * delta > -1.0))
    check::refuse("delta", delta, "must be > -2/(gamma + 1) and < 2/(gamma - 1)");
  const double a = 0.5 * (gamma - 1.0), b = 1.0 + a;
  if (std::abs(delta) > kSmallDelta)
    return std::log1p(-a * delta) - std::log1p(b * delta) + gamma * std::log1p(delta);
  // The three logarithms cancel to third order. Coefficient k: (-a^k + (-1)^k (b^k - gamma))/k.
  return sum_of_powers(delta, 3, [a](int k) {
    const double rest = std::expm1(k * std::log1p(a)) - 2.0 * a;
    return (-std::pow(a, k) + (k % 2 == 0 ? rest : -rest)) / k;
  });
}

double vent_equalisation_rate(const VentEqualisation& vent) {
  check::gas(vent.gas);
  check::positive("volume", vent.volume, "area", vent.area, "ambient_pressure", vent.ambient_pressure,
                  "temperature", vent.temperature);
  const double density = vent.ambient_pressure / (vent.gas.gas_constant * vent.temperature);
  return vent.gas.heat_capacity_ratio * vent.ambient_pressure * vent.area /
         (vent.volume * std::sqrt(2.0 * density));
}

double vent_eigenvalue(const VentEqualisation& vent, double overpressure) {
  return -vent_equalisation_rate(vent) / std::sqrt(check::positive("overpressure", overpressure));
}

double vent_chatter_amplitude(const VentEqualisation& vent, double time_step) {
  const double root = vent_equalisation_rate(vent) * check::positive("time_step", time_step);
  return root * root;
}

double node_contact_time_step(const Sheet& sheet, double tributary_area, double stiffness) {
  check::sheet(sheet, true);
  check::positive("tributary_area", tributary_area, "stiffness", stiffness);
  return 2.0 * std::sqrt(sheet.density * sheet.thickness * tributary_area / stiffness);
}

double triangle_frequency(const Sheet& sheet, double base, double apex, double height) {
  checked_modulus(sheet, "base", base);
  check::finite("apex", apex);
  check::positive("height", height);
  const double twice_area = base * height;
  const std::array<double, 3> dx{-height / twice_area, height / twice_area, 0.0};  // dN/dx
  const std::array<double, 3> dy{(apex - base) / twice_area, -apex / twice_area, base / twice_area};
  const double nu = sheet.poisson_ratio;
  const double d11 = 1.0 / (1.0 - nu * nu);  // over E
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
  return std::sqrt(3.0 * sheet.young_modulus / sheet.density * largest_eigenvalue(stiffness));
}

double equilateral_triangle_frequency(const Sheet& sheet, double side) {
  const double modulus = checked_modulus(sheet, "side", side);
  return std::sqrt(6.0 * modulus / (1.0 - sheet.poisson_ratio)) / side;
}

double right_triangle_frequency(const Sheet& sheet, double leg) {
  const double modulus = checked_modulus(sheet, "leg", leg);
  const double k = 1.0 / (1.0 - sheet.poisson_ratio);  // over E
  const double g = 0.5 / (1.0 + sheet.poisson_ratio);
  const double sum = k + 2.0 * g;
  return std::sqrt(3.0 * modulus * (sum + std::sqrt(sum * sum - 6.0 * k * g))) / leg;
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
