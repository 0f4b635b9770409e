// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "check.hpp"
#include "closed_form/membrane.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

constexpr std::size_t kTerms = 80;  // |b_2n| falls by 0.3 to 0.4 a term: the tail is below 1e-30

// b_2n b_0^(3n-1), pure numbers: from B^2 (x B'' + 2 B') = -2 with b_0 = 1.
std::vector<double> scaled_coefficients() {
  std::vector<double> b{1.0};
  std::vector<double> square{1.0};  // coefficients of B^2
  for (std::size_t n = 1; n < kTerms; ++n) {
    double sum = n == 1 ? 2.0 : 0.0;
    for (std::size_t k = 1; k < n; ++k) sum += square[n - k] * static_cast<double>(k * (k + 1)) * b[k];
    b.push_back(-sum / static_cast<double>(n * (n + 1)));
    double c = 0.0;
    for (std::size_t k = 0; k <= n; ++k) c += b[k] * b[n - k];
    square.push_back(c);
  }
  return b;
}

// Clamped edge: sum (2n + 1 - nu) beta_n s^n = 0 for s = b_0^-3, by bisection-safeguarded Newton.
double leading_coefficient(const std::vector<double>& beta, double poisson_ratio) {
  double low = 1.0 / 8.0;   // b_0 = 2
  double high = 1.0 / 3.5;  // b_0 = 1.518
  double s = 0.2;
  for (int iteration = 0; iteration < 80; ++iteration) {
    double value = 0.0;
    double slope = 0.0;
    for (std::size_t n = kTerms; n-- > 0;) {
      slope = slope * s + value;
      value = value * s + (2.0 * static_cast<double>(n) + 1.0 - poisson_ratio) * beta[n];
    }
    (value > 0.0 ? low : high) = s;  // the sum falls with s
    double next = s - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - s) <= 1e-16 * s) break;
    s = next;
  }
  return 1.0 / std::cbrt(s);
}

double load(const CircularMembrane& membrane) {
  check::sheet(membrane.sheet, false);
  check::within("poisson_ratio", membrane.sheet.poisson_ratio, 0.0, 0.5);
  check::positive("radius", membrane.radius, "overpressure", membrane.overpressure);
  const double q =
      membrane.overpressure * membrane.radius / (membrane.sheet.young_modulus * membrane.sheet.thickness);
  if (q > 0.1) check::refuse("overpressure", membrane.overpressure, "p a/(E h) must be <= 0.1 (small slope)");
  return q;
}

std::vector<double> coefficients(double poisson_ratio) {
  std::vector<double> b = scaled_coefficients();
  const double b0 = leading_coefficient(b, poisson_ratio);
  double factor = b0;
  for (double& value : b) {
    value *= factor;
    factor /= b0 * b0 * b0;
  }
  return b;
}

double series(const std::vector<double>& b, double x) {
  double sum = 0.0;
  for (std::size_t n = b.size(); n-- > 0;) sum = sum * x + b[n];
  return sum;
}

}  // namespace

HenckyMembrane hencky_membrane(const CircularMembrane& membrane) {
  const double q = load(membrane);
  HenckyMembrane result;
  result.coefficients = coefficients(membrane.sheet.poisson_ratio);
  const std::vector<double>& b = result.coefficients;
  const double a = membrane.radius;
  const double root = std::cbrt(q);
  // w = a q^(1/3) int_x^1 dx/B and V = pi a^3 q^(1/3) int x/B dx, from N w' = -p r/2.
  const auto slope = [&b](double x) { return 1.0 / series(b, x); };
  const auto moment = [&b](double x) { return x / series(b, x); };
  result.centre_deflection = a * root * quadrature::integrate(slope, 0.0, 1.0, 4);
  result.volume = std::numbers::pi * a * a * a * root * quadrature::integrate(moment, 0.0, 1.0, 4);
  const double scale = 0.25 * membrane.sheet.young_modulus * membrane.sheet.thickness * root * root;
  result.centre_resultant = scale * b.front();
  result.edge_resultant = scale * series(b, 1.0);
  return result;
}

double hencky_deflection(const CircularMembrane& membrane, double r) {
  const double q = load(membrane);
  check::within("r", r, 0.0, membrane.radius);
  const std::vector<double> b = coefficients(membrane.sheet.poisson_ratio);
  const double x = (r / membrane.radius) * (r / membrane.radius);
  const auto slope = [&b](double y) { return 1.0 / series(b, y); };
  return membrane.radius * std::cbrt(q) * quadrature::integrate(slope, x, 1.0, 4);
}

}  // namespace closed_form
