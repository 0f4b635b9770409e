// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>

namespace gas {

/// Coefficient sums of a given amount of mixture. The polynomials (G.1) and (G.2) are linear in the species
/// masses, so every extensive property follows from sum_k m_k R_k a_jk. Its cost does not grow with the
/// number of species. Thermo::mixture builds it. Properties are those of the whole amount; divide by `mass`
/// for specific ones. The lower range holds at T <= 1000 K.
class Mixture {
 public:
  using Sums = std::array<double, 6>;  // [J/K^j], j = 1..5, and [J]

  double mass = 0.0;                 // [kg] sum m_k
  double gas_constant_sum = 0.0;     // [J/K] sum m_k R_k
  Sums low{};                        // sum m_k R_k a_jk, T <= 1000 K
  Sums high{};                       // the same, T > 1000 K
  double minimum_temperature = 0.0;  // [K]
  double maximum_temperature = 0.0;  // [K]
  bool constant_cp = true;           // true if no species' cp depends on T

  /// Heat capacity at constant pressure [J/K], (G.1).
  double cp(double temperature) const;
  /// Derivative d(cp)/dT [J/K2].
  double cp_slope(double temperature) const;
  /// Heat capacity at constant volume [J/K], cp - R.
  double cv(double temperature) const { return cp(temperature) - gas_constant_sum; }
  /// Enthalpy [J], (G.2).
  double enthalpy(double temperature) const;
  /// Internal energy [J], U = H - sum(m_k R_k) T.  (G.4)
  double internal_energy(double temperature) const {
    return enthalpy(temperature) - gas_constant_sum * temperature;
  }

  /// Temperature [K] from the internal energy [J], by Chebyshev's iteration; if that does not converge inside
  /// the range, by a bracketed Newton iteration. `guess` [K] affects the speed only. Where U(T) jumps up at
  /// 1000 K, energies inside the jump give T = 1000 K. Where it jumps down, the lower of the two roots is
  /// taken. Throws DomainError outside the temperature range (constant cp: for T <= 0).
  double temperature(double internal_energy, double guess) const;
  /// The same without an exception: empty where temperature() throws.
  std::optional<double> find_temperature(double internal_energy, double guess) const noexcept;
};

}  // namespace gas
