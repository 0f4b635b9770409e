// SPDX-License-Identifier: Apache-2.0
// Readings of a tank test.
#pragma once

#include <string>

#include "base/csv_table.hpp"
#include "commands/command.hpp"

namespace driver::commands {

inline constexpr double standard_atmosphere = 101325.0;  // [Pa]

/// Times [s], pressures [Pa] of the tank and, for the method "dual", of the chamber, absolute. Throws
/// CaseError for a file that read_csv refuses, too few readings, a negative time, a wrong unit, and options
/// of units without effect.
CsvTable read_readings(const IdentifyArguments& arguments);

/// The units of the readings as given; empty if all are SI.
std::string units_text(const IdentifyArguments& arguments);

}  // namespace driver::commands
