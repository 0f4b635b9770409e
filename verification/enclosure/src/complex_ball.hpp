// SPDX-License-Identifier: Apache-2.0
// A complex number within a rectangle; what an operation returns contains its exact value, as with Ball.
// Formulas of real numbers stay on the real axis; integrals leave it to bound their remainders.
#pragma once

#include <acb.h>

#include "ball.hpp"

namespace enclosure {

/// Bits of the numbers that follow. A formula is computed anew with more where its bounds are too wide.
inline thread_local slong complex_bits = 192;

/// A complex number, known to lie within a rectangle.
class Complex {
 public:
  Complex() { acb_init(z_); }
  Complex(double value) : Complex() { acb_set_d(z_, value); }  // exact
  Complex(const Complex& other) : Complex() { acb_set(z_, other.z_); }
  Complex(Complex&& other) noexcept : Complex() { acb_swap(z_, other.z_); }
  Complex& operator=(Complex other) noexcept {
    acb_swap(z_, other.z_);
    return *this;
  }
  ~Complex() { acb_clear(z_); }

  acb_ptr get() { return z_; }
  acb_srcptr get() const { return z_; }
  arb_ptr real() { return acb_realref(z_); }
  arb_srcptr real() const { return acb_realref(z_); }

  static Complex nothing_known() {
    Complex z;
    acb_indeterminate(z.z_);
    return z;
  }

 private:
  acb_t z_;
};

}  // namespace enclosure
