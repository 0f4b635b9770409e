// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>

namespace coupling {

/// The computation left the domain of the contact model at run time: penetration beyond half the
/// impactor's size, a centre that crosses the skin, an impactor that swings too far in a step, or a
/// coordinate that is not finite. The message names the element, if there is one, and the limit.
class ContactError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The impactor sank in by more than half its size, or a sphere's centre crossed the skin. A stiffer contact
/// prevents that.
class PenetrationError : public ContactError {
 public:
  /// `element` of the skin, where.
  PenetrationError(const std::string& message, int element) : ContactError(message), element_(element) {}
  int element() const { return element_; }  // of the skin

 private:
  int element_;
};

}  // namespace coupling
