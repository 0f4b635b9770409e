// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "gas/error.hpp"
#include "gas/mixture.hpp"
#include "gas/species.hpp"

namespace gas {

/// Thermodynamics of an ideal-gas mixture; immutable. Species are numbered in the order given. Mixture
/// functions take `masses` [kg], one per species, none negative; mass fractions give the properties of 1 kg.
class Thermo {
 public:
  /// Throws std::invalid_argument if `species` is empty or names one twice.
  explicit Thermo(std::vector<Species> species);

  std::size_t size() const { return species_.size(); }  // number of species
  /// Species number k; throws std::out_of_range.
  const Species& species(std::size_t k) const { return species_.at(k); }
  /// Number of the species called `name`; throws std::invalid_argument if the mixture does not have it.
  std::size_t index(std::string_view name) const;
  double minimum_temperature() const { return minimum_temperature_; }  // [K]
  double maximum_temperature() const { return maximum_temperature_; }  // [K]

  /// Specific gas constant of species k [J/(kg K)].
  double gas_constant(std::size_t k) const { return gas_constants_.at(k); }
  /// Heat capacity [J/(kg K)] of species k at T [K]; DomainError outside its range. (G.1)
  double cp(std::size_t k, double temperature) const;
  /// Enthalpy [J/kg] of species k at T [K]; DomainError outside its range. (G.2)
  double enthalpy(std::size_t k, double temperature) const;
  /// Internal energy [J/kg] of species k at T [K], h - R T; DomainError outside its range. (G.4)
  double internal_energy(std::size_t k, double temperature) const;
  /// Entropy at 1 bar [J/(kg K)], (G.3).
  double standard_entropy(std::size_t k, double temperature) const;

  /// Coefficient sums of the amount `masses`.
  Mixture mixture(std::span<const double> masses) const;
  /// The same into an existing object (no checks of `masses`: for loops that own them).
  void mixture(std::span<const double> masses, Mixture& out) const;

  /// Properties per kg of the mixture at T [K]; throws DomainError outside the range, std::invalid_argument
  /// for a bad number of masses, a negative one, or a zero sum.
  double gas_constant(std::span<const double> masses) const;                  // [J/(kg K)]
  double cp(std::span<const double> masses, double temperature) const;        // [J/(kg K)]
  double cv(std::span<const double> masses, double temperature) const;        // [J/(kg K)]
  double gamma(std::span<const double> masses, double temperature) const;     // [-] cp/cv of the mixture
  double enthalpy(std::span<const double> masses, double temperature) const;  // [J/kg]
  double internal_energy(std::span<const double> masses, double temperature) const;  // [J/kg]
  double speed_of_sound(std::span<const double> masses, double temperature) const;   // [m/s]

  /// Entropy at T [K] and p [Pa] > 0, each species at its share X_k p of the pressure:               (G.15)
  ///   s = sum_k Y_k (s_k(T) - R_k ln(X_k p / 1 bar)), s_k of (G.3) [J/(kg K)]
  /// For a gas of constant cp s_k = cp ln(T / 1 K): only differences have a meaning.
  double entropy(std::span<const double> masses, double temperature, double pressure) const;

  /// T [K] of the amount `masses` [kg] that holds the internal energy U [J]; see Mixture::temperature.
  double temperature_from_internal_energy(std::span<const double> masses, double internal_energy,
                                          double guess) const;

  /// Mass fractions [-] per species of this mixture from a composition by mole, scaled to sum 1.
  /// Throws std::invalid_argument for a species that the mixture does not have, one named twice, a fraction
  /// that is negative or not finite, or a sum that differs from 1 by more than 1e-6.
  std::vector<double> mass_fractions_by_mole(std::span<const Component> composition) const;
  /// The same from a composition by mass.
  std::vector<double> mass_fractions_by_mass(std::span<const Component> composition) const;

 private:
  Mixture checked(std::span<const double> masses, double temperature) const;
  void require_in_range(double temperature, double minimum, double maximum) const;
  std::vector<double> fractions(std::span<const Component> composition, bool by_mole) const;

  std::vector<Species> species_;
  std::vector<double> gas_constants_;  // [J/(kg K)]
  std::vector<Mixture::Sums> low_;     // R_k a_jk of 1 kg
  std::vector<Mixture::Sums> high_;
  double minimum_temperature_ = 0.0;
  double maximum_temperature_ = 0.0;
  bool constant_cp_ = true;
};

}  // namespace gas
