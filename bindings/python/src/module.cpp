// SPDX-License-Identifier: Apache-2.0
// gasjet._gasjet: gasjet.h for Python. Names, defaults and docstrings are in the package beside it.
#include <gasjet.h>

#include <exception>
#include <limits>
#include <optional>

#include "convert.hpp"

namespace {

using Points = Rows<double>;
using Triangles = Rows<int32_t>;
using Indices = py::array_t<int32_t, py::array::c_style | py::array::forcecast>;
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
void check(int status) {
  if (status != GASJET_OK) raise(status, gasjet_last_error());
}

/// A handle that Python owns.
struct Handle {
  explicit Handle(gasjet_handle given) : value(given) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { gasjet_free(value); }
  gasjet_handle value;
};
using Owner = std::unique_ptr<Handle>;

Points points(const py::object& given, const char* argument) {
  return {given, argument, "float64"};
}
Triangles triangles(const py::object& given) {
  return {given, "triangles", "int32"};
}

void copy(const Vector& from, double* to) {
  std::copy(from.begin(), from.end(), to);
}

template <class T>
py::array_t<T> vectors(int64_t count) {
  return py::array_t<T>({static_cast<py::ssize_t>(count), py::ssize_t{3}});
}

// ---- gas ----

Owner gas(const std::string& composition, double constant_cp_at) {
  gasjet_handle handle = 0;
  check(gasjet_gas_create(composition.c_str(), constant_cp_at, &handle));
  return std::make_unique<Handle>(handle);
}

Owner ideal_gas(double gas_constant, double cp) {
  gasjet_handle handle = 0;
  check(gasjet_gas_create_ideal(gas_constant, cp, &handle));
  return std::make_unique<Handle>(handle);
}

py::dict gas_values(const Handle& gas, double temperature) {
  gasjet_gas_values v;
  check(gasjet_gas_evaluate(gas.value, temperature, &v));
  py::dict all;
  all["gas_constant_J_kgK"] = v.gas_constant;
  all["cp_J_kgK"] = v.cp;
  all["cv_J_kgK"] = v.cv;
  all["gamma"] = v.gamma;
  all["enthalpy_J_kg"] = v.enthalpy;
  all["internal_energy_J_kg"] = v.internal_energy;
  all["speed_of_sound_m_s"] = v.speed_of_sound;
  return all;
}

double gas_temperature(const Handle& gas, double internal_energy) {
  double temperature = 0.0;
  check(gasjet_gas_temperature(gas.value, internal_energy, &temperature));
  return temperature;
}

double gas_entropy(const Handle& gas, double temperature, double pressure) {
  double entropy = 0.0;
  check(gasjet_gas_entropy(gas.value, temperature, pressure, &entropy));
  return entropy;
}

double orifice(double area, double pressure, double temperature, double gas_constant, double cp,
               double ambient) {
  double flow = 0.0;
  check(gasjet_orifice(area, pressure, temperature, gas_constant, cp, ambient, &flow));
  return flow;
}

double fabric(double leak_area, double density, double overpressure) {
  double flow = 0.0;
  check(gasjet_fabric(leak_area, density, overpressure, &flow));
  return flow;
}

Owner tank(const Handle& gas, double pressure, double temperature, double volume, double ambient,
           double tolerance) {
  gasjet_handle handle = 0;
  check(gasjet_tank_create(gas.value, pressure, temperature, volume, ambient, tolerance, &handle));
  return std::make_unique<Handle>(handle);
}

void add_inflow(const Handle& tank, const Handle& gas, const Numbers& time, const Numbers& mass_flow,
                const Numbers& temperature, double start_time) {
  if (mass_flow.size() != time.size() || temperature.size() != time.size())
    wrong_type("mass_flow, temperature",
               "have " + std::to_string(mass_flow.size()) + " and " + std::to_string(temperature.size()) +
                   " numbers, allowed: as many as time, " + std::to_string(time.size()));
  check(gasjet_tank_add_inflow(tank.value, gas.value, time.size(), time.data(), mass_flow.data(),
                               temperature.data(), start_time));
}

py::dict tank_state(const Handle& tank) {
  gasjet_tank_state s;
  check(gasjet_tank_read(tank.value, &s));
  py::dict all;
  all["time_s"] = s.time;
  all["pressure_Pa"] = s.pressure;
  all["temperature_K"] = s.temperature;
  all["volume_m3"] = s.volume;
  all["gas_mass_kg"] = s.mass;
  all["internal_energy_J"] = s.internal_energy;
  all["density_kg_m3"] = s.density;
  all["gamma"] = s.gamma;
  all["cp_J_kgK"] = s.cp;
  all["gas_constant_J_kgK"] = s.gas_constant;
  all["inflow_kg_s"] = s.inflow;
  all["vent_outflow_kg_s"] = s.vent_outflow;
  all["fabric_outflow_kg_s"] = s.fabric_outflow;
  return all;
}

py::dict tank_balance(const Handle& tank) {
  gasjet_tank_balance b;
  check(gasjet_tank_read_balance(tank.value, &b));
  py::dict all;
  all["mass_in_kg"] = b.mass_in;
  all["enthalpy_in_J"] = b.enthalpy_in;
  all["vent_mass_out_kg"] = b.vent_mass_out;
  all["fabric_mass_out_kg"] = b.fabric_mass_out;
  all["enthalpy_out_J"] = b.enthalpy_out;
  all["work_J"] = b.work;
  all["mass_residual_kg"] = b.mass_residual;
  all["energy_residual_J"] = b.energy_residual;
  all["substeps"] = b.substeps;
  return all;
}

// ---- jet ----

py::dict outlet(int law, double area, double mass_flow, double temperature, double cp, double gas_constant,
                double bag_pressure) {
  gasjet_outlet_state s;
  check(gasjet_outlet(law, area, mass_flow, temperature, cp, gas_constant, bag_pressure, &s));
  py::dict all;
  all["velocity_m_s"] = s.velocity;
  all["density_kg_m3"] = s.density;
  all["pressure_Pa"] = s.pressure;
  all["temperature_K"] = s.temperature;
  return all;
}

gasjet_jet_model jet_model(const Vector& centre, const Vector& axis, double radius, double short_side,
                           double long_side, const Vector& long_direction, double decay_coefficient,
                           double cone_initial_width, double cone_half_angle, double restitution,
                           double cut_off, bool radial) {
  gasjet_jet_model model;
  check(gasjet_jet_defaults(&model));
  copy(centre, model.centre);
  copy(axis, model.axis);
  copy(long_direction, model.long_direction);
  model.radius = radius;
  model.short_side = short_side;
  model.long_side = long_side;
  model.decay_coefficient = decay_coefficient;
  model.cone_initial_width = cone_initial_width;
  model.cone_half_angle = cone_half_angle;
  model.restitution = restitution;
  model.cut_off = cut_off;
  model.radial = radial ? 1 : 0;
  return model;
}

py::array_t<double> jet_velocity(const gasjet_jet_model& model, const py::object& at) {
  const Points where = points(at, "points");
  auto velocity = vectors<double>(where.count());
  double* to = velocity.mutable_data();
  unlocked([&] {
    return gasjet_jet_velocity(&model, where.data(), where.count(), where.stride.data(), to,
                               3 * where.count());
  });
  return velocity;
}

Owner jet(const gasjet_jet_model& model, const py::object& elements, int64_t node_count,
          const Indices& null_elements, const Indices& attachment) {
  const Triangles t = triangles(elements);
  gasjet_handle handle = 0;
  check(gasjet_jet_create(&model, t.data(), t.count(), t.stride.data(), node_count, null_elements.data(),
                          null_elements.size(), attachment.data(), attachment.size(), &handle));
  return std::make_unique<Handle>(handle);
}

py::dict counters_of(const gasjet_visibility& seen) {
  py::dict all;
  all["candidates"] = seen.candidates;
  all["lit"] = seen.lit;
  all["hidden"] = seen.hidden;
  all["facing_away"] = seen.facing_away;
  return all;
}

py::tuple jet_pressure(const Handle& jet, int64_t elements, const py::object& nodes, double velocity,
                       double density, bool occlusion, double displacement_bound) {
  const Points x = points(nodes, "nodes");
  py::array_t<double> pressure(elements), force(3);
  double *p = pressure.mutable_data(), *f = force.mutable_data();
  gasjet_visibility seen;
  unlocked([&] {
    return gasjet_jet_pressure(jet.value, x.data(), x.count(), x.stride.data(), velocity, density,
                               occlusion ? 1 : 0, displacement_bound, p, elements, f, &seen);
  });
  return py::make_tuple(pressure, force, counters_of(seen));
}

Owner surface(const py::object& elements, int64_t node_count, const Indices& null_elements,
              const Indices& attachment) {
  const Triangles t = triangles(elements);
  gasjet_handle handle = 0;
  unlocked([&] {
    return gasjet_surface_create(t.data(), t.count(), t.stride.data(), node_count, null_elements.data(),
                                 null_elements.size(), attachment.data(), attachment.size(), &handle);
  });
  return std::make_unique<Handle>(handle);
}

py::array_t<bool> surface_visible(const Handle& surface, int64_t elements, const py::object& nodes,
                                  const Vector& centre, const Vector& axis, const Vector& long_direction,
                                  double half_long, const std::optional<Indices>& candidates,
                                  double displacement_bound) {
  const Points x = points(nodes, "nodes");
  gasjet_source source;
  copy(centre, source.centre);
  copy(axis, source.axis);
  copy(long_direction, source.long_direction);
  source.half_long = half_long;
  const int64_t count = candidates ? candidates->size() : elements;
  py::array_t<bool> lit(count);
  static_assert(sizeof(bool) == sizeof(uint8_t));
  auto* to = reinterpret_cast<uint8_t*>(lit.mutable_data());
  const int32_t* some = candidates ? candidates->data() : nullptr;
  unlocked([&] {
    return gasjet_surface_visible(surface.value, x.data(), x.count(), x.stride.data(), &source, some,
                                  candidates ? count : 0, displacement_bound, to, count, nullptr);
  });
  return lit;
}

// ---- membrane ----

Owner membrane(const py::object& reference, const py::object& elements, double thickness, double density,
               double young_modulus, double poisson, bool wrinkles, const Indices& null_elements,
               const Indices& fixed_nodes) {
  const Points x = points(reference, "reference");
  const Triangles t = triangles(elements);
  const gasjet_fabric_model fabric{thickness, density, young_modulus, poisson, wrinkles ? 1 : 0};
  gasjet_handle handle = 0;
  check(gasjet_membrane_create(x.data(), x.count(), x.stride.data(), t.data(), t.count(), t.stride.data(),
                               &fabric, null_elements.data(), null_elements.size(), fixed_nodes.data(),
                               fixed_nodes.size(), &handle));
  return std::make_unique<Handle>(handle);
}

py::array_t<double> membrane_masses(const Handle& membrane, int64_t nodes) {
  py::array_t<double> mass(nodes);
  check(gasjet_membrane_masses(membrane.value, mass.mutable_data(), nodes));
  return mass;
}

py::dict membrane_evaluate(const Handle& membrane, const py::object& nodes, double gamma, double pressure) {
  const Points x = points(nodes, "nodes");
  auto force = vectors<double>(x.count()), gradient = vectors<double>(x.count());
  double *f = force.mutable_data(), *g = gradient.mutable_data();
  gasjet_membrane_sums s;
  unlocked([&] {
    return gasjet_membrane_evaluate(membrane.value, x.data(), x.count(), x.stride.data(), gamma, pressure, f,
                                    g, 3 * x.count(), &s);
  });
  py::dict all;
  all["force_N"] = force;
  all["gradient_m2"] = gradient;
  all["volume_m3"] = s.volume;
  all["area_m2"] = s.area;
  all["mass_kg"] = s.mass;
  all["strain_energy_J"] = s.strain_energy;
  all["critical_step_s"] = s.critical_step;
  return all;
}

// ---- runs ----

/// What a run calls: Python's signals first, then the user's function. Its exception stops the run.
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

/// Every column of a table by name; views into the run.
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

/// status, message, history, energy, summary; with a run that left its domain or was stopped what it has.
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
  const py::object owner = py::cast(std::make_unique<Handle>(handle));
  if (watcher.raised) {
    watcher.raised->restore();
    throw py::error_already_set();
  }
  return py::make_tuple(status, message, table(owner, handle, GASJET_HISTORY),
                        table(owner, handle, GASJET_ENERGY), summary(handle));
}

