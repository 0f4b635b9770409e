// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "gas/curve.hpp"
#include "gas/mixture.hpp"

namespace gas {

/// Gas in a volume that follows its pressure.
struct PressurePlace {
  double pressure;  // [Pa]
  double volume;    // [m3]
  double slope;     // [m3/Pa] dV/dp
  double work;      // [J] int p dV from the first knot on, (G.19)
  bool beyond;      // above the last knot, where there is no volume; kept rigid there
};

/// Where p V(p - p_a) is `product` [J], sum(m_k R_k) T. `curve`: the volume [m3] against p - p_a [Pa], not
/// falling; rigid below its first knot. (G.18)
PressurePlace pressure_place(const Curve& curve, double ambient_pressure, double product);

/// Temperature [K] at which U + int p dV of the gas is `energy` [J]. Newton's method: the heat capacity lies
/// between cv and cp, so that each step takes most of the error, `guess` [K] only sets the speed. Empty
/// outside the temperature range.
std::optional<double> find_temperature(const Mixture& gas, const Curve& curve, double ambient_pressure,
                                       double energy, double guess) noexcept;

/// Heat capacity [J/K] of gas at `place` with cv [J/K]: that which the skin takes as work included.
double heat_capacity(const PressurePlace& place, double cv, double gas_constant_sum);

/// What PressurePlace::beyond means.
std::string beyond_text(const Curve& curve);

}  // namespace gas
