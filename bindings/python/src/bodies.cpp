// SPDX-License-Identifier: Apache-2.0
// Jet, surface and membrane.
#include "module.hpp"

namespace {

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
                       double density, bool occlusion, double displacement_bound, double area_ratio,
                       double reflected, double restitution) {
  const Points x = points(nodes, "nodes");
  py::array_t<double> pressure(elements), force(3);
  double *p = pressure.mutable_data(), *f = force.mutable_data();
  gasjet_visibility seen;
  unlocked([&] {
    const int status = gasjet_jet_expansion(jet.value, area_ratio, reflected, restitution);
    if (status != GASJET_OK) return status;
    return gasjet_jet_pressure(jet.value, x.data(), x.count(), x.stride.data(), velocity, density,
                               occlusion ? 1 : 0, displacement_bound, p, elements, f, &seen);
  });
  return py::make_tuple(pressure, force, counters_of(seen));
}

/// Faults by name, and a description in prose.
py::dict check_surface(const py::object& nodes, const py::object& elements) {
  const Points x = points(nodes, "nodes");
  const Triangles t = triangles(elements);
  gasjet_surface_faults faults;
  std::string text(1 << 16, '\0');
  int64_t needed = 0;
  unlocked([&] {
    const auto ask = [&] {
      return gasjet_surface_check(x.data(), x.count(), x.stride.data(), t.data(), t.count(), t.stride.data(),
                                  &faults, text.data(), static_cast<int64_t>(text.size()), &needed);
    };
    const int status = ask();
    if (needed <= static_cast<int64_t>(text.size())) return status;
    text.resize(static_cast<std::size_t>(needed));
    return ask();
  });
  text.resize(static_cast<std::size_t>(needed) - 1);
  py::dict all;
  all["ok"] = faults.ok != 0;
  all["boundary_edges"] = faults.boundary_edges;
  all["non_manifold_edges"] = faults.non_manifold_edges;
  all["inconsistent_edges"] = faults.inconsistent_edges;
  all["repeated_node_elements"] = faults.repeated_node_elements;
  all["pinched_nodes"] = faults.pinched_nodes;
  all["unused_nodes"] = faults.unused_nodes;
  all["more_components"] = faults.more_components;
  all["inward"] = faults.inward != 0;
  all["flat"] = faults.flat != 0;
  all["findings"] = py::str(text).attr("splitlines")();
  return all;
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

Owner membrane(const py::object& reference, const py::object& elements, double thickness, double density,
               double young_modulus, double poisson, bool wrinkles, int law, const Indices& null_elements,
               const Indices& fixed_nodes) {
  const Points x = points(reference, "reference");
  const Triangles t = triangles(elements);
  const gasjet_fabric_model fabric{thickness, density, young_modulus, poisson, wrinkles ? 1 : 0, law};
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

}  // namespace

void add_bodies(py::module_& m) {
  def(m, "outlet", &outlet,
      {"law", "area", "mass_flow", "temperature", "cp", "gas_constant", "bag_pressure"});
  def(m, "jet_model", &jet_model,
      {"centre", "axis", "radius", "short_side", "long_side", "long_direction", "decay_coefficient",
       "cone_initial_width", "cone_half_angle", "restitution", "cut_off", "radial"});
  def(m, "jet_velocity", &jet_velocity, {"model", "points"});
  def(m, "jet", &jet, {"model", "triangles", "node_count", "null_elements", "attachment_elements"});
  def(m, "jet_pressure", &jet_pressure,
      {"jet", "elements", "nodes", "velocity", "density", "occlusion", "displacement_bound", "area_ratio",
       "reflected", "restitution"});
  def(m, "check_surface", &check_surface, {"nodes", "triangles"});
  def(m, "surface", &surface, {"triangles", "node_count", "null_elements", "attachment_elements"});
  def(m, "surface_visible", &surface_visible,
      {"surface", "elements", "nodes", "centre", "axis", "long_direction", "half_long", "candidates",
       "displacement_bound"});
  def(m, "membrane", &membrane,
      {"reference", "triangles", "thickness", "density", "young_modulus", "poisson", "wrinkles", "law",
       "null_elements", "fixed_nodes"});
  def(m, "membrane_masses", &membrane_masses, {"membrane", "node_count"});
  def(m, "membrane_evaluate", &membrane_evaluate, {"membrane", "nodes", "gamma", "pressure"});
}
