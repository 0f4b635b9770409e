// SPDX-License-Identifier: Apache-2.0
// The files of the page, as the build put them into the program.
#pragma once

#include <string_view>

namespace driver {

/// Files of driver/report/src/page and three.js, as they were when this was built; three.js and its controls
/// are empty if the package was not there.
struct PageParts {
  std::string_view html, style, charts, series, scene, main, three, orbit;
};
PageParts page_parts();

}  // namespace driver
