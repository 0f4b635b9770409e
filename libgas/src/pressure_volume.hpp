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
  /// [Pa] p - p_a, as accurate as the knots. Where the volume grows fast it is better than p.
  double overpressure;
  double volume;  // [m3]
  double slope;   // [m3/Pa] dV/dp
  double work;    // [J] int p dV from the first knot (G.19)
  /// Above the last knot, where the curve gives no volume; the volume is then held.
  bool beyond;
};

/// One line of the curve; the first and the last line go on beyond the knots.
struct VolumePiece {
  double overpressure;  // [Pa] at one of its points
  double pressure;      // [Pa] there
  double volume;        // [m3] there
  double slope;         // [m3/Pa]
  double work;          // [J] there
  bool beyond;          // above the last knot
  /// State at which p V is `product` [J].
  PressurePlace place(double product) const;
};

/// Volume of gas that follows its pressure (G.18). `curve` [m3] against p - p_a [Pa] does not fall; the
/// volume is rigid below the first knot.
class PressureVolume {
 public:
  /// `curve` must outlive this object.
  PressureVolume(const Curve& curve, double ambient_pressure) : curve_(curve), ambient_(ambient_pressure) {}
  double smallest() const { return curve_.knots().front().value; }  // [m3]
  /// State at which p V is `product` [J], sum(m_k R_k) T.
  PressurePlace place(double product) const;
  /// Temperature [K] at which U + int p dV of the gas is `energy` [J], by Newton's method. The heat capacity
  /// lies between cv and cp, so each step removes most of the error. `guess` [K] affects the speed only.
  /// Empty outside the temperature range.
  std::optional<double> find_temperature(const Mixture& gas, double energy, double guess) const noexcept;

 private:
  const Curve& curve_;
  double ambient_;
};

/// Share [-] of a change of p V that is work: p V'/(V + p V').
double work_share(const PressurePlace& place);
/// Heat capacity [J/K] of gas at `place` with cv [J/K], including the work on the skin.
double heat_capacity(const PressurePlace& place, double cv, double gas_constant_sum);

/// Text of an error for PressurePlace::beyond.
std::string beyond_text(const Curve& curve);

}  // namespace gas
