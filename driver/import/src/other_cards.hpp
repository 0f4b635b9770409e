// SPDX-License-Identifier: Apache-2.0
// Cards that no mapping reads: what that means for the bag.
#pragma once

#include <string_view>

#include "export/feature.hpp"

namespace driver::imported {

struct OtherCard {
  Mapping mapping;
  const char* how;
  bool refused = false;
};

/// By the beginning of the keyword. Unknown keywords are left out as such.
OtherCard other_card(std::string_view keyword, DeckFormat program);

}  // namespace driver::imported
