// SPDX-License-Identifier: Apache-2.0
#include "expression.hpp"

#include <cctype>
#include <stdexcept>

#include "functions.hpp"

namespace enclosure {

/// Arguments of `integral(x, a, b, f)`, `root(x, a, b, f)` and `sum(k, a, b, f)`.
struct Reader::Bound {
  std::size_t slot;  // of the name that f depends on
  Expression low, high, value;
};

namespace {

/// f of Bound as a function.
auto function_of(std::size_t slot, const Expression& value, Workspace& w) {
  return [slot, &value, &w](const Complex& x, bool analytic = false) {
    w.values[slot] = x;
    const bool before = std::exchange(w.analytic, analytic);
    Complex y = value(w);
    w.analytic = before;
    return y;
  };
}

template <class Operation>
Expression binary(Expression a, Expression b, Operation operation) {
  return [a = std::move(a), b = std::move(b), operation](Workspace& w) { return operation(a(w), b(w)); };
}

}  // namespace

std::size_t Reader::declare(const std::string& name) {
  if (!names_.emplace(name, slots_).second) throw std::logic_error("formula: " + name + " stands twice");
  return slots_++;
}

void Reader::fail(const char* what) const {
  throw std::logic_error("formula: " + std::string(text_.substr(0, at_)) + " <- " + what + " in " +
                         std::string(text_));
}

char Reader::peek() {
  while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool Reader::take(char c) {
  if (peek() != c) return false;
  ++at_;
  return true;
}

void Reader::expect(char c) {
  if (!take(c)) fail("another character is expected");
}

std::string Reader::identifier() {
  if (!std::isalpha(static_cast<unsigned char>(peek()))) fail("a name is expected");
  const std::size_t begin = at_;
  while (at_ < text_.size() &&
         (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' || text_[at_] == '\''))
    ++at_;
  return std::string(text_.substr(begin, at_ - begin));
}

void Reader::read(std::string_view equation) {
  text_ = equation;
  at_ = 0;
  const std::string name = identifier();
  if (take('(')) {
    Function f;
    const auto outer = names_;
    do f.arguments.push_back(declare(identifier()));
    while (take(','));
    expect(')');
    expect('=');
    f.value = sum();
    names_ = outer;
    if (!functions_.emplace(name, f).second) fail("a function that stands twice");
  } else {
    expect('=');
    Expression value = sum();
    equations_.push_back({declare(name), std::move(value)});
  }
  if (peek()) fail("nothing more is expected");
}

Expression Reader::sum() {
  Expression left = product();
  while (true) {
    if (take('+'))
      left = binary(left, product(), add);
    else if (take('-'))
      left = binary(left, product(), subtract);
    else
      return left;
  }
}

Expression Reader::product() {
  Expression left = factor();
  while (true) {
    if (take('*'))
      left = binary(left, factor(), multiply);
    else if (take('/'))
      left = binary(left, factor(), divide);
    else
      return left;
  }
}

Expression Reader::factor() {
  if (!take('-')) return power();
  return binary([](Workspace&) { return Complex(); }, factor(), subtract);
}

Expression Reader::power() {
  Expression base = primary();
  if (!take('^')) return base;
  return [base, exponent = factor()](Workspace& w) {
    return enclosure::power(base(w), exponent(w), w.analytic);
  };
}

Expression Reader::primary() {
  if (take('(')) {
    Expression value = sum();
    expect(')');
    return value;
  }
  return std::isdigit(static_cast<unsigned char>(peek())) ? number() : named();
}

// A decimal number stands for itself, not for the double next to it.
Expression Reader::number() {
  const std::size_t begin = at_;
  const auto is = [&](const char* allowed) {
    return at_ < text_.size() && std::string_view(allowed).find(text_[at_]) != std::string_view::npos;
  };
  while (is("0123456789.")) ++at_;
  if (is("e")) {
    ++at_;
    if (is("-")) ++at_;
    while (is("0123456789")) ++at_;
  }
  return [text = std::string(text_.substr(begin, at_ - begin))](Workspace&) {
    Complex z;
    arb_set_str(z.real(), text.c_str(), complex_bits);
    return z;
  };
}

Reader::Bound Reader::bound() {
  const std::string name = identifier();
  expect(',');
  Bound b{0, sum(), {}, {}};
  expect(',');
  b.high = sum();
  expect(',');
  b.slot = declare(name);
  b.value = sum();
  names_.erase(name);
  expect(')');
  return b;
}

std::vector<Expression> Reader::arguments() {
  std::vector<Expression> all;
  do all.push_back(sum());
  while (take(','));
  expect(')');
  return all;
}

// `if(a < b, x, y)`. If balls leave open which holds, the hull of both.
Expression Reader::choice() {
  Expression a = sum();
  const bool less = take('<');
  if (!less) expect('>');
  Expression b = sum();
  expect(',');
  Expression then = sum();
  expect(',');
  Expression otherwise = sum();
  expect(')');
  if (!less) std::swap(a, b);
  return [a, b, then, otherwise](Workspace& w) {
    const Complex x = a(w), y = b(w);
    if (w.analytic) return Complex::nothing_known();
    if (arb_lt(x.real(), y.real())) return then(w);
    if (arb_ge(x.real(), y.real())) return otherwise(w);
    return hull(then(w), otherwise(w));
  };
}

Expression Reader::named() {
  const std::string name = identifier();
  if (!take('(')) {
    if (name == "pi")
      return [](Workspace&) {
        Complex z;
        arb_const_pi(z.real(), complex_bits);
        return z;
      };
    const auto it = names_.find(name);
    if (it == names_.end()) fail("an unknown name");
    return [slot = it->second](Workspace& w) { return w.values[slot]; };
  }
  if (name == "if") return choice();
  if (name == "integral")
    return [b = bound()](Workspace& w) {
      return integral(function_of(b.slot, b.value, w), b.low(w), b.high(w));
    };
  if (name == "root")
    return [b = bound()](Workspace& w) { return root(function_of(b.slot, b.value, w), b.low(w), b.high(w)); };
  if (name == "sum")
    return [b = bound()](Workspace& w) {
      Complex total;
      const long last = whole(b.high(w));
      for (long k = whole(b.low(w)); k <= last; ++k) {
        w.values[b.slot] = static_cast<double>(k);
        total = add(total, b.value(w));
      }
      return total;
    };
  const auto own = functions_.find(name);
  if (own != functions_.end()) {
    const std::vector<Expression> given = arguments();
    if (given.size() != own->second.arguments.size()) fail("a wrong number of arguments");
    return [given, f = own->second](Workspace& w) {
      std::vector<Complex> values;
      for (const Expression& argument : given) values.push_back(argument(w));
      for (std::size_t i = 0; i < given.size(); ++i) w.values[f.arguments[i]] = std::move(values[i]);
      return f.value(w);
    };
  }
  const std::vector<Expression> given = arguments();
  const NumberFunction* f = find_function(name, given.size());
  if (!f) fail("an unknown function");
  return [given, f](Workspace& w) {
    std::vector<Complex> values;
    for (const Expression& argument : given) values.push_back(argument(w));
    return (*f)(values, w.analytic);
  };
}

}  // namespace enclosure
