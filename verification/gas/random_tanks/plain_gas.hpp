// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "dual.hpp"
#include "tank.hpp"

/// Thermodynamics and laws of flow of the second route. Energies are counted from 298.15 K for each species:
/// without reactions that changes nothing, and keeps digits. Outside a range cp is that of its end.
namespace random_tanks {

/// a1 to a6 of (G.1), (G.2), times R: cp [J/(kg K)] is a polynomial, h its integral.
using Coefficients = std::array<double, 6>;

struct PlainSpecies {
  double gas_constant = 0.0;            // [J/(kg K)]
  Coefficients lower{}, upper{};        // up to 1000 K, above
  double minimum = 0.0, maximum = 0.0;  // [K]
};

/// Rows of the file at `csv` for gases without a cp of their own. Throws std::runtime_error.
std::vector<PlainSpecies> read_species(const std::vector<Gas>& gases, const std::string& csv);

inline constexpr double kJoint = 1000.0;  // [K]

double polynomial_cp(const Coefficients& a, double t);
/// Enthalpy, with a line instead of the polynomial outside [low, high].
double polynomial_enthalpy(const Coefficients& a, double t, double low, double high);

/// A volume that follows the pressure: place where p V = product, and the work up to there.
template <class Real>
struct PlainPlace {
  Real pressure, overpressure, volume, work;
};

/// Polygon V(p - p_a), (G.18): rigid below the first knot, the last line beyond the last knot.
template <class Real>
PlainPlace<Real> place_on(const Table& volume, double ambient, const Real& product) {
  using std::sqrt;
  const auto &x = volume.x, &v = volume.y;
  if (value_of(product) <= (ambient + x[0]) * v[0]) {
    const Real p = product / v[0];
    return {p, p - ambient, v[0], 0.0};
  }
  std::size_t i = 0;
  double work = 0.0;
  const auto slope = [&](std::size_t k) { return (v[k + 1] - v[k]) / (x[k + 1] - x[k]); };
  while (i + 2 < x.size() && value_of(product) > (ambient + x[i + 1]) * v[i + 1]) {
    work += 0.5 * (v[i + 1] - v[i]) * (2.0 * ambient + x[i] + x[i + 1]);
    ++i;
  }
  const double p = ambient + x[i], s = slope(i), b = v[i] + s * p;
  const Real excess = product - p * v[i], rise = 2.0 * excess / (b + sqrt(b * b + 4.0 * s * excess));
  return {p + rise, x[i] + rise, v[i] + s * rise, work + s * rise * (p + 0.5 * rise)};
}

/// Share of a flow that (G.22) lets through, times sqrt(dp) what dp has it do: here the share alone.
template <class Real>
Real laminar_share_of(const Real& dp, double d) {
  using std::exp;
  using std::log;
  const Real square = dp * dp;
  return exp(0.75 * log(square / (square + d * d)));
}

/// (G.6) per effective area, sonic below (G.5): sqrt(gamma) (2/(gamma + 1))^((gamma + 1)/(2 gamma - 2)).
template <class Real>
Real hole_flow(const Real& p, const Real& dp, const Real& t, const Real& r, const Real& gamma, double d) {
  using std::exp;
  using std::expm1;
  using std::log;
  using std::log1p;
  using std::sqrt;
  if (!(value_of(dp) > 0.0)) return 0.0;
  const double g = value_of(gamma);
  Real flow;
  if (value_of(dp) >= value_of(p) * (1.0 - std::pow(2.0 / (g + 1.0), g / (g - 1.0)))) {
    flow = p * sqrt(gamma / (r * t)) * exp(0.5 * (gamma + 1.0) / (gamma - 1.0) * log(2.0 / (gamma + 1.0)));
  } else {
    const Real log_ratio = log1p(-(dp / p));
    const Real bracket = -exp(2.0 / gamma * log_ratio) * expm1((gamma - 1.0) / gamma * log_ratio);
    flow = p * sqrt(2.0 * gamma / ((gamma - 1.0) * r * t) * bracket);
  }
  return flow * laminar_share_of(dp, d);
}

/// (G.7) per leak area.
template <class Real>
Real screen_flow(const Real& density, const Real& dp, double d) {
  using std::sqrt;
  if (!(value_of(dp) > 0.0)) return 0.0;
  return sqrt(2.0 * density * dp) * laminar_share_of(dp, d);
}

/// A table of an unknown.
template <class Real>
Real table_of(const Table& table, const Real& x) {
  const double at = value_of(x);
  if constexpr (std::is_same_v<Real, double>) {
    return table.at(at);
  } else {
    double slope = 0.0;
    for (std::size_t i = 0; i + 1 < table.x.size(); ++i)
      if (at >= table.x[i] && at < table.x[i + 1])
        slope = (table.y[i + 1] - table.y[i]) / (table.x[i + 1] - table.x[i]);
    return x.mapped(table.at(at), slope);
  }
}

}  // namespace random_tanks
