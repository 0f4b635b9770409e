// SPDX-License-Identifier: Apache-2.0
// Functions that formulas call, in complex balls.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "complex_ball.hpp"

namespace enclosure {

/// A function of numbers. If `analytic`, the result is finite only where the function is analytic.
using NumberFunction = std::function<Complex(const std::vector<Complex>& arguments, bool analytic)>;

/// The function of this name and number of arguments; null if there is none.
const NumberFunction* find_function(const std::string& name, std::size_t arguments);

Complex add(const Complex& a, const Complex& b);
Complex subtract(const Complex& a, const Complex& b);
Complex multiply(const Complex& a, const Complex& b);
Complex divide(const Complex& a, const Complex& b);
Complex power(const Complex& a, const Complex& b, bool analytic);
/// The whole number nearest to the midpoint: of a count or an order.
long whole(const Complex& z);
/// The smallest rectangle around both.
Complex hull(const Complex& a, const Complex& b);

using Integrand = std::function<Complex(const Complex& x, bool analytic)>;

/// Integral from a to b (F. Johansson, "Numerical integration in arbitrary-precision ball arithmetic", ICMS
/// 2018: Gauss-Legendre quadrature whose error follows from the size of the function on ellipses around a
/// piece, where it is analytic).
Complex integral(const Integrand& f, const Complex& a, const Complex& b);

/// The only root in [low, high]. Halves the interval, and drops the parts in which f is not 0. What is left
/// holds all roots; there is one by the intermediate value theorem if f changes its sign over it. Nothing
/// known if parts far from each other are left, f does not change its sign, or is not finite there.
Complex root(const std::function<Complex(const Complex&)>& f, const Complex& low, const Complex& high);

/// Zero number `order` >= 1 of the Bessel function J of whole order m >= 0. All zeros up to it are found: in
/// each piece J is not 0, or its slope is not and its signs at the ends say if there is a zero.
Complex bessel_zero(long m, long order);

}  // namespace enclosure
