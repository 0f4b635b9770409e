// SPDX-License-Identifier: Apache-2.0
// Outcomes that rows of both tables of features have.
#pragma once

#include "export/feature.hpp"

namespace driver::outcomes {

inline constexpr Outcome same{Mapping::exact, "as in the case"};
inline constexpr Outcome in_deck{Mapping::exact, "input of the deck's numbers"};
inline constexpr Outcome own_penalty{Mapping::approximated, "contact by node with the program's own penalty"};

}  // namespace driver::outcomes
