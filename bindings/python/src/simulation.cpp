// SPDX-License-Identifier: Apache-2.0
// Simulations.
#include "module.hpp"
#include "watcher.hpp"

namespace sims {
namespace {

Owner create(const std::string& file, const std::optional<std::string>& text, const std::string& overrides,
             const std::optional<std::string>& out, int threads) {
  gasjet_handle handle = 0;
  unlocked([&] {
    return gasjet_sim_create(file.c_str(), text ? text->c_str() : nullptr, overrides.c_str(),
                             out ? out->c_str() : nullptr, threads, &handle);
  });
  return std::make_unique<Handle>(handle);
}

Owner clone(const Handle& sim) {
  gasjet_handle handle = 0;
  unlocked([&] { return gasjet_sim_clone(sim.value, &handle); });
  return std::make_unique<Handle>(handle);
}

void assign(const Handle& sim, const Handle& from) {
  unlocked([&] { return gasjet_sim_assign(sim.value, from.value); });
}
void reset(const Handle& sim) {
  unlocked([&] { return gasjet_sim_reset(sim.value); });
}
py::bytes save(const Handle& sim) {
  int64_t needed = 0;
  check(gasjet_sim_save(sim.value, nullptr, 0, &needed));
  std::string bytes(static_cast<std::size_t>(needed), '\0');
  unlocked(
      [&] { return gasjet_sim_save(sim.value, reinterpret_cast<uint8_t*>(bytes.data()), needed, &needed); });
  return py::bytes(bytes);
}
void restore(const Handle& sim, const py::object& given) {
  if (!py::isinstance<py::bytes>(given))
    wrong_type("state", "is " + shown(given) + ", allowed: bytes from save()");
  const auto bytes = given.cast<std::string>();
  unlocked([&] {
    return gasjet_sim_restore(sim.value, reinterpret_cast<const uint8_t*>(bytes.data()),
                              static_cast<int64_t>(bytes.size()));
  });
}
void finish(const Handle& sim) {
  unlocked([&] { return gasjet_sim_finish(sim.value); });
}
/// Many steps in parts, with signals looked at in between.
void step(const Handle& sim, int64_t count) {
  constexpr int64_t part = 100;
  if (count <= 1) return check(gasjet_sim_step(sim.value, count));  // as short as giving up the lock
  for (int64_t done = 0; done < count; done += part) {
    double time = 0.0;
    int64_t steps = 0;
    int ended = 0;
    if (done > 0) check(gasjet_sim_time(sim.value, &time, &steps, &ended));
    if (ended != 0) return;
    unlocked([&] { return gasjet_sim_step(sim.value, std::min(part, count - done)); });
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

/// Steps with signals and the user's function looked at in between.
void advance(const Handle& sim, double time, bool exactly, const py::object& progress) {
  Watcher watcher{progress, {}};
  int status = GASJET_OK;
  std::string message;
  {
    const py::gil_scoped_release release;
    status = gasjet_sim_advance(sim.value, time, exactly ? 1 : 0, Watcher::call, &watcher);
    message = gasjet_last_error();
  }
  if (watcher.raised) throw std::move(*watcher.raised);
  raise(status, message.c_str());
}

py::tuple time_of(const Handle& sim) {
  double time = 0.0;
  int64_t steps = 0;
  int ended = 0;
  check(gasjet_sim_time(sim.value, &time, &steps, &ended));
  return py::make_tuple(time, steps, ended != 0);
}

py::tuple evaluate(const Handle& sim) {
  double step = 0.0, limit = 0.0;
  check(gasjet_sim_evaluate(sim.value, &step, &limit));
  return py::make_tuple(step, limit);
}

py::tuple results(const Handle& sim) {
  gasjet_handle handle = 0;
  unlocked([&] { return gasjet_sim_results(sim.value, &handle); });
  return results_of(handle);
}

/// Rows of numbers that belong to the simulation.
py::array rows_of(const double* values, int64_t rows, int64_t columns, int64_t stride,
                  const py::object& owner, bool writable) {
  constexpr auto size = static_cast<py::ssize_t>(sizeof(double));
  if (values == nullptr || rows == 0) return py::array_t<double>({rows, columns});
  py::array_t<double> array({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)},
                            {static_cast<py::ssize_t>(stride) * size, size}, values, owner);
  if (!writable) array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array array(const py::object& owner, int which) {
  const double* values = nullptr;
  int64_t rows = 0, columns = 0, stride = 0;
  check(gasjet_sim_view(owner.cast<const Handle&>().value, which, &values, &rows, &columns, &stride));
  return rows_of(values, rows, columns, stride, owner, false);
}

py::array own_force(const py::object& owner) {
  double* values = nullptr;
  int64_t rows = 0, stride = 0;
  check(gasjet_sim_own_force(owner.cast<const Handle&>().value, &values, &rows, &stride));
  return rows_of(values, rows, 3, stride, owner, true);
}

template <class T>
py::array fixed(const T* values, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<T> array(std::move(shape), values, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array triangles(const py::object& owner) {
  const int32_t* values = nullptr;
  int64_t count = 0;
  check(gasjet_sim_triangles(owner.cast<const Handle&>().value, &values, &count));
  return fixed(values, {static_cast<py::ssize_t>(count), 3}, owner);
}

/// Overpressure, a view; and for each element 1 if a jet lights it.
py::tuple jet(const py::object& owner, int64_t number) {
  const double* overpressure = nullptr;
  const int32_t* candidates = nullptr;
  const uint8_t* lit = nullptr;
  int64_t elements = 0, count = 0;
  check(gasjet_sim_jet(owner.cast<const Handle&>().value, number, &overpressure, &elements, &candidates, &lit,
                       &count));
  py::array_t<bool> mask(elements);
  bool* to = mask.mutable_data();
  std::fill_n(to, elements, false);
  for (int64_t i = 0; i < count; ++i) to[candidates[i]] = lit[i] != 0;
  return py::make_tuple(fixed(overpressure, {static_cast<py::ssize_t>(elements)}, owner), mask);
}

py::dict gas(const Handle& sim) {
  gasjet_tank_state s;
  check(gasjet_sim_gas(sim.value, &s));
  return dict_of(s);
}

py::dict impact(const Handle& sim) {
  gasjet_sim_impact s;
  check(gasjet_sim_read_impact(sim.value, &s));
  const auto vector = [](const double* from) { return py::array_t<double>(3, from); };
  py::dict all;
  all["centre"] = vector(s.centre);
  py::array_t<double> axes({3, 3});
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) axes.mutable_at(c, i) = s.axes[3 * i + c];  // in columns
  all["axes"] = axes;
  all["velocity"] = vector(s.velocity);
  all["angular_velocity"] = vector(s.angular_velocity);
  all["force"] = vector(s.force);
  all["couple"] = vector(s.couple);
  all["energy_J"] = s.energy;
  all["penetration_m"] = s.penetration;
  return all;
}

double value(const Handle& sim, bool energy, const std::string& name) {
  double result = 0.0;
  check(gasjet_sim_value(sim.value, energy ? GASJET_ENERGY : GASJET_HISTORY, name.c_str(), &result));
  return result;
}
double drift(const Handle& sim) {
  double result = 0.0;
  check(gasjet_sim_drift(sim.value, &result));
  return result;
}
void record(const Handle& sim, bool every) {
  check(gasjet_sim_record(sim.value, every ? 1 : 0));
}

void meet_every(const Handle& sim, double interval) {
  check(gasjet_sim_meet_every(sim.value, interval));
}
void set_vent(const Handle& sim, int64_t vent, double area) {
  check(gasjet_sim_set_vent(sim.value, vent, area));
}
void set_sensor(const Handle& sim, const std::string& name, bool on) {
  check(gasjet_sim_set_sensor(sim.value, name.c_str(), on ? 1 : 0));
}
void set_ambient(const Handle& sim, double pressure, double temperature) {
  check(gasjet_sim_set_ambient(sim.value, pressure, temperature));
}
void set_inflow(const Handle& sim, int64_t inflator, double mass_flow, double temperature) {
  check(gasjet_sim_set_inflow(sim.value, inflator, mass_flow, temperature));
}
void set_outlet(const Handle& sim, int64_t jet, const Vector& centre, const Vector& axis) {
  check(gasjet_sim_set_outlet(sim.value, jet, centre.data(), axis.data()));
}
void set_gravity(const Handle& sim, const Vector& gravity) {
  check(gasjet_sim_set_gravity(sim.value, gravity.data()));
}
void set_impactor(const Handle& sim, const Vector& centre, const Vector& velocity,
                  const std::optional<std::array<double, 9>>& axes, const Vector& angular_velocity) {
  check(gasjet_sim_set_impactor(sim.value, centre.data(), axes ? axes->data() : nullptr, velocity.data(),
                                angular_velocity.data()));
}

void set_impactor_speed(const Handle& sim, const Vector& velocity, const Vector& angular_velocity) {
  check(gasjet_sim_set_impactor_speed(sim.value, velocity.data(), angular_velocity.data()));
}

}  // namespace
}  // namespace sims

void add_simulation(py::module_& m) {
  def(m, "sim_create", &sims::create, {"case", "text", "set", "out", "threads"});
  def(m, "sim_clone", &sims::clone, {"sim"});
  def(m, "sim_assign", &sims::assign, {"sim", "other"});
  def(m, "sim_reset", &sims::reset, {"sim"});
  def(m, "sim_save", &sims::save, {"sim"});
  def(m, "sim_restore", &sims::restore, {"sim", "state"});
  def(m, "sim_finish", &sims::finish, {"sim"});
  def(m, "sim_step", &sims::step, {"sim", "count"});
  def(m, "sim_advance", &sims::advance, {"sim", "time", "exactly", "progress"});
  def(m, "sim_time", &sims::time_of, {"sim"});
  def(m, "sim_evaluate", &sims::evaluate, {"sim"});
  def(m, "sim_results", &sims::results, {"sim"});
  def(m, "sim_array", &sims::array, {"sim", "array"});
  def(m, "sim_own_force", &sims::own_force, {"sim"});
  def(m, "sim_triangles", &sims::triangles, {"sim"});
  def(m, "sim_jet", &sims::jet, {"sim", "jet"});
  def(m, "sim_gas", &sims::gas, {"sim"});
  def(m, "sim_impact", &sims::impact, {"sim"});
  def(m, "sim_value", &sims::value, {"sim", "energy", "name"});
  def(m, "sim_drift", &sims::drift, {"sim"});
  def(m, "sim_record", &sims::record, {"sim", "every"});
  def(m, "sim_meet_every", &sims::meet_every, {"sim", "interval"});
  def(m, "sim_set_vent", &sims::set_vent, {"sim", "vent", "area"});
  def(m, "sim_set_sensor", &sims::set_sensor, {"sim", "name", "on"});
  def(m, "sim_set_ambient", &sims::set_ambient, {"sim", "pressure", "temperature"});
  def(m, "sim_set_inflow", &sims::set_inflow, {"sim", "inflator", "mass_flow", "temperature"});
  def(m, "sim_set_outlet", &sims::set_outlet, {"sim", "jet", "centre", "axis"});
  def(m, "sim_set_gravity", &sims::set_gravity, {"sim", "gravity"});
  def(m, "sim_set_impactor", &sims::set_impactor, {"sim", "centre", "velocity", "axes", "angular_velocity"});
  def(m, "sim_set_impactor_speed", &sims::set_impactor_speed, {"sim", "velocity", "angular_velocity"});
}
