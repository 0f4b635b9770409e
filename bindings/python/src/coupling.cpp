// SPDX-License-Identifier: Apache-2.0
// Contacts and pendulum.
#include "module.hpp"

namespace {

gasjet_pendulum_model pendulum_model(const Vector& pivot, const Vector& axis, const Vector& rest_direction,
                                     double mass, double inertia_cg, double cg_distance,
                                     double impactor_distance, double impactor_radius,
                                     const Vector& gravity) {
  gasjet_pendulum_model model;
  copy(pivot, model.pivot);
  copy(axis, model.axis);
  copy(rest_direction, model.rest_direction);
  copy(gravity, model.gravity);
  model.mass = mass;
  model.inertia_cg = inertia_cg;
  model.cg_distance = cg_distance;
  model.impactor_distance = impactor_distance;
  model.impactor_radius = impactor_radius;
  return model;
}

py::dict pendulum_evaluate(const gasjet_pendulum_model& model, double angle, double angular_velocity) {
  gasjet_pendulum_point p;
  check(gasjet_pendulum_evaluate(&model, angle, angular_velocity, &p));
  py::dict all;
  all["impactor_centre_m"] = array_of(p.impactor_centre);
  all["impactor_velocity_m_s"] = array_of(p.impactor_velocity);
  all["cg_position_m"] = array_of(p.cg_position);
  all["gravity_moment_Nm"] = p.gravity_moment;
  all["potential_energy_J"] = p.potential_energy;
  all["kinetic_energy_J"] = p.kinetic_energy;
  all["axis_inertia_kg_m2"] = p.axis_inertia;
  all["effective_mass_kg"] = p.effective_mass;
  return all;
}

double pendulum_moment(const gasjet_pendulum_model& model, const Vector& force, const Vector& point) {
  double moment = 0.0;
  check(gasjet_pendulum_moment(&model, force.data(), point.data(), &moment));
  return moment;
}

py::tuple pendulum_advance(const gasjet_pendulum_model& model, double moment, double dt_before,
                           double dt_after, double angle, double angular_velocity) {
  check(gasjet_pendulum_advance(&model, moment, dt_before, dt_after, &angle, &angular_velocity));
  return py::make_tuple(angle, angular_velocity);
}

void require_one_per_node(const Numbers& masses, const Points& x) {
  if (masses.size() != x.count())
    wrong_type("masses", "are " + std::to_string(masses.size()) + " numbers, allowed: one per node, " +
                             std::to_string(x.count()));
}

gasjet_impactor impactor_of(std::int64_t shape, double radius, const Vector& half_axes, double half_length,
                            double rim_radius) {
  gasjet_impactor impactor{shape, {radius, shape == GASJET_CYLINDER ? half_length : rim_radius, 0.0}};
  if (shape == GASJET_ELLIPSOID) copy(half_axes, impactor.dimensions);
  return impactor;
}

double impactor_reach(std::int64_t shape, double radius, const Vector& half_axes, double half_length,
                      double rim_radius) {
  const auto impactor = impactor_of(shape, radius, half_axes, half_length, rim_radius);
  double reach = 0.0;
  check(gasjet_impactor_reach(&impactor, &reach));
  return reach;
}

Owner contact(const py::object& reference, const py::object& elements, const Numbers& masses,
              double effective_mass, std::int64_t shape, double radius, const Vector& half_axes,
              double half_length, double rim_radius, double stiffness, double friction) {
  const Points x = points(reference, "reference");
  const Triangles t = triangles(elements);
  require_one_per_node(masses, x);
  const auto impactor = impactor_of(shape, radius, half_axes, half_length, rim_radius);
  gasjet_handle handle = 0;
  unlocked([&] {
    return gasjet_contact_create_body(x.data(), x.count(), x.stride.data(), t.data(), t.count(),
                                      t.stride.data(), masses.data(), effective_mass, &impactor, stiffness,
                                      friction, &handle);
  });
  return std::make_unique<Handle>(handle);
}

py::dict contact_evaluate(const Handle& contact, const py::object& nodes, const Vector& centre,
                          const Vector& x_axis, const Vector& y_axis, const Vector& z_axis,
                          const Vector& turn) {
  double axes[9];
  copy(x_axis, axes);
  copy(y_axis, axes + 3);
  copy(z_axis, axes + 6);
  const Points x = points(nodes, "nodes");
  auto force = vectors<double>(x.count());
  double* f = force.mutable_data();
  std::fill_n(f, 3 * x.count(), 0.0);  // the library adds to it
  gasjet_contact_sums s;
  unlocked([&] {
    return gasjet_contact_evaluate_body(contact.value, x.data(), x.count(), x.stride.data(), centre.data(),
                                        axes, turn.data(), f, 3 * x.count(), &s);
  });
  py::dict all;
  all["node_force_N"] = force;
  all["force_N"] = array_of(s.force);
  all["couple_Nm"] = array_of(s.couple);
  all["energy_J"] = s.energy;
  all["friction_loss_J"] = s.friction_loss;
  all["area_m2"] = s.area;
  all["penetration_m"] = s.penetration;
  all["frequency_1_s2"] = s.frequency;
  all["deepest_element"] = s.deepest_element;
  return all;
}

Owner skin_contact(const py::object& reference, const py::object& elements, const Numbers& masses,
                   double thickness, double stiffness, double friction) {
  const Points x = points(reference, "reference");
  const Triangles t = triangles(elements);
  require_one_per_node(masses, x);
  gasjet_handle handle = 0;
  unlocked([&] {
    return gasjet_skin_contact_create(x.data(), x.count(), x.stride.data(), t.data(), t.count(),
                                      t.stride.data(), masses.data(), thickness, stiffness, friction,
                                      &handle);
  });
  return std::make_unique<Handle>(handle);
}

/// Node numbers up to the first -1.
py::tuple nodes_of(const int64_t* begin, const int64_t* end) {
  return py::tuple(py::cast(std::vector<int64_t>(begin, std::find(begin, end, -1))));
}

py::dict skin_contact_evaluate(const Handle& skin_contact, const py::object& nodes) {
  const Points x = points(nodes, "nodes");
  auto force = vectors<double>(x.count());
  double* f = force.mutable_data();
  std::fill_n(f, 3 * x.count(), 0.0);  // the library adds to it
  gasjet_skin_contact_sums s;
  unlocked([&] {
    return gasjet_skin_contact_evaluate(skin_contact.value, x.data(), x.count(), x.stride.data(), f,
                                        3 * x.count(), &s);
  });
  py::dict all;
  all["node_force_N"] = force;
  all["energy_J"] = s.energy;
  all["friction_loss_J"] = s.friction_loss;
  all["frequency_1_s2"] = s.frequency;
  all["gap_m"] = s.gap;
  all["approach"] = s.approach;
  all["contacts"] = s.contacts;
  all["limited_nodes"] = s.limited_nodes;
  all["first_nodes"] = nodes_of(std::begin(s.first_nodes), std::end(s.first_nodes));
  all["second_nodes"] = nodes_of(std::begin(s.second_nodes), std::end(s.second_nodes));
  return all;
}

void skin_contact_restart(const Handle& skin_contact) {
  check(gasjet_skin_contact_restart(skin_contact.value));
}

double default_skin_stiffness(double share, double other_frequency, double surface_density) {
  double stiffness = 0.0;
  check(gasjet_default_skin_stiffness(share, other_frequency, surface_density, &stiffness));
  return stiffness;
}

}  // namespace

