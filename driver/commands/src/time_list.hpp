// SPDX-License-Identifier: Apache-2.0
// Numbers and times of a command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace driver::commands {

/// The number `text`, part of the option `whole`. Throws CaseError if it is not a finite number.
double parse_number(std::string_view text, const std::string& whole);

/// One number, or first:last:step with both ends to round-off, of the option --times. Empty for an empty
/// text. Throws CaseError for another text, a step that is not above 0, or too many rows.
std::vector<double> parse_times(const std::string& text);

}  // namespace driver::commands
