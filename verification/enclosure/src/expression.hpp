// SPDX-License-Identifier: Apache-2.0
// Expressions of a text, computed in complex balls.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "complex_ball.hpp"

namespace enclosure {

/// What an expression is computed with.
struct Workspace {
  std::vector<Complex> values;  // of all names, by slot
  /// Inside an integral: a result is finite only where the function is analytic on the whole rectangle.
  bool analytic = false;
};

using Expression = std::function<Complex(Workspace&)>;

/// An equation: the slot of its left side, and the right side.
struct Equation {
  std::size_t slot;
  Expression value;
};

/// Reads equations, such as `p = p0*exp(-t/tau)` or `f(x) = x^2 + 1`. Every name on a right side must stand
/// on the left side of an equation before it, or be declared; none may stand there twice.
class Reader {
 public:
  /// Declares a name; returns its slot.
  std::size_t declare(const std::string& name);
  /// Reads one equation. Throws std::logic_error, with the equation, if it is not one.
  void read(std::string_view equation);

  const std::vector<Equation>& equations() const { return equations_; }
  std::size_t slots() const { return slots_; }
  /// The slot of a name that stands for a number. Throws std::out_of_range if there is none.
  std::size_t slot(const std::string& name) const { return names_.at(name); }

 private:
  struct Function {
    std::vector<std::size_t> arguments;
    Expression value;
  };
  struct Bound;

  [[noreturn]] void fail(const char* what) const;
  char peek();
  bool take(char c);
  void expect(char c);
  std::string identifier();
  Expression sum();
  Expression product();
  Expression factor();
  Expression power();
  Expression primary();
  Expression number();
  Expression named();
  Expression choice();
  Bound bound();
  std::vector<Expression> arguments();

  std::map<std::string, std::size_t> names_;
  std::map<std::string, Function> functions_;
  std::vector<Equation> equations_;
  std::size_t slots_ = 0;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace enclosure
