// SPDX-License-Identifier: Apache-2.0
// Python functions that are called while the library works.
#pragma once

#include "module.hpp"

/// Callback of a run: handles Python's signals first, then calls the user's function. An exception stops the
/// run.
struct Watcher {
  py::object function;
  std::optional<py::error_already_set> raised;

  static int call(double time, double end, void* user) {
    auto* watcher = static_cast<Watcher*>(user);
    const py::gil_scoped_acquire acquire;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (watcher->function.is_none()) return 0;
      return py::bool_(watcher->function(time, end)) ? 1 : 0;
    } catch (py::error_already_set& error) {
      watcher->raised.emplace(std::move(error));
      return 1;
    }
  }
};
