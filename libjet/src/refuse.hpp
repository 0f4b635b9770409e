// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

namespace jet {

/// Throws Error "name is value, allowed: allowed", with all digits of the value.
template <class Error = std::invalid_argument>
[[noreturn]] void refuse_value(const std::string& name, double value, const std::string& allowed) {
  std::ostringstream message;
  message.precision(17);
  message << name << " is " << value << ", allowed: " << allowed;
  throw Error(message.str());
}

}  // namespace jet