std::string compare(const std::string& mine, const std::string& reference,
                    const std::optional<std::string>& map, double tolerance) {
  const char* names = map ? map->c_str() : nullptr;
  int verdict = 0;
  std::string text(1 << 16, '\0');
  int64_t needed = 0;
  int status = GASJET_OK;
  for (int i = 0; i < 2; ++i) {
    status = gasjet_compare(mine.c_str(), reference.c_str(), names, tolerance, &verdict, text.data(),
                            static_cast<int64_t>(text.size()), &needed);
    if (status == GASJET_OK || needed <= static_cast<int64_t>(text.size())) break;
    text.resize(static_cast<std::size_t>(needed));
  }
  check(status);
  text.resize(static_cast<std::size_t>(needed) - 1);
  return text;
}

}  // namespace

PYBIND11_MODULE(_gasjet, m) {
  py::class_<Handle>(m, "Handle");
  py::class_<gasjet_jet_model>(m, "JetModel");
  m.def("version", &gasjet_version);
  m.def("gas", &gas);
  m.def("ideal_gas", &ideal_gas);
  m.def("gas_values", &gas_values);
  m.def("gas_temperature", &gas_temperature);
  m.def("gas_entropy", &gas_entropy);
  m.def("orifice", &orifice);
  m.def("fabric", &fabric);
  m.def("tank", &tank);
  m.def("tank_add_inflow", &add_inflow);
  m.def("tank_add_vent", [](const Handle& tank, double cd, double area, double at) {
    check(gasjet_tank_add_vent(tank.value, cd, area, at));
  });
  m.def("tank_add_fabric",
        [](const Handle& tank, double area) { check(gasjet_tank_add_fabric(tank.value, area)); });
  m.def("tank_advance", [](const Handle& tank, double time, double volume) {
    unlocked([&] { return gasjet_tank_advance(tank.value, time, volume); });
  });
  m.def("tank_state", &tank_state);
  m.def("tank_balance", &tank_balance);
  m.def("outlet", &outlet);
  m.def("jet_model", &jet_model);
  m.def("jet_velocity", &jet_velocity);
  m.def("jet", &jet);
  m.def("jet_pressure", &jet_pressure);
  m.def("surface", &surface);
  m.def("surface_visible", &surface_visible);
  m.def("membrane", &membrane);
  m.def("membrane_masses", &membrane_masses);
  m.def("membrane_evaluate", &membrane_evaluate);
  m.def("run", &run);
  m.def("compare", &compare);
}
