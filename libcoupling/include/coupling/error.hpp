// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>

namespace coupling {

// The computation left the domain of the contact model at run time: penetration beyond half the sphere's
// radius, a centre that crosses the skin, a coordinate that is not finite. The message names the element.
class ContactError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace coupling
