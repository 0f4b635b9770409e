// SPDX-License-Identifier: Apache-2.0
#include "export/units.hpp"

#include <fmt/format.h>

#include "base/case_reader.hpp"

namespace driver {

Units units_named(std::string_view name) {
  if (name == "kg-m-s") return {"kg-m-s", 1.0, 1.0, 1.0, "kg", "m", "s"};
  if (name == "t-mm-s") return {"t-mm-s", 1e3, 1e-3, 1.0, "Mg", "mm", "s"};
  if (name == "kg-mm-ms") return {"kg-mm-ms", 1.0, 1e-3, 1e-3, "kg", "mm", "ms"};
  throw CaseError(fmt::format("--units {}: is not a unit system, allowed: kg-m-s, t-mm-s, kg-mm-ms", name));
}

}  // namespace driver
