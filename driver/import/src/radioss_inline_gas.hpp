// SPDX-License-Identifier: Apache-2.0
// Gas and inflators of /MONVOL/AIRBAG and /MONVOL/COMMU, the older form, which has its gases by gamma and cp.
#pragma once

#include "radioss_tables.hpp"

namespace driver::imported {

/// True for a volume of that form.
bool has_inline_gas(const DeckCard& volume);

void map_inline_gas(RadiossContext& context);

}  // namespace driver::imported
