// SPDX-License-Identifier: Apache-2.0
// Formulas of parameters.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <elementary/exponential.hpp>
#include <elementary/trigonometric.hpp>

#include "base/case_reader.hpp"
#include "deck_reader.hpp"
#include "mesh/fortran_number.hpp"

namespace driver::imported {
namespace {

/// A parser by descent: sums of products of powers of brackets, numbers, names and functions.
class Expression {
 public:
  Expression(std::string_view text, const DeckText& deck, Place at) : text_(text), deck_(deck), at_(at) {}

  double value() {
    const double result = sum();
    if (peek() != '\0' || !std::isfinite(result)) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const {
    throw DeckFault(
        at_, fmt::format("the value '{}' is not understood, allowed: numbers, parameters, + - * / ** and "
                         "brackets",
                         shortened(std::string(without_blanks(text_)))));
  }
  char peek() {
    while (next_ < text_.size() && (text_[next_] == ' ' || text_[next_] == '\t')) ++next_;
    return next_ < text_.size() ? text_[next_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++next_;
    return true;
  }

  double sum() {
    if (++depth_ > 100) fail();
    double result = product();
    for (;;) {
      if (take('+'))
        result += product();
      else if (take('-'))
        result -= product();
      else
        break;
    }
    --depth_;
    return result;
  }
  double product() {
    double result = power();
    for (;;) {
      if (take('*'))
        result *= power();
      else if (take('/'))
        result /= power();
      else
        return result;
    }
  }
  double power() {
    if (++depth_ > 100) fail();
    const double base = operand();
    double result = base;
    if (peek() == '^') {
      ++next_;
      result = elementary::pow(base, power());
    } else if (text_.substr(next_).starts_with("**")) {
      next_ += 2;
      result = elementary::pow(base, power());
    }
    --depth_;
    return result;
  }
  double operand() {
    if (take('-')) return -power();
    if (take('+')) return power();
    if (take('(')) return closed(sum());
    const char c = peek();
    if ((c >= '0' && c <= '9') || c == '.') return number();
    if (c == '&') ++next_;
    return named();
  }
  double closed(double result) {
    if (!take(')')) fail();
    return result;
  }
  double number() {
    std::size_t end = next_;
    while (end < text_.size()) {
      const char c = text_[end];
      const bool sign = (c == '+' || c == '-') && (text_[end - 1] | 32) == 'e';
      const bool part = (c >= '0' && c <= '9') || c == '.' || (c | 32) == 'e' || (c | 32) == 'd' || sign;
      if (!part) break;
      ++end;
    }
    const std::string digits = mesh::without_fortran_exponent(text_.substr(next_, end - next_));
    double result = 0.0;
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result);
    if (error != std::errc() || last != digits.data() + digits.size()) fail();
    next_ = end;
    return result;
  }
  double named() {
    std::size_t end = next_;
    while (end < text_.size() && (text_[end] == '_' || (text_[end] >= '0' && text_[end] <= '9') ||
                                  ((text_[end] | 32) >= 'a' && (text_[end] | 32) <= 'z')))
      ++end;
    const std::string name = in_small_letters(text_.substr(next_, end - next_));
    if (name.empty()) fail();
    next_ = end;
    if (take('(')) return function(name, closed(sum()));
    const auto found = deck_.parameters.find(name);
    if (found == deck_.parameters.end()) fail();
    return found->second;
  }
  double function(const std::string& name, double x) const {
    if (name == "sqrt") return std::sqrt(x);
    if (name == "abs") return std::abs(x);
    if (name == "exp") return elementary::exp(x);
    if (name == "log") return elementary::log(x);
    if (name == "sin") return elementary::sin(x);
    if (name == "cos") return elementary::cos(x);
    if (name == "int") return std::trunc(x);
    fail();
  }

  std::string_view text_;
  const DeckText& deck_;
  Place at_;
  std::size_t next_ = 0;
  int depth_ = 0;
};

}  // namespace

double evaluate(std::string_view expression, const DeckText& deck, Place at) {
  return Expression(expression, deck, at).value();
}

}  // namespace driver::imported
