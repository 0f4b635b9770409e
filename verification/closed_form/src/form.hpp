// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
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
inline auto itself() {
  return [](auto& arguments) -> auto& {
    return arguments;
  };
}

/// Stands for the abscissa among the inputs of with().
struct Abscissa {};
inline constexpr Abscissa abscissa;

/// f of some members of the arguments and of the abscissa.
template <class F, class... Inputs>
auto with(F f, Inputs... inputs) {
  return [=](const auto& arguments, double x) {
    const auto value = [&](const auto& input) -> decltype(auto) {
      if constexpr (std::is_same_v<decltype(input), const Abscissa&>)
        return (x);
      else
        return std::invoke(input, arguments);
    };
    return f(value(inputs)...);
  };
}

/// Calls f with what it takes: arguments, abscissa, both or none.
template <class F, class Arguments>
auto call(const F& f, const Arguments& arguments, double x) {
  if constexpr (std::is_invocable_v<F, const Arguments&, double>)
    return std::invoke(f, arguments, x);
  else if constexpr (std::is_invocable_v<F, const Arguments&>)
    return std::invoke(f, arguments);
  else if constexpr (std::is_invocable_v<F, double>)
    return f(x);
  else
    return f();
}

/// A column, and the member of the result that it shows, or a function of the result.
template <class Result>
struct Column {
  std::string name;  // with unit suffix
  std::function<double(const Result&)> value;
};
template <class Result>
using Columns = std::vector<Column<Result>>;

/// Builds an entry of the catalogue from tables: each parameter stands once, beside the member of Arguments
/// that takes its value; each column once, beside the member of the result that it shows.
template <class Arguments>
class Form {
 public:
  Form(std::string name, std::string title, std::string equation, std::string source, std::string validity,
       int digits) {
    entry_.name = std::move(name);
    entry_.title = std::move(title);
    entry_.equation = std::move(equation);
    entry_.source = std::move(source);
    entry_.validity = std::move(validity);
    entry_.digits = digits;
  }

  /// A parameter that sets `member`. An int must be given a whole number, a bool or enum 0 or 1.
  template <class Member>
  Form& field(Member member, const std::string& name, std::string symbol, std::string unit,
              double default_value, std::string meaning) {
    entry_.parameters.push_back(
        {name, std::move(symbol), std::move(unit), default_value, std::move(meaning)});
    setters_.push_back([member, name](Arguments& arguments, double value) {
      auto& target = std::invoke(member, arguments);
      using Target = std::remove_reference_t<decltype(target)>;
      if constexpr (std::is_same_v<Target, double>)
        target = value;
      else if constexpr (std::is_same_v<Target, int>)
        target = whole(name, value);
      else
        target = static_cast<Target>(check::integer_within(name, whole(name, value), 0, 1));
    });
    return *this;
  }

  /// Parameters that several forms share.
  template <class... Groups>
  Form& fields(const Groups&... groups) {
    (groups(*this), ...);
    return *this;
  }

  /// Takes the field `name` out of the parameters: the form does not depend on it.
  Form& fixed(const std::string& name, double value) {
    const auto found = std::ranges::find(entry_.parameters, name, &Parameter::name);
    const auto setter = setters_.begin() + (found - entry_.parameters.begin());
    (*setter)(initial_, value);
    setters_.erase(setter);
    entry_.parameters.erase(found);
    return *this;
  }

  /// The abscissa, and its default values. To be called before the columns.
  Form& over(std::string name, Row values) {
    entry_.columns.push_back(std::move(name));
    entry_.default_abscissae = std::move(values);
    return *this;
  }
  /// An abscissa that sets `member`.
  template <class Member>
  Form& over(std::string name, Row values, Member member) {
    set_abscissa_ = [member](Arguments& arguments, double value) { std::invoke(member, arguments) = value; };
    return over(std::move(name), std::move(values));
  }

  template <class F>
  using Result = std::decay_t<decltype(call(std::declval<F>(), std::declval<Arguments>(), 0.0))>;

  /// Columns of the result of f, a function of what call() gives.
  template <class F>
  Form& results(F f, Columns<Result<F>> columns) {
    for (const auto& column : columns) entry_.columns.push_back(column.name);
    evaluators_.push_back([f, columns = std::move(columns)](const Arguments& arguments, double x, Row& row) {
      const Result<F> result = call(f, arguments, x);
      for (const auto& column : columns) row.push_back(column.value(result));
    });
    return *this;
  }
  /// The column that f itself gives.
  template <class F>
  Form& result(std::string name, F f) {
    return results(f, {{std::move(name), [](Result<F> value) { return static_cast<double>(value); }}});
  }
  /// A column that does not depend on the abscissa.
  template <class F>
  Form& constant(const std::string& name, F f) {
    entry_.constants.push_back(name);
    return result(name, f);
  }

  operator Entry() const {
    Entry entry = entry_;
    entry.values = [form = *this](const ParameterMap& values, double x) {
      Arguments arguments = form.initial_;
      for (std::size_t i = form.setters_.size(); i-- > 0;)  // of two bad values it names the last
        form.setters_[i](arguments, values.at(form.entry_.parameters[i].name));
      if (form.set_abscissa_) form.set_abscissa_(arguments, x);
      Row row;
      for (const auto& evaluator : form.evaluators_) evaluator(arguments, x, row);
      return row;
    };
    return entry;
  }

 private:
  Entry entry_;
  Arguments initial_{};
  std::vector<std::function<void(Arguments&, double)>> setters_;  // of each parameter
  std::function<void(Arguments&, double)> set_abscissa_;
  std::vector<std::function<void(const Arguments&, double, Row&)>> evaluators_;
};

}  // namespace closed_form::entries
