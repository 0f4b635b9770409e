// SPDX-License-Identifier: Apache-2.0
// Versions of the formats that Gasjet reads and writes. A number rises by one when a file that was valid
// before is valid no longer (docs/versions.md).
#pragma once

namespace driver::formats {

inline constexpr int case_file = 1;  // `scene.format` of a case
inline constexpr int results = 1;    // `# format:` of a table, such as history.csv; `build` of summary.json
inline constexpr int json = 1;       // `format` in the output of --format json

}  // namespace driver::formats
