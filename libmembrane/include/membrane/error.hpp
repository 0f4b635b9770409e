// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace membrane {

/// The computation left the domain of the model at run time: motion is not finite, or the gas has no volume.
/// Wrong input is reported as std::invalid_argument instead.
class MembraneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace membrane
