// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace closed_form::quadrature {

/// Composite 20-point Gauss-Legendre rule on equal panels. Exact to round-off if the integrand is analytic
/// well beyond a panel.
double integrate(const std::function<double(double)>& f, double a, double b, int panels);

/// I_b(v) = int_0^v (1 + x^2)^b dx, v >= 0: the integral behind every tank that equalises (2F1 in closed
/// form).
double power_integral(double exponent, double v);

/// Root v in [0, v_max] of I_b(v) = value, by safeguarded Newton; value is clamped to [0, I_b(v_max)].
double power_integral_inverse(double exponent, double value, double v_max);

}  // namespace closed_form::quadrature
