// SPDX-License-Identifier: Apache-2.0
// The files of the page that the build put into the program.
#pragma once

#include <string_view>

namespace driver {

/// Files of driver/report/src/page and three.js at the time of the build; three.js and its controls are empty
/// if the package was missing.
struct PageParts {
  std::string_view html, style, charts, series, scene, main, three, orbit;
};
PageParts page_parts();

}  // namespace driver
