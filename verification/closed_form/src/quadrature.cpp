// SPDX-License-Identifier: Apache-2.0
#include "quadrature.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <cstddef>
#include <memory>

namespace closed_form::quadrature {
namespace {

using Table = std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)>;

const gsl_integration_glfixed_table& rule() {
  static const Table table(gsl_integration_glfixed_table_alloc(20), &gsl_integration_glfixed_table_free);
  return *table;
}

double panel(const std::function<double(double)>& f, double a, double b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rule().n; ++i) {
    double x = 0.0;
    double w = 0.0;
    gsl_integration_glfixed_point(a, b, i, &x, &w, &rule());
    sum += w * f(x);
  }
  return sum;
}

}  // namespace

double integrate(const std::function<double(double)>& f, double a, double b, int panels) {
  const double width = (b - a) / panels;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) sum += panel(f, a + i * width, i + 1 == panels ? b : a + (i + 1) * width);
  return sum;
}

double power_integral(double exponent, double v) {
  // x = sinh s: the integrand cosh(s)^(2b+1) is analytic for |Im s| < pi/2, so panels of 1/2 reach round-off.
  // By log1p, as b may be large.
  const double end = std::asinh(v);
  const int panels = 1 + static_cast<int>(2.0 * end);
  const auto integrand = [power = exponent + 0.5](double s) {
    return std::exp(power * std::log1p(std::sinh(s) * std::sinh(s)));
  };
  return integrate(integrand, 0.0, end, panels);
}

double power_integral_inverse(double exponent, double value, double v_max) {
  if (value <= 0.0) return 0.0;
  double low = 0.0;
  double high = v_max;
  double v = v_max;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double excess = power_integral(exponent, v) - value;
    (excess > 0.0 ? high : low) = v;
    double next = v - excess * std::exp(-exponent * std::log1p(v * v));
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - v) <= 2e-16 * v) return next;
    v = next;
  }
  return v;
}

}  // namespace closed_form::quadrature
