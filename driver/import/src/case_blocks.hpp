// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case_text.hpp"

namespace driver::imported {

/// [ambient], [gas], [[inflator]], [[sensor]] and [[vent]].
void gas_blocks(const BagDeck& bag, CaseText& out);

}  // namespace driver::imported
