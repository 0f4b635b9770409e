// SPDX-License-Identifier: Apache-2.0
// Shared by the parts of gasjet._gasjet.
#pragma once

#include <gasjet.h>

#include <algorithm>
#include <memory>

#include "arguments.hpp"

using Points = Rows<double>;
using Triangles = Rows<int32_t>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Vector = std::array<double, 3>;

/// Calls a function of the border without the interpreter's lock.
template <class F>
void unlocked(F&& f) {
  int status = GASJET_OK;
  std::string message;
  {
    const py::gil_scoped_release release;
    status = f();
    if (status != GASJET_OK) message = gasjet_last_error();
  }
  raise(status, message.c_str());
}
inline void check(int status) {
  if (status != GASJET_OK) raise(status, gasjet_last_error());
}

/// A handle owned by Python.
struct Handle {
  explicit Handle(gasjet_handle given) : value(given) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { gasjet_free(value); }
  gasjet_handle value;
};
using Owner = std::unique_ptr<Handle>;

inline Points points(const py::object& given, const char* argument) {
  return {given, argument, "float64"};
}
inline Triangles triangles(const py::object& given) {
  return {given, "triangles", "int32"};
}

inline void copy(const Vector& from, double* to) {
  std::copy(from.begin(), from.end(), to);
}

inline py::array_t<double> array_of(const double* from) {
  return py::array_t<double>(3, from);
}

template <class T>
py::array_t<T> vectors(int64_t count) {
  return py::array_t<T>({static_cast<py::ssize_t>(count), py::ssize_t{3}});
}

/// The history, the energies and the summary of a run, which Python then owns.
py::tuple results_of(gasjet_handle run);
py::dict dict_of(const gasjet_tank_state& state);

void add_gas(py::module_& m);
void add_bodies(py::module_& m);
void add_coupling(py::module_& m);
void add_rigid_body(py::module_& m);
void add_runs(py::module_& m);
void add_simulation(py::module_& m);
