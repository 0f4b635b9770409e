// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "base/csv_table.hpp"

namespace driver {

/// Histories that LS-DYNA writes as text, besides abstat.
enum class LsDynaText {
  rcforc,  // force on a contact: columns x, y, z, force
  nodout,  // nodes: x_disp ... z_coor, x_rot ... z_racc if there, and the magnitudes disp, vel, accl
  rbdout   // rigid bodies: x, y, z, x_disp ... z_accl, x_rot ... z_racc, and those magnitudes
};

/// The history of one contact, node or rigid body, by its number; by default the only one in the file. A
/// contact has two sides with opposite forces; the first one is used. Magnitudes are of translations. Throws
/// CaseError with file and line.
CsvTable read_lsdyna_text(const std::filesystem::path& file, LsDynaText kind, std::optional<int> number);

}  // namespace driver
