// SPDX-License-Identifier: Apache-2.0
// Which columns of a reference are quantities, and which belong to another column.
#pragma once

#include <string>
#include <vector>

#include "base/named_units.hpp"
#include "compare/compare.hpp"

namespace driver {

/// Quantities to compare: `only`, or all. Throws CaseError for names that the reference does not have and for
/// a name given twice.
std::vector<std::string> names_to_compare(const History& reference, const std::vector<std::string>& only,
                                          const Tolerance& tolerance);

/// True if one of the columns is a band.
bool states_band(const History& reference);

/// Throws CaseError for a band without its column and for one below 0.
void check_bands(const History& reference);

/// What a column of pressures counts from, by its name: a stress from nothing.
PressureZero zero_of(const std::string& name);

}  // namespace driver
