// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_gamma.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include "closed_form/jet.hpp"
#include "quadrature.hpp"

// Stream function F with velocity f = F'/phi (round) or F' (plane); g = sqrt f reaches 0 linearly at the
// edge.
namespace closed_form {
namespace {

// Round jet, (F'' - F'/phi)^2 = F F'. With x = phi^(3/2), F = phi^2 K(x)^2 and f = g(x)^2 the equation is
// analytic: dg/dx = -K/3, 2 K^2 + 3 x K K' = g^2, g(0) = 1, K(0) = 1/sqrt 2.
struct Series {
  std::vector<double> g, k;
};

double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
  return sum;
}

Series start_series(std::size_t terms) {
  Series s{{1.0}, {std::sqrt(0.5)}};
  for (std::size_t n = 1; n < terms; ++n) {
    const double order = static_cast<double>(n);
    s.g.push_back(-s.k[n - 1] / (3.0 * order));
    // Coefficient n of K^2 (2 + 3 n/2) = coefficient n of g^2, as x (K^2)' = 2 x K K'.
    s.k.push_back(0.0);
    const double known = product(s.k, s.k, n);
    s.k[n] = (product(s.g, s.g, n) / (2.0 + 1.5 * order) - known) / (2.0 * s.k[0]);
  }
  return s;
}

double horner(const std::vector<double>& c, double x) {
  double sum = 0.0;
  for (std::size_t n = c.size(); n-- > 0;) sum = sum * x + c[n];
  return sum;
}

// Independent variable 1 - g; y = {x, K, int f^2 phi dphi}.
int tollmien_slopes(double t, const double y[], double dydt[], void*) {
  const double g = 1.0 - t;
  const double x = y[0];
  const double k = y[1];
  dydt[0] = 3.0 / k;
  dydt[1] = (g * g - 2.0 * k * k) / (x * k * k);
  dydt[2] = 2.0 / 3.0 * g * g * g * g * std::cbrt(x) * dydt[0];
  return 0;
}

class RoundJetIntegrator {
 public:
  RoundJetIntegrator() {
    const Series s = start_series(40);
    const double x = 0.5;
    t_ = 1.0 - horner(s.g, x);
    // phi = c^2 with c = x^(1/3) makes the start of the momentum integral a polynomial.
    const auto integrand = [&s](double c) { return 2.0 * c * c * c * std::pow(horner(s.g, c * c * c), 4); };
    y_ = {x, horner(s.k, x), quadrature::integrate(integrand, 0.0, std::cbrt(x), 2)};
  }

  // Advances to velocity f = g^2.
  void advance_to(double g) {
    if (gsl_odeiv2_driver_apply(driver_.get(), &t_, 1.0 - g, y_.data()) != 0)
      throw std::runtime_error("closed_form: Tollmien integration failed");
  }

  double phi() const { return std::pow(y_[0], 2.0 / 3.0); }
  double stream_function() const { return phi() * phi() * y_[1] * y_[1]; }
  double momentum() const { return y_[2]; }

 private:
  gsl_odeiv2_system system_{tollmien_slopes, nullptr, 3, nullptr};
  std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_{
      gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, 1e-3, 1e-15, 1e-14),
      &gsl_odeiv2_driver_free};
  double t_ = 0.0;
  std::array<double, 3> y_{};
};

}  // namespace

TollmienConstants tollmien_round() {
  RoundJetIntegrator jet;
  TollmienConstants constants;
  jet.advance_to(std::sqrt(0.5));
  constants.half_velocity = jet.phi();
  jet.advance_to(0.0);
  constants.edge = jet.phi();
  constants.momentum_integral = jet.momentum();
  constants.flux_integral = jet.stream_function();
  constants.decay_constant = std::sqrt(0.5 / constants.momentum_integral);
  return constants;
}

TollmienConstants tollmien_plane() {
  // F''^2 = F F' gives F^(3/2) = 1 - g^3 and dphi = -2 (1 - g^3)^(-1/3) dg: Beta functions.
  TollmienConstants constants;
  constants.edge = 2.0 / 3.0 * gsl_sf_beta(1.0 / 3.0, 2.0 / 3.0);
  constants.momentum_integral = 2.0 / 3.0 * gsl_sf_beta(5.0 / 3.0, 2.0 / 3.0);
  constants.flux_integral = 1.0;
  constants.decay_constant = 1.0 / std::sqrt(constants.momentum_integral);
  // From g = sqrt(1/2) to 1 in u = (1 - g^3)^(2/3) = F: 2 (1 - g^3)^(-1/3) dg = u^(1/2) u^(-1/2) g^-2 du.
  const auto slope = [](double u) { return std::pow(1.0 - std::pow(u, 1.5), -2.0 / 3.0); };
  const auto smooth = [&slope](double w) { return 2.0 * w * slope(w * w); };  // u = w^2: no half powers
  const double end = std::cbrt(1.0 - std::pow(0.5, 1.5));                     // w at f = 1/2
  constants.half_velocity = quadrature::integrate(smooth, 0.0, end, 8);
  return constants;
}

}  // namespace closed_form
