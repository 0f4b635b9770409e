// SPDX-License-Identifier: Apache-2.0
// What a case may say of a contact.
#pragma once

#include "base/case_reader.hpp"

namespace driver {

/// Of omega^2. Beyond it the default stiffness, which friction divides, would hold nothing.
inline constexpr Bounds contact_share{0.0, 1e20, true, "a number above 0, at most 1e20"};
/// Coefficient of sliding.
inline constexpr Bounds contact_friction{0.0, 10.0, false, "a number from 0 to 10"};

}  // namespace driver
