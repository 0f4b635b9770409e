// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <unordered_map>

#include "compare/compare.hpp"

namespace driver {

/// Filtered accelerations that the reference has and mine, a run, lacks; computed from its components.
struct Filtered {
  History columns;
  std::unordered_map<std::string, std::string> too_coarse;  // column, and why the rows of mine are too coarse
                                                            // for it
};
Filtered filtered_as(const History& reference, const History& mine);

}  // namespace driver