void add_coupling(py::module_& m) {
  py::class_<gasjet_pendulum_model>(m, "PendulumModel");
  def(m, "pendulum_model", &pendulum_model,
      {"pivot", "axis", "rest_direction", "mass", "inertia_cg", "cg_distance", "impactor_distance",
       "impactor_radius", "gravity"});
  def(m, "pendulum_evaluate", &pendulum_evaluate, {"model", "angle", "angular_velocity"});
  def(m, "pendulum_moment", &pendulum_moment, {"model", "force", "point"});
  def(m, "pendulum_advance", &pendulum_advance,
      {"model", "moment", "dt_before", "dt_after", "angle", "angular_velocity"});
  def(m, "contact", &contact,
      {"reference", "triangles", "masses", "effective_mass", "shape", "radius", "half_axes", "half_length",
       "rim_radius", "stiffness", "friction"});
  def(m, "impactor_reach", &impactor_reach, {"shape", "radius", "half_axes", "half_length", "rim_radius"});
  def(m, "contact_evaluate", &contact_evaluate,
      {"contact", "nodes", "centre", "axes", "axes", "axes", "turn"});
  def(m, "skin_contact", &skin_contact,
      {"reference", "triangles", "masses", "thickness", "stiffness", "friction"});
  def(m, "skin_contact_evaluate", &skin_contact_evaluate, {"skin_contact", "nodes"});
  def(m, "skin_contact_restart", &skin_contact_restart, {"skin_contact"});
  def(m, "default_skin_stiffness", &default_skin_stiffness, {"share", "other_frequency", "surface_density"});
}
