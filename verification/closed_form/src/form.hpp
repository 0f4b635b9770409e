// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "check.hpp"
#include "closed_form/catalogue.hpp"

namespace closed_form::entries {

using Row = std::vector<double>;

/// n + 1 equally spaced values.
Row range(double first, double last, int n);
/// The value, which must be a whole number, else std::invalid_argument.
int whole(const std::string& name, double value);

/// An entry without parameters and columns.
Entry described(const char* name, const char* title, const char* equation, const char* source,
                const char* validity, int digits);
void add_parameter(Entry& entry, const char* name, const char* symbol, const char* unit, double default_value,
                   const char* meaning);

/// Of a form that has no parameters.
struct Nothing {};

/// The member `inner` of the member `outer`.
template <class Outer, class Inner>
auto path(Outer outer, Inner inner) {
  return [=](auto& from) -> auto& {
    return std::invoke(inner, std::invoke(outer, from));
  };
}

/// Where the arguments of a form are what is asked for.
inline constexpr std::identity itself;

/// Stands for the abscissa among the inputs of with().
struct Abscissa {};
inline constexpr Abscissa abscissa;

/// A number that may be asked for as a whole one.
struct Number {
  const char* name;
  double value;
  operator double() const { return value; }
  operator int() const { return whole(name, value); }
};

/// What a form is evaluated at.
template <class Arguments>
struct Point {
  const Arguments& arguments;
  const ParameterMap& values;
  Number abscissa;

  Number input(Abscissa) const { return abscissa; }
  Number input(const char* name) const { return {name, values.at(name)}; }
  template <class Member>
  decltype(auto) input(Member member) const {
    return std::invoke(member, arguments);
  }
};

/// f of inputs: members of the arguments, names of parameters, the abscissa.
template <class F, class... Inputs>
auto with(F f, Inputs... inputs) {
  return [=]<class Arguments>(const Point<Arguments>& at) { return f(at.input(inputs)...); };
}

/// Calls f with what it takes: arguments, abscissa, both, the whole point or nothing.
template <class F, class Arguments>
auto call(const F& f, const Point<Arguments>& at) {
  if constexpr (std::is_invocable_v<F, const Arguments&, double>)
    return std::invoke(f, at.arguments, at.abscissa.value);
  else if constexpr (std::is_invocable_v<F, const Arguments&>)
    return std::invoke(f, at.arguments);
  else if constexpr (std::is_invocable_v<F, const Point<Arguments>&>)
    return f(at);
  else if constexpr (std::is_invocable_v<F, double>)
    return f(at.abscissa.value);
  else
    return f();
}

/// A column, and the member of the result that it shows, or a function of the result.
template <class Result>
struct Column {
  const char* name;  // with unit suffix
  std::function<double(const Result&)> value;
};
template <class Result>
using Columns = std::vector<Column<Result>>;

/// Builds an entry of the catalogue from tables: each parameter stands once, beside the member of Arguments
/// that takes its value; each column once, beside the member of the result that it shows.
template <class Arguments>
class Form {
 public:
  Form(const char* name, const char* title, const char* equation, const char* source, const char* validity,
       int digits)
      : entry_(described(name, title, equation, source, validity, digits)) {}

  /// A parameter that is a number by itself.
  Form& number(const char* name, const char* symbol, const char* unit, double default_value,
               const char* meaning) {
    add_parameter(entry_, name, symbol, unit, default_value, meaning);
    return *this;
  }

  /// A parameter that sets `member`; a bool or enum, by 0 or 1.
  template <class Member>
  Form& field(Member member, const char* name, const char* symbol, const char* unit, double default_value,
              const char* meaning) {
    setters_[name] = [=](Arguments& arguments, double value) {
      auto& target = std::invoke(member, arguments);
      using Target = std::remove_reference_t<decltype(target)>;
      if constexpr (std::is_same_v<Target, double>)
        target = value;
      else
        target = static_cast<Target>(check::integer_within(name, whole(name, value), 0, 1));
    };
    return number(name, symbol, unit, default_value, meaning);
  }

  /// Parameters that several forms share.
  template <class... Groups>
  Form& fields(const Groups&... groups) {
    (groups(*this), ...);
    return *this;
  }

  /// Takes the field `name` out of the parameters: the form does not depend on it.
  Form& fixed(const char* name, double value) {
    setters_.at(name)(initial_, value);
    setters_.erase(name);
    std::erase_if(entry_.parameters, [&](const Parameter& parameter) { return parameter.name == name; });
    return *this;
  }

  /// The abscissa, and its default values. To be called before the columns.
  Form& over(const char* name, Row values) {
    entry_.columns.emplace_back(name);
    entry_.default_abscissae = std::move(values);
    return *this;
  }
  /// An abscissa that sets `member`.
  template <class Member>
  Form& over(const char* name, Row values, Member member) {
    set_abscissa_ = [member](Arguments& arguments, double value) { std::invoke(member, arguments) = value; };
    return over(name, std::move(values));
  }

  template <class F>
  using Result = std::decay_t<decltype(call(std::declval<F>(), std::declval<Point<Arguments>>()))>;

  /// Columns of the result of f, a function of what call() gives.
  template <class F>
  Form& results(F f, Columns<Result<F>> columns) {
    for (const auto& column : columns) entry_.columns.emplace_back(column.name);
    evaluators_.push_back([f, columns = std::move(columns)](const Point<Arguments>& at, Row& row) {
      const Result<F> result = call(f, at);
      for (const auto& column : columns) row.push_back(column.value(result));
    });
    return *this;
  }
  /// The column that f itself gives.
  template <class F>
  Form& result(const char* name, F f) {
    return results(f, {{name, [](Result<F> value) { return static_cast<double>(value); }}});
  }
  /// A column that does not depend on the abscissa.
  template <class F>
  Form& constant(const char* name, F f) {
    entry_.constants.emplace_back(name);
    return result(name, f);
  }

  operator Entry() const {
    Entry entry = entry_;
    entry.values = [form = *this](const ParameterMap& values, double x) {
      Arguments arguments = form.initial_;
      for (const auto& [name, set] : form.setters_) set(arguments, values.at(name));
      if (form.set_abscissa_) form.set_abscissa_(arguments, x);
      Row row;
      const Number named{form.entry_.columns.front().c_str(), x};
      for (const auto& evaluate : form.evaluators_) evaluate({arguments, values, named}, row);
      return row;
    };
    return entry;
  }

 private:
  Entry entry_;
  Arguments initial_{};
  std::map<std::string, std::function<void(Arguments&, double)>> setters_;  // of parameters, by name
  std::function<void(Arguments&, double)> set_abscissa_;
  std::vector<std::function<void(const Point<Arguments>&, Row&)>> evaluators_;
};

}  // namespace closed_form::entries
