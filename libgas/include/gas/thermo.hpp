// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "gas/error.hpp"
#include "gas/mixture.hpp"
#include "gas/species_set.hpp"

namespace gas {

/// Thermodynamics of an ideal-gas mixture of some species; immutable. Functions of the mixture take `masses`
/// [kg]: one per species, none negative. Mass fractions give the properties of 1 kg.
class Thermo : public SpeciesSet {
 public:
  /// Throws std::invalid_argument if `species` is empty or names one twice.
  explicit Thermo(std::vector<Species> species);

  double minimum_temperature() const { return none_.minimum_temperature; }  // [K]
  double maximum_temperature() const { return none_.maximum_temperature; }  // [K]

  /// Specific gas constant of species k [J/(kg K)].
  double gas_constant(std::size_t k) const { return gas_constants_.at(k); }
  /// Heat capacity [J/(kg K)] of species k at T [K]; DomainError outside its range. (G.1)
  double cp(std::size_t k, double temperature) const;
  /// Enthalpy [J/kg] of species k at T [K]; DomainError outside its range. (G.2)
  double enthalpy(std::size_t k, double temperature) const;
  /// Internal energy [J/kg] of species k at T [K], h - R T; DomainError outside its range. (G.4)
  double internal_energy(std::size_t k, double temperature) const;
  /// Entropy at 1 bar [J/(kg K)] of species k at T [K]; DomainError outside its range. (G.3)
  double standard_entropy(std::size_t k, double temperature) const;

  /// Coefficient sums of the amount `masses`. Throws std::invalid_argument for a bad number of masses.
  Mixture mixture(std::span<const double> masses) const;
  /// The same into an existing object, without checks: for loops that own `masses`.
  void mixture(std::span<const double> masses, Mixture& out) const;

  /// Properties per kg of the mixture at T [K]. Throw DomainError outside the temperature range, and
  /// std::invalid_argument for a bad number of masses, a negative mass or a zero sum.
  double gas_constant(std::span<const double> masses) const;                  // [J/(kg K)]
  double cp(std::span<const double> masses, double temperature) const;        // [J/(kg K)]
  double cv(std::span<const double> masses, double temperature) const;        // [J/(kg K)]
  double gamma(std::span<const double> masses, double temperature) const;     // [-] cp/cv of the mixture
  double enthalpy(std::span<const double> masses, double temperature) const;  // [J/kg]
  double internal_energy(std::span<const double> masses, double temperature) const;  // [J/kg]
  double speed_of_sound(std::span<const double> masses, double temperature) const;   // [m/s]

  /// Entropy [J/(kg K)] at T [K] and p [Pa] > 0, each species at its partial pressure X_k p:           (G.15)
  ///   s = sum_k Y_k (s_k(T) - R_k ln(X_k p / 1 bar)), s_k of (G.3)
  /// For a gas of constant cp, s_k = cp ln(T / 1 K): only differences have a meaning.
  double entropy(std::span<const double> masses, double temperature, double pressure) const;

  /// Temperature [K] of the amount `masses` [kg] with internal energy U [J]; see Mixture::temperature.
  double temperature_from_internal_energy(std::span<const double> masses, double internal_energy,
                                          double guess) const;

 private:
  Mixture checked(std::span<const double> masses, double temperature) const;

  std::vector<double> gas_constants_;  // [J/(kg K)]
  std::vector<Mixture::Sums> low_;     // R_k a_jk of 1 kg
  std::vector<Mixture::Sums> high_;
  Mixture none_;  // of no mass; holds the range of temperature, and whether cp is constant
};

}  // namespace gas
