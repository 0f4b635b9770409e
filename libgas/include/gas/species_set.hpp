// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "gas/species.hpp"

namespace gas {

/// The species of a mixture by name and number, and compositions of them; immutable. Species are numbered
/// from 0 in the order given.
class SpeciesSet {
 public:
  /// Throws std::invalid_argument if `species` is empty or names one twice.
  explicit SpeciesSet(std::vector<Species> species);

  std::size_t size() const { return species_.size(); }  // number of species
  /// Species number k; throws std::out_of_range.
  const Species& species(std::size_t k) const { return species_.at(k); }
  /// Number of the species `name`. Throws std::invalid_argument if the mixture does not have it.
  std::size_t index(std::string_view name) const;

  /// Mass fractions [-] of this mixture, one per species, from a composition by mole, scaled to sum 1. Throws
  /// std::invalid_argument for
  /// - a species that the mixture does not have, or one named twice,
  /// - a fraction that is negative or not finite,
  /// - a sum that differs from 1 by more than 1e-6.
  std::vector<double> mass_fractions_by_mole(std::span<const Component> composition) const;
  /// The same from a composition by mass.
  std::vector<double> mass_fractions_by_mass(std::span<const Component> composition) const;

 private:
  std::vector<double> fractions(std::span<const Component> composition, bool by_mole) const;

  std::vector<Species> species_;
};

}  // namespace gas
