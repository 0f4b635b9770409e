// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_zeta.h>

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/membrane.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

double squared_sine(int half_waves, int divisions) {
  const double s = std::sin(half_waves * pi / (2.0 * divisions));
  return s * s;
}

}  // namespace

double transverse_wave_speed(const TensionedMembrane& membrane) {
  check::positive("tension", membrane.tension, "area_density", membrane.area_density);
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
  check::positive("a", a, "b", b);
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

StripPress pressed_strips(const PressedStrips& strips, double pressure) {
  check::positive("tension", strips.tension, "half_width", strips.half_width, "approach", strips.approach,
                  "stiffness", strips.stiffness, "pressure", pressure);
  const double layer = std::sqrt(0.5 * strips.tension / strips.stiffness);
  const double apart = std::sqrt(layer * layer + 2.0 * strips.tension * strips.approach / pressure) - layer;
  const double contact = strips.half_width - apart;
  check::within("pressure", contact / layer, 6.0, 1e300);
  return {contact, 2.0 * pressure * (contact - layer), pressure / strips.stiffness};
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
  check::positive("tension", tension, "radius", radius);
  return check::finite("overpressure", overpressure) * radius * radius / (4.0 * tension);
}

DentState membrane_dent(const MembraneDent& dent, double patch_radius) {
  check::positive("tension", dent.tension, "membrane_radius", dent.membrane_radius, "sphere_radius",
                  dent.sphere_radius);
  if (dent.sphere_radius < dent.membrane_radius)
    check::refuse("sphere_radius", dent.sphere_radius, "must be at least the radius of the membrane");
  check::from_below("patch_radius", patch_radius, 0.0, dent.membrane_radius);
  if (patch_radius == 0.0) return {};
  const double log = std::log(dent.membrane_radius / patch_radius);
  const double square = patch_radius * patch_radius / dent.sphere_radius;
  return {square * (0.5 + log), 2.0 * pi * dent.tension * square,
          pi * dent.tension * square * square * (log + 0.25)};
}

MembraneRebound membrane_rebound(const MembraneDent& dent, double mass, double speed) {
  check::positive("mass", mass, "speed", speed);
  const double energy = 0.5 * mass * speed * speed;
  double low = 0.0, high = dent.membrane_radius * (1.0 - 1e-9);
  if (membrane_dent(dent, high).energy <= energy)
    check::refuse("speed", speed, "must leave the patch smaller than the membrane");
  // The energy grows with the patch: bisection to the last bit.
  for (double mid = 0.5 * high; mid > low && mid < high; mid = 0.5 * (low + high))
    (membrane_dent(dent, mid).energy < energy ? low : high) = mid;
  // dt = d(depth)/v with a = a_max (1 - u^2), which takes the root of v at the turn.
  const auto rate = [&](double u) {
    const double a = high * (1.0 - u * u);
    const double left = speed * speed - 2.0 * membrane_dent(dent, a).energy / mass;
    const double slope = 2.0 * a / dent.sphere_radius * std::log(dent.membrane_radius / a);
    return slope * 2.0 * high * u / std::sqrt(left);
  };
  return {high, membrane_dent(dent, high), 2.0 * quadrature::integrate(rate, 0.0, 1.0, 64)};
}

}  // namespace closed_form
