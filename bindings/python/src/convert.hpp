// SPDX-License-Identifier: Apache-2.0
// NumPy arrays and statuses, for both modules.
#pragma once

#include <gasjet/base.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstring>
#include <string>

namespace py = pybind11;

/// Raises the exception of a status, from the package `gasjet`.
inline void raise(int status, const char* message) {
  if (status == GASJET_OK) return;
  const char* names[] = {"", "", "InputError", "DomainError", "BusyError", "StoppedError", "Error"};
  const py::object type = py::module_::import("gasjet.errors").attr(names[status]);
  // The user's text may not be UTF-8.
  const auto text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(message, static_cast<py::ssize_t>(std::strlen(message)), "backslashreplace"));
  PyErr_SetObject(type.ptr(), text.ptr());
  throw py::error_already_set();
}

[[noreturn]] inline void wrong_type(const std::string& argument, const std::string& what) {
  PyErr_SetString(PyExc_TypeError, (argument + ": " + what).c_str());
  throw py::error_already_set();
}

/// Rows of three, or a vector, of Number. NumPy arrays are not copied; lists and the like are converted.
template <class Number>
struct Rows {
  Rows(const py::object& given, const char* argument, const char* dtype) {
    if (!py::isinstance<py::array>(given)) {
      array = py::array_t<Number>::ensure(given);
      if (!array) {
        PyErr_Clear();
        wrong_type(argument, std::string("is not an array, allowed: (n, 3) of ") + dtype);
      }
    } else {
      array = py::reinterpret_borrow<py::array>(given);
    }
    if (!py::isinstance<py::array_t<Number>>(array))
      wrong_type(argument,
                 "has the dtype " + py::str(array.dtype()).cast<std::string>() + ", allowed: " + dtype);
    if (array.ndim() != 2 || array.shape(1) != 3)
      wrong_type(argument, "has " + std::to_string(array.ndim()) + " dimensions of which the last is " +
                               (array.ndim() > 0 ? std::to_string(array.shape(array.ndim() - 1)) : "none") +
                               ", allowed: the shape (n, 3)");
    for (int i = 0; i < 2; ++i) {
      const auto bytes = array.strides(i);
      if (bytes % static_cast<py::ssize_t>(sizeof(Number)) != 0)
        wrong_type(argument,
                   "has a stride of " + std::to_string(bytes) + " bytes, allowed: whole numbers apart");
      stride[static_cast<std::size_t>(i)] = bytes / static_cast<py::ssize_t>(sizeof(Number));
    }
    // Copies broadcast arrays, whose stride is 0.
    if (count() <= 1 || stride[0] == 0 || stride[1] == 0)
      array = py::array_t<Number, py::array::c_style | py::array::forcecast>(array), stride = {3, 1};
  }
  const Number* data() const { return static_cast<const Number*>(array.data()); }
  int64_t count() const { return array.shape(0); }

  py::array array;
  std::array<int64_t, 2> stride{};
};

/// A read-only view of numbers owned by `owner`.
inline py::array view(const double* values, int64_t count, const py::object& owner) {
  py::array_t<double> array(count, values, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}
