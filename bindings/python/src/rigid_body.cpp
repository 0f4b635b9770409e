// SPDX-License-Identifier: Apache-2.0
// A rigid body on a rail, or free, and what a head feels.
#include "module.hpp"

namespace {

void copy_springs(const Points& from, bool one_sided, gasjet_rail_spring*& to) {
  for (int64_t i = 0; i < from.count(); ++i) {
    const double* row = from.data() + i * from.stride[0];
    *to++ = {row[0], row[from.stride[1]], row[2 * from.stride[1]], one_sided};
  }
}

gasjet_rigid_body_model rigid_body_model(bool on_rail, double mass, const Vector& centre,
                                         const Vector& x_axis, const Vector& y_axis, const Vector& z_axis,
                                         const Vector& velocity, const Vector& angular_velocity,
                                         const py::object& inertia, const Vector& gravity,
                                         const Vector& direction, const py::object& springs,
                                         const py::object& stops) {
  gasjet_rigid_body_model model{};
  model.motion = on_rail ? GASJET_ON_RAIL : GASJET_FREE_BODY;
  model.mass = mass;
  copy(centre, model.centre);
  copy(x_axis, model.axes);
  copy(y_axis, model.axes + 3);
  copy(z_axis, model.axes + 6);
  copy(velocity, model.velocity);
  copy(angular_velocity, model.angular_velocity);
  copy(gravity, model.gravity);
  copy(direction, model.direction);
  const Points rows = points(inertia, "inertia");
  if (rows.count() != 3) wrong_type("inertia", "has other rows, allowed: the shape (3, 3)");
  for (int64_t i = 0; i < 9; ++i)
    model.inertia[i] = rows.data()[i % 3 * rows.stride[0] + i / 3 * rows.stride[1]];
  const Points both = points(springs, "springs"), one = points(stops, "stops");
  if (both.count() + one.count() > static_cast<int64_t>(std::size(model.springs)))
    wrong_type("springs", "are " + std::to_string(both.count() + one.count()) +
                              " with the stops, allowed: " + std::to_string(std::size(model.springs)));
  gasjet_rail_spring* next = model.springs;
  copy_springs(both, false, next);
  copy_springs(one, true, next);
  return model;
}

gasjet_rigid_body_state state_of(const Vector& centre, const Vector& x_axis, const Vector& y_axis,
                                 const Vector& z_axis, const Vector& velocity,
                                 const Vector& angular_momentum) {
  gasjet_rigid_body_state state;
  copy(centre, state.centre);
  copy(x_axis, state.axes);
  copy(y_axis, state.axes + 3);
  copy(z_axis, state.axes + 6);
  copy(velocity, state.velocity);
  copy(angular_momentum, state.angular_momentum);
  return state;
}

/// Centre, axes as columns, velocity, angular momentum.
py::tuple arrays_of(const gasjet_rigid_body_state& state) {
  py::array_t<double> axes({py::ssize_t{3}, py::ssize_t{3}});
  for (py::ssize_t i = 0; i < 9; ++i) axes.mutable_at(i % 3, i / 3) = state.axes[i];
  return py::make_tuple(array_of(state.centre), axes, array_of(state.velocity),
                        array_of(state.angular_momentum));
}

py::tuple rigid_body_start(const gasjet_rigid_body_model& model) {
  gasjet_rigid_body_state state;
  check(gasjet_rigid_body_start(&model, &state));
  return arrays_of(state);
}

py::dict rigid_body_evaluate(const gasjet_rigid_body_model& model, const Vector& centre, const Vector& x_axis,
                             const Vector& y_axis, const Vector& z_axis, const Vector& velocity,
                             const Vector& angular_momentum) {
  const auto state = state_of(centre, x_axis, y_axis, z_axis, velocity, angular_momentum);
  gasjet_rigid_body_point p;
  check(gasjet_rigid_body_evaluate(&model, &state, &p));
  py::dict all;
  all["displacement_m"] = p.displacement;
  all["speed_m_s"] = p.speed;
  all["angular_velocity_rad_s"] = array_of(p.angular_velocity);
  all["own_force_N"] = array_of(p.own_force);
  all["gravity_energy_J"] = p.gravity_energy;
  all["spring_energy_J"] = p.spring_energy;
  all["kinetic_energy_J"] = p.kinetic_energy;
  return all;
}

py::tuple rigid_body_advance(const gasjet_rigid_body_model& model, const Vector& force, const Vector& couple,
                             double dt_before, double dt_after, const Vector& centre, const Vector& x_axis,
                             const Vector& y_axis, const Vector& z_axis, const Vector& velocity,
                             const Vector& angular_momentum) {
  auto state = state_of(centre, x_axis, y_axis, z_axis, velocity, angular_momentum);
  gasjet_rigid_body_kick k;
  check(gasjet_rigid_body_advance(&model, force.data(), couple.data(), dt_before, dt_after, &state, &k));
  py::dict all;
  all["velocity_m_s"] = array_of(k.velocity);
  all["acceleration_m_s2"] = array_of(k.acceleration);
  all["kinetic_energy_J"] = k.kinetic_energy;
  all["kinetic_before_J"] = k.kinetic_before;
  all["kinetic_after_J"] = k.kinetic_after;
  all["load_work_J"] = k.load_work;
  all["damping_loss_J"] = k.damping_loss;
  all["work_J"] = k.work;
  return py::make_tuple(arrays_of(state), all);
}

py::tuple rigid_body_limits(const gasjet_rigid_body_model& model, double reach, double contact_force) {
  double mass = 0.0, frequency = 0.0;
  check(gasjet_rigid_body_limits(&model, reach, contact_force, &mass, &frequency));
  return py::make_tuple(mass, frequency);
}

double head_injury_criterion(const Numbers& time, const py::object& acceleration, double window) {
  const Points a = points(acceleration, "acceleration");
  if (time.size() != a.count())
    wrong_type("time", "has " + std::to_string(time.size()) + " numbers, allowed: one per acceleration, " +
                           std::to_string(a.count()));
  double criterion = 0.0;
  unlocked([&] {
    return gasjet_head_injury_criterion(time.data(), a.data(), a.count(), a.stride.data(), window,
                                        &criterion);
  });
  return criterion;
}

}  // namespace

void add_rigid_body(py::module_& m) {
  py::class_<gasjet_rigid_body_model>(m, "RigidBodyModel");
  def(m, "rigid_body_model", &rigid_body_model,
      {"rail", "mass", "centre", "axes", "axes", "axes", "velocity", "angular_velocity", "inertia", "gravity",
       "rail", "springs", "stops"});
  def(m, "rigid_body_start", &rigid_body_start, {"model"});
  def(m, "rigid_body_evaluate", &rigid_body_evaluate,
      {"model", "centre", "axes", "axes", "axes", "velocity", "angular_momentum"});
  def(m, "rigid_body_advance", &rigid_body_advance,
      {"model", "force", "couple", "dt_before", "step", "centre", "axes", "axes", "axes", "velocity",
       "angular_momentum"});
  def(m, "rigid_body_limits", &rigid_body_limits, {"model", "reach", "contact_force"});
  def(m, "head_injury_criterion", &head_injury_criterion, {"time", "acceleration", "window"});
}
