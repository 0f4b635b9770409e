// SPDX-License-Identifier: Apache-2.0
// The species that a case knows by name: the built-in ones and those of its own.
#pragma once

#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "gas/species.hpp"

namespace driver {

/// Heat capacities of the species.
enum class Thermodynamics { constant_cp, nasa7 };

class SpeciesCatalogue {
 public:
  /// With Thermodynamics::constant_cp every species has the cp of `reference_temperature` [K].
  SpeciesCatalogue(Thermodynamics law, double reference_temperature)
      : law_(law), reference_(reference_temperature) {}

  /// Adds the tables [[species]] of `gas`. Throws CaseError where they stand.
  void read(TableReader& gas);
  /// Throws std::invalid_argument for an unknown name.
  gas::Species named(const std::string& name) const;

 private:
  void require_new(const TableReader& table, const std::string& name) const;

  Thermodynamics law_;
  double reference_;
  std::vector<gas::Species> own_;
};

}  // namespace driver
