// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_zeta.h>

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/membrane.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

double squared_sine(int half_waves, int divisions) {
  const double s = std::sin(half_waves * pi / (2.0 * divisions));
  return s * s;
}

}  // namespace

double transverse_wave_speed(const TensionedMembrane& membrane) {
  check::positive("tension", membrane.tension);
  check::positive("area_density", membrane.area_density);
  return std::sqrt(membrane.tension / membrane.area_density);
}

double drum_frequency(const TensionedMembrane& membrane, double radius, int diameters, int order) {
  check::positive("radius", radius);
  check::integer_within("diameters", diameters, 0, 20);
  check::integer_within("order", order, 1, 20);
  const double zero = gsl_sf_bessel_zero_Jnu(diameters, static_cast<unsigned>(order));
  return transverse_wave_speed(membrane) * zero / (2.0 * pi * radius);
}

double rectangle_frequency(const TensionedMembrane& membrane, double a, double b, int m, int n) {
  check::positive("a", a);
  check::positive("b", b);
  check::integer_within("m", m, 1, 1000);
  check::integer_within("n", n, 1, 1000);
  return 0.5 * transverse_wave_speed(membrane) * std::hypot(m / a, n / b);
}

double lattice_square_frequency(const TensionedMembrane& membrane, double side, int divisions, int m, int n) {
  check::positive("side", side);
  check::integer_within("divisions", divisions, 2, 100000);
  check::integer_within("m", m, 1, divisions - 1);
  check::integer_within("n", n, 1, divisions - 1);
  const double h = side / divisions;
  return transverse_wave_speed(membrane) / (pi * h) *
         std::sqrt(squared_sine(m, divisions) + squared_sine(n, divisions));
}

SquareDeflection square_deflection() {
  SquareDeflection sum;
  double centre = 0.0;
  double complement =
      0.0;  // sum (1 - tanh(k pi/2))/k^5 over odd k: exponential, unlike the sum of tanh itself
  for (int k = 1; k < 40; k += 2) {
    const double k3 = static_cast<double>(k) * k * k;
    centre += (k % 4 == 1 ? 1.0 : -1.0) / (k3 * std::cosh(0.5 * k * pi));
    complement += 2.0 / ((std::exp(k * pi) + 1.0) * k3 * k * k);
  }
  sum.centre_coefficient = 0.125 - 4.0 / (pi * pi * pi) * centre;
  const double odd_zeta = 31.0 / 32.0 * gsl_sf_zeta_int(5);
  sum.volume_coefficient = 1.0 / 12.0 - 16.0 / std::pow(pi, 5) * (odd_zeta - complement);
  return sum;
}

SquareDeflection lattice_square_deflection(int divisions) {
  check::integer_within("divisions", divisions, 2, 4096);
  if (divisions % 2 != 0) check::refuse("divisions", divisions, "must be even, to have a centre node");
  const double N = divisions;
  SquareDeflection sum;
  for (int m = 1; m < divisions; m += 2)
    for (int n = 1; n < divisions; n += 2) {
      const double load = 1.0 / (std::tan(m * pi / (2.0 * N)) * std::tan(n * pi / (2.0 * N)));
      const double eigenvalue = 4.0 * N * N * (squared_sine(m, divisions) + squared_sine(n, divisions));
      const double amplitude = 4.0 / (N * N) * load / eigenvalue;
      sum.centre_coefficient += ((m + n) / 2 % 2 == 0 ? -1.0 : 1.0) * amplitude;
      sum.volume_coefficient += amplitude * load / (N * N);
    }
  return sum;
}

double circle_deflection(double tension, double radius, double overpressure) {
  check::positive("tension", tension);
  check::positive("radius", radius);
  return check::finite("overpressure", overpressure) * radius * radius / (4.0 * tension);
}

}  // namespace closed_form
