// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace membrane {

// The computation left the domain of the model at run time (non-finite motion, a step above its bound).
// Wrong input to a build function is std::invalid_argument instead.
class MembraneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace membrane
