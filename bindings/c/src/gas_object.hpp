// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "border.hpp"
#include "gas/thermo.hpp"

/// A mixture that does not change.
struct Gas : border::Object {
  Gas(std::vector<gas::Species> species, const std::vector<gas::Component>& components);
  static constexpr const char* name = "a gas";
  static constexpr bool shared = true;

  gas::Thermo thermo;
  std::vector<double> mass_fractions;
};
