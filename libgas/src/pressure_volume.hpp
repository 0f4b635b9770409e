// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "gas/curve.hpp"
#include "gas/mixture.hpp"

namespace gas {

/// Gas in a volume that follows its pressure.
struct PressurePlace {
  double pressure;      // [Pa]
  double overpressure;  // [Pa] p - p_a, as good as its knots: where the volume grows fast, better than p is
  double volume;        // [m3]
  double slope;         // [m3/Pa] dV/dp
  double work;          // [J] int p dV from the first knot on, (G.19)
  bool beyond;          // above the last knot, where there is no volume; kept rigid there
};

/// One line of the curve, and on beyond both its ends.
struct VolumePiece {
  double overpressure;  // [Pa] at one of its points
  double pressure;      // [Pa] there
  double volume;        // [m3] there
  double slope;         // [m3/Pa]
  double work;          // [J] there
  bool beyond;          // above the last knot
  /// Where p V is `product` [J].
  PressurePlace place(double product) const;
};

/// The volume of gas that follows its pressure, by `curve`: [m3] against p - p_a [Pa], not falling; rigid
/// below its first knot. (G.18)
class PressureVolume {
 public:
  /// `curve` must outlive this.
  PressureVolume(const Curve& curve, double ambient_pressure) : curve_(curve), ambient_(ambient_pressure) {}
  double smallest() const { return curve_.knots().front().value; }  // [m3]
  /// Where p V is `product` [J], sum(m_k R_k) T.
  PressurePlace place(double product) const;
  /// Temperature [K] at which U + int p dV of the gas is `energy` [J]. Newton's method: the heat capacity
  /// lies between cv and cp, so that each step takes most of the error, `guess` [K] only sets the speed.
  /// Empty outside the temperature range.
  std::optional<double> find_temperature(const Mixture& gas, double energy, double guess) const noexcept;

 private:
  const Curve& curve_;
  double ambient_;
};

/// Share [-] of a change of p V that is work: p V'/(V + p V').
double work_share(const PressurePlace& place);
/// Heat capacity [J/K] of gas at `place` with cv [J/K]: that which the skin takes as work included.
double heat_capacity(const PressurePlace& place, double cv, double gas_constant_sum);

/// What PressurePlace::beyond means.
std::string beyond_text(const Curve& curve);

}  // namespace gas
