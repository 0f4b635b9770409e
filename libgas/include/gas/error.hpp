// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>

namespace gas {

/// The computation left the domain of the model: temperature range, positive volume, step size. Bad *input*
/// is reported as std::invalid_argument instead.
struct DomainError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gas
