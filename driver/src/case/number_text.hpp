// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace driver {

/// The finite number that `text` is as a whole, as programs write it: a leading plus is allowed, what is too
/// small for a double is 0. Nothing for any other text.
std::optional<double> number_of(std::string_view text);
/// The same of a fraction, "0.02" or "2%".
std::optional<double> fraction_of(std::string_view text);

}  // namespace driver
