// SPDX-License-Identifier: Apache-2.0
// Functions of a module whose errors name the argument; pybind11's own do not.
#pragma once

#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "convert.hpp"

using Indices = py::array_t<int32_t, py::array::c_style | py::array::forcecast>;

/// Description of the Python values for an argument of type A.
template <class A>
std::string allowed() {
  if constexpr (std::is_same_v<A, bool>) return "True or False";
  if constexpr (std::is_integral_v<A>) return "an integer of " + std::to_string(8 * sizeof(A)) + " bits";
  if constexpr (std::is_floating_point_v<A>) return "a number";
  if constexpr (std::is_same_v<A, std::string>) return "a text without a NUL";
  if constexpr (std::is_same_v<A, std::optional<std::string>>) return "a text without a NUL, or None";
  if constexpr (std::is_same_v<A, std::array<double, 3>>) return "three numbers";
  return "an object or array of the documented kind";
}

/// A value in a message: itself if short, otherwise its type.
inline std::string shown(py::handle given) {
  try {
    const auto text = py::repr(given).cast<std::string>();
    if (text.size() <= 60 && text.find('\n') == std::string::npos) return text;
  } catch (const py::error_already_set&) {  // its __repr__ throws
  }
  return std::string("a ") + Py_TYPE(given.ptr())->tp_name;
}

/// Converts lists and the like to arrays. None is accepted only where it is a value.
template <class A>
void load(py::detail::make_caster<A>& caster, py::handle given, const char* name) {
  using Text = std::string;
  constexpr bool takes_none = std::is_same_v<A, py::object> || std::is_same_v<A, std::optional<Text>> ||
                              std::is_same_v<A, std::optional<Indices>> ||
                              std::is_same_v<A, std::optional<std::array<double, 9>>>;
  bool fits = (takes_none || !given.is_none()) && caster.load(given, true);
  if constexpr (std::is_same_v<A, Text>) {  // the library's texts end at a NUL
    fits = fits && py::detail::cast_op<Text&>(caster).find('\0') == Text::npos;
  } else if constexpr (std::is_same_v<A, std::optional<Text>>) {
    fits = fits && py::detail::cast_op<std::optional<Text>&>(caster).value_or("").find('\0') == Text::npos;
  }
  if (fits) return;
  PyErr_Clear();
  wrong_type(name, "is " + shown(given) + ", allowed: " + allowed<A>());
}

/// m.def of a function with positional arguments of these names.
template <class R, class... A, std::size_t count>
void def(py::module_& m, const char* name, R (*function)(A...), const char* const (&names)[count]) {
  static_assert(count == sizeof...(A));
  const auto all = std::to_array(names);
  m.def(name, [=](const py::args& given) {
    if (given.size() != count) wrong_type(name, "takes " + std::to_string(count) + " arguments");
    std::tuple<py::detail::make_caster<A>...> casters;
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      (load<std::decay_t<A>>(std::get<i>(casters), given[i], all[i]), ...);
      return function(py::detail::cast_op<A>(std::move(std::get<i>(casters)))...);
    }
    (std::index_sequence_for<A...>{});
  });
}
