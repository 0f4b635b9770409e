// SPDX-License-Identifier: Apache-2.0
#include "functions.hpp"

#include <acb_elliptic.h>
#include <acb_hypgeom.h>
#include <acb_modular.h>
#include <arb_hypgeom.h>

#include <map>

namespace enclosure {
namespace {

using Arguments = const std::vector<Complex>&;

/// Of a function that is analytic wherever it is finite.
NumberFunction everywhere(void (*f)(acb_t, const acb_t, slong)) {
  return [f](Arguments a, bool) {
    Complex z;
    f(z.get(), a[0].get(), complex_bits);
    return z;
  };
}

/// Of one that Arb computes with regard to its branch cut.
NumberFunction with_cut(void (*f)(acb_t, const acb_t, int, slong)) {
  return [f](Arguments a, bool analytic) {
    Complex z;
    f(z.get(), a[0].get(), analytic, complex_bits);
    return z;
  };
}

/// Of one that no integral needs.
template <class F>
NumberFunction outside_integrals(F f) {
  return [f](Arguments a, bool analytic) { return analytic ? Complex::nothing_known() : f(a); };
}
NumberFunction outside_integrals(void (*f)(acb_t, const acb_t, slong)) {
  return outside_integrals([f](Arguments a) { return everywhere(f)(a, false); });
}

/// Of real numbers.
NumberFunction of_reals(void (*f)(arb_t, const arb_t, const arb_t, slong)) {
  return outside_integrals([f](Arguments a) {
    Complex z;
    f(z.real(), a[0].real(), a[1].real(), complex_bits);
    return z;
  });
}

NumberFunction bessel(void (*f)(acb_t, const acb_t, const acb_t, slong)) {
  return [f](Arguments a, bool) {  // entire, as the order is whole
    Complex z;
    f(z.get(), a[0].get(), a[1].get(), complex_bits);
    return z;
  };
}

/// Numbers between -|x| and |x|.
Complex error(Arguments a) {
  Complex z;
  arb_add_error(z.real(), a[0].real());
  return z;
}

Complex hypergeometric(Arguments a) {
  Complex z;
  acb_hypgeom_2f1(z.get(), a[0].get(), a[1].get(), a[2].get(), a[3].get(), 0, complex_bits);
  return z;
}

/// sn (first) or cn of u for the parameter m = k^2 by theta functions of u/(2 K) (Whittaker and Watson, A
/// Course of Modern Analysis, section 22.11).
Complex jacobi(const Complex& u, const Complex& m, bool first) {
  const Complex quarter = (*find_function("ellipk", 1))({m}, false);
  const Complex other = (*find_function("ellipk", 1))({subtract(1.0, m)}, false);
  Complex tau = divide(other, quarter);
  acb_mul_onei(tau.get(), tau.get());
  const Complex v = divide(u, multiply(2.0, quarter));
  Complex at[4], zero[4];
  acb_modular_theta(at[0].get(), at[1].get(), at[2].get(), at[3].get(), v.get(), tau.get(), complex_bits);
  acb_modular_theta(zero[0].get(), zero[1].get(), zero[2].get(), zero[3].get(), Complex().get(), tau.get(),
                    complex_bits);
  const Complex ratio = divide(zero[first ? 2 : 3], zero[1]);
  return multiply(ratio, divide(at[first ? 0 : 1], at[3]));
}

struct Entry {
  std::size_t arguments;
  NumberFunction function;
};

std::map<std::string, Entry> table() {
  return {
      {"exp", {1, everywhere(acb_exp)}},
      {"sin", {1, everywhere(acb_sin)}},
      {"cos", {1, everywhere(acb_cos)}},
      {"tan", {1, everywhere(acb_tan)}},
      {"cosh", {1, everywhere(acb_cosh)}},
      {"erf", {1, everywhere(acb_hypgeom_erf)}},
      {"erfc", {1, everywhere(acb_hypgeom_erfc)}},
      {"besselj", {2, bessel(acb_hypgeom_bessel_j)}},
      {"besseli", {2, bessel(acb_hypgeom_bessel_i)}},
      {"sqrt", {1, with_cut(acb_sqrt_analytic)}},
      {"log", {1, with_cut(acb_log_analytic)}},
      {"asin", {1, outside_integrals(acb_asin)}},
      {"acos", {1, outside_integrals(acb_acos)}},
      {"atan", {1, outside_integrals(acb_atan)}},
      {"asinh", {1, outside_integrals(acb_asinh)}},
      {"tgamma", {1, outside_integrals(acb_gamma)}},
      {"ellipk", {1, outside_integrals(acb_elliptic_k)}},
      {"zeta", {1, outside_integrals(acb_zeta)}},
      {"min", {2, of_reals(arb_min)}},
      {"max", {2, of_reals(arb_max)}},
      {"error", {1, outside_integrals(error)}},
      {"hyp2f1", {4, outside_integrals(hypergeometric)}},
      {"sn", {2, outside_integrals([](Arguments a) { return jacobi(a[0], a[1], true); })}},
      {"cn", {2, outside_integrals([](Arguments a) { return jacobi(a[0], a[1], false); })}},
      {"besselj_zero",
       {2, outside_integrals([](Arguments a) { return bessel_zero(whole(a[0]), whole(a[1])); })}},
  };
}

using Operation = void(acb_t, const acb_t, const acb_t, slong);

template <Operation operation>
Complex computed(const Complex& a, const Complex& b) {
  Complex c;
  operation(c.get(), a.get(), b.get(), complex_bits);
  return c;
}

}  // namespace

const NumberFunction* find_function(const std::string& name, std::size_t arguments) {
  static const std::map<std::string, Entry> functions = table();
  const auto it = functions.find(name);
  return it != functions.end() && it->second.arguments == arguments ? &it->second.function : nullptr;
}

Complex add(const Complex& a, const Complex& b) {
  return computed<acb_add>(a, b);
}
Complex subtract(const Complex& a, const Complex& b) {
  return computed<acb_sub>(a, b);
}
Complex multiply(const Complex& a, const Complex& b) {
  return computed<acb_mul>(a, b);
}
Complex divide(const Complex& a, const Complex& b) {
  return computed<acb_div>(a, b);
}
Complex hull(const Complex& a, const Complex& b) {
  return computed<acb_union>(a, b);
}
long whole(const Complex& z) {
  return static_cast<long>(arf_get_si(arb_midref(z.real()), ARF_RND_NEAR));
}
Complex power(const Complex& a, const Complex& b, bool analytic) {
  Complex c;
  acb_pow_analytic(c.get(), a.get(), b.get(), analytic, complex_bits);
  return c;
}

}  // namespace enclosure
