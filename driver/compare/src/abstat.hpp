// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "base/csv_table.hpp"

namespace driver {

/// Rows of one airbag or control volume of an LS-DYNA `abstat` file (ASCII), in the file's own units.
/// Columns: time, volume, pressure, internal_energy, dm_dt_in, density, dm_dt_out, total_mass, gas_temp,
/// surface_area, reaction. Throws CaseError if a row ends early, a field is not a number, or the file has no
/// row of this volume.
CsvTable read_abstat(const std::filesystem::path& file, int volume_number);

}  // namespace driver
