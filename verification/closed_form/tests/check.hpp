// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]

// Tens of operations of relative error 2.2e-16, powers with exponents up to 10: condition number about 10.
inline constexpr double kAlgebra = 1e-14;
// The same through one Newton inversion or a quadrature of some hundred terms.
inline constexpr double kInverted = 1e-13;
// GSL's rk8pd at a relative tolerance of 1e-13 a step, some hundred steps.
inline constexpr double kIntegrated = 1e-11;

inline void expect_relative(double computed, double exact, double tolerance) {
  EXPECT_NEAR(computed, exact, tolerance * std::abs(exact));
}

// Expects std::invalid_argument whose text holds `name`.
inline void expect_refused(const std::function<void()>& call, const std::string& name) {
  try {
    call();
    ADD_FAILURE() << "not refused: " << name;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

using Rate = std::function<std::vector<double>(double t, const std::vector<double>& y)>;

// y(t1) of dy/dt = rate, y(t0) = y, by GSL's embedded Runge-Kutta of order 8.
inline std::vector<double> integrate_ode(const Rate& rate, std::vector<double> y, double t0, double t1) {
  const auto callback = [](double t, const double y_in[], double dydt[], void* data) {
    const auto& [function, size] = *static_cast<std::pair<const Rate*, std::size_t>*>(data);
    const std::vector<double> r = (*function)(t, std::vector<double>(y_in, y_in + size));
    for (std::size_t i = 0; i < size; ++i) dydt[i] = r[i];
    return 0;
  };
  std::pair<const Rate*, std::size_t> data{&rate, y.size()};
  gsl_odeiv2_system system{callback, nullptr, y.size(), &data};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3 * (t1 - t0), 0.0, 1e-13),
      &gsl_odeiv2_driver_free);
  EXPECT_EQ(gsl_odeiv2_driver_apply(driver.get(), &t0, t1, y.data()), 0);
  return y;
}

// Adaptive Gauss-Kronrod quadrature to relative 1e-13.
inline double integrate(const std::function<double(double)>& f, double a, double b) {
  const auto callback = [](double x, void* data) {
    return (*static_cast<const std::function<double(double)>*>(data))(x);
  };
  gsl_function function{callback, const_cast<std::function<double(double)>*>(&f)};
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
      gsl_integration_workspace_alloc(2000), &gsl_integration_workspace_free);
  double result = 0.0;
  double error = 0.0;
  EXPECT_EQ(gsl_integration_qag(&function, a, b, 1e-300, 1e-12, 2000, GSL_INTEG_GAUSS41, workspace.get(),
                                &result, &error),
            0);
  return result;
}

}  // namespace test
