// SPDX-License-Identifier: Apache-2.0
// Whole runs and the comparison.
#include "module.hpp"
#include "watcher.hpp"

namespace {

/// Every column of a table by name, as views into the run.
py::dict table(const py::object& run, gasjet_handle handle, int number) {
  int64_t columns = 0, rows = 0;
  check(gasjet_run_size(handle, number, &columns, &rows));
  py::dict all;
  for (int64_t c = 0; c < columns; ++c) {
    std::array<char, 256> name{};
    const double* values = nullptr;
    check(gasjet_run_name(handle, number, c, name.data(), name.size()));
    check(gasjet_run_column(handle, number, c, &values));
    all[name.data()] = view(values, rows, run);
  }
  return all;
}

std::string summary(gasjet_handle run) {
  int64_t needed = 0;
  gasjet_run_summary(run, nullptr, 0, &needed);
  std::string text(static_cast<std::size_t>(needed), '\0');
  check(gasjet_run_summary(run, text.data(), needed, &needed));
  text.pop_back();
  return text;
}

}  // namespace

py::tuple results_of(gasjet_handle run) {
  const py::object owner = py::cast(std::make_unique<Handle>(run));
  return py::make_tuple(table(owner, run, GASJET_HISTORY), table(owner, run, GASJET_ENERGY), summary(run));
}

namespace {

/// The exception of a call, or None.
py::object exception_of(const std::optional<py::error_already_set>& raised) {
  if (!raised) return py::none();
  if (raised->trace()) PyException_SetTraceback(raised->value().ptr(), raised->trace().ptr());
  return raised->value();
}

/// Returns status, message, history, energy, summary and the watcher's exception. A run that left its domain
/// or was stopped returns its results so far.
py::tuple run(const std::string& file, const std::optional<std::string>& text, const std::string& overrides,
              const std::optional<std::string>& out, int threads, const py::object& progress) {
  Watcher watcher{progress, {}};
  gasjet_handle handle = 0;
  int status = GASJET_OK;
  std::string message;
  {
    const py::gil_scoped_release release;
    status = gasjet_run(file.c_str(), text ? text->c_str() : nullptr, overrides.c_str(),
                        out ? out->c_str() : nullptr, threads, Watcher::call, &watcher, &handle);
    message = gasjet_last_error();
  }
  if (handle == 0) raise(status, message.c_str());
  return py::tuple(py::make_tuple(status, message) + results_of(handle) +
                   py::make_tuple(exception_of(watcher.raised)));
}

std::string compare(const std::string& mine, const std::string& reference,
                    const std::optional<std::string>& map, const std::string& columns, double tolerance) {
  const char* names = map ? map->c_str() : nullptr;
  int verdict = 0;
  std::string text(1 << 16, '\0');
  int64_t needed = 0;
  int status = GASJET_OK;
  for (int i = 0; i < 2; ++i) {
    status = gasjet_compare(mine.c_str(), reference.c_str(), names, columns.c_str(), tolerance, &verdict,
                            text.data(), static_cast<int64_t>(text.size()), &needed);
    if (status == GASJET_OK || needed <= static_cast<int64_t>(text.size())) break;
    text.resize(static_cast<std::size_t>(needed));
  }
  check(status);
  text.resize(static_cast<std::size_t>(needed) - 1);
  return text;
}

}  // namespace

void add_runs(py::module_& m) {
  def(m, "run", &run, {"case", "text", "set", "out", "threads", "progress"});
  def(m, "compare", &compare, {"mine", "reference", "map", "columns", "tolerance"});
}
