// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace enclosure {

/// The files of the folder `formulas`, one after the other.
extern const char* const formula_texts;

}  // namespace enclosure
