// SPDX-License-Identifier: Apache-2.0
#include "gas/species_set.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "require.hpp"

namespace gas {

SpeciesSet::SpeciesSet(std::vector<Species> species) : species_(std::move(species)) {
  if (species_.empty()) throw std::invalid_argument("species: at least one is needed");
  for (std::size_t k = 0; k < species_.size(); ++k)
    if (index(species_[k].name) != k)
      throw std::invalid_argument("species = \"" + species_[k].name + "\": named twice");
}

std::size_t SpeciesSet::index(std::string_view name) const {
  const auto found = std::ranges::find(species_, name, &Species::name);
  if (found != species_.end()) return static_cast<std::size_t>(found - species_.begin());
  throw std::invalid_argument("species = \"" + std::string(name) + "\": not in the mixture");
}

std::vector<double> SpeciesSet::fractions(std::span<const Component> composition, bool by_mole) const {
  std::vector<double> masses(size(), 0.0);
  std::vector<bool> named(size(), false);
  double sum = 0.0, total_mass = 0.0;
  for (const auto& [name, fraction] : composition) {
    const std::size_t k = index(name);
    if (named[k]) throw std::invalid_argument("species = \"" + name + "\": named twice in a composition");
    require(std::isfinite(fraction) && fraction >= 0.0, "fraction of " + name, fraction, "must be 0 to 1");
    named[k] = true;
    masses[k] = by_mole ? fraction * species_[k].molar_mass : fraction;
    sum += fraction;
    total_mass += masses[k];
  }
  require(std::abs(sum - 1.0) <= 1e-6, "sum of fractions", sum, "must be 1");
  for (double& m : masses) m /= total_mass;
  return masses;
}

std::vector<double> SpeciesSet::mass_fractions_by_mole(std::span<const Component> composition) const {
  return fractions(composition, true);
}

std::vector<double> SpeciesSet::mass_fractions_by_mass(std::span<const Component> composition) const {
  return fractions(composition, false);
}

}  // namespace gas
