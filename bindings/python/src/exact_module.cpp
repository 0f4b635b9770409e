// SPDX-License-Identifier: Apache-2.0
// gasjet._exact: gasjet_exact.h for Python. It links GSL (GPL), so it is loaded only if a closed form is
// asked for.
#include <gasjet_exact.h>

#include <memory>

#include "arguments.hpp"

namespace {

struct Table {
  explicit Table(gasjet_handle given) : value(given) {}
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() { gasjet_exact_free(value); }
  gasjet_handle value;
};

void check(int status) {
  if (status != GASJET_OK) raise(status, gasjet_exact_last_error());
}

py::dict evaluate(const std::string& name, const std::string& parameters,
                  const py::array_t<double, py::array::c_style | py::array::forcecast>& times) {
  gasjet_handle handle = 0;
  check(gasjet_exact_create(name.c_str(), parameters.c_str(), times.data(), times.size(), &handle));
  const py::object owner = py::cast(std::make_unique<Table>(handle));
  int64_t columns = 0, rows = 0;
  check(gasjet_exact_size(handle, &columns, &rows));
  py::dict all;
  for (int64_t c = 0; c < columns; ++c) {
    std::array<char, 256> column{};
    const double* values = nullptr;
    check(gasjet_exact_name(handle, c, column.data(), column.size()));
    check(gasjet_exact_column(handle, c, &values));
    all[column.data()] = view(values, rows, owner);
  }
  return all;
}

std::string catalogue() {
  int64_t needed = 0;
  gasjet_exact_catalogue(nullptr, 0, &needed);
  std::string text(static_cast<std::size_t>(needed), '\0');
  check(gasjet_exact_catalogue(text.data(), needed, &needed));
  text.pop_back();
  return text;
}

}  // namespace

PYBIND11_MODULE(_exact, m) {
  py::class_<Table>(m, "Table");
  def(m, "evaluate", &evaluate, {"name", "parameters", "times"});
  m.def("catalogue", &catalogue);
}
