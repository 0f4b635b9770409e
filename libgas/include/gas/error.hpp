// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <stdexcept>
#include <string>

namespace gas {

/// The computation left the domain of the model: temperature range, positive volume, step size. Bad *input*
/// is reported as std::invalid_argument instead.
struct DomainError : std::runtime_error {
  /// `at`: the time [s] where a range ends, if it is known.
  explicit DomainError(const std::string& message, double at = std::numeric_limits<double>::quiet_NaN())
      : std::runtime_error(message), time(at) {}
  double time;  ///< When a range ends [s], in all digits; NaN if it is not known.
};

}  // namespace gas
