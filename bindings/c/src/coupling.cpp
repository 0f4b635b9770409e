// SPDX-License-Identifier: Apache-2.0
#include <gasjet/coupling.h>

#include <algorithm>

#include "arrays.hpp"
#include "coupling/pendulum.hpp"
#include "coupling/skin_contact.hpp"
#include "coupling/sphere_contact.hpp"

using namespace border;

namespace {

coupling::PendulumModel pendulum_of(const gasjet_pendulum_model* pointer) {
  const gasjet_pendulum_model& given = needed(pointer, "model");
  coupling::PendulumParameters parameters;
  parameters.pivot = Eigen::Map<const Eigen::Vector3d>(given.pivot);
  parameters.axis = Eigen::Map<const Eigen::Vector3d>(given.axis);
  parameters.rest_direction = Eigen::Map<const Eigen::Vector3d>(given.rest_direction);
  parameters.mass = given.mass;
  parameters.inertia_cg = given.inertia_cg;
  parameters.cg_distance = given.cg_distance;
  parameters.impactor_distance = given.impactor_distance;
  parameters.impactor_radius = given.impactor_radius;
  parameters.gravity = Eigen::Map<const Eigen::Vector3d>(given.gravity);
  return coupling::PendulumModel(parameters);
}

struct Contact : Object {
  Contact(const Eigen::Matrix3Xi& triangles, const Points& reference, std::span<const double> masses,
          double effective_mass, const coupling::ContactParameters& parameters)
      : model(triangles, reference.view(), masses, effective_mass, parameters), state(model.make_state()) {}
  static constexpr const char* name = "a contact";
  static constexpr bool shared = false;

  coupling::ContactModel model;
  coupling::ContactState state;
};

gasjet_handle contact_of(const double* reference, int64_t node_count, const int64_t* reference_stride,
                         const int32_t* triangles, int64_t triangle_count, const int64_t* triangle_stride,
                         const double* mass, double effective_mass,
                         const coupling::ContactParameters& parameters) {
  const Points points(reference, node_count, reference_stride, "reference");
  const auto elements = triangles_of(triangles, triangle_count, triangle_stride, node_count);
  needed(mass, "mass");
  return keep(std::make_shared<Contact>(
      elements, points, std::span(mass, static_cast<std::size_t>(node_count)), effective_mass, parameters));
}

coupling::Impactor shape_of(const gasjet_impactor& given) {
  const double* d = given.dimensions;
  switch (given.shape) {
    case GASJET_SPHERE:
      return coupling::Sphere{d[0]};
    case GASJET_ELLIPSOID:
      return coupling::Ellipsoid{{d[0], d[1], d[2]}};
    case GASJET_CYLINDER:
      return coupling::Cylinder{d[0], d[1]};
    case GASJET_DISC:
      return coupling::Disc{d[0], d[1]};
    default:
      refuse("impactor.shape", "is " + std::to_string(given.shape) + ", allowed: a gasjet_shape, 0 to 3");
  }
}

struct SkinContact : Object {
  SkinContact(const Eigen::Matrix3Xi& triangles, const Points& reference, std::span<const double> masses,
              const coupling::SkinContactParameters& parameters)
      : model(triangles, reference.view(), masses, parameters), state(model.make_state()) {}
  static constexpr const char* name = "a contact of a skin with itself";
  static constexpr bool shared = false;

  coupling::SkinContactModel model;
  coupling::SkinContactState state;
  bool spoiled = false;  // an evaluation threw, so the state is of no level
};

}  // namespace

int gasjet_pendulum_evaluate(const gasjet_pendulum_model* model, double angle, double angular_velocity,
                             gasjet_pendulum_point* point) {
  return call([&] {
    const auto pendulum = pendulum_of(model);
    number(angle, "angle");
    number(angular_velocity, "angular_velocity");
    gasjet_pendulum_point out;
    write_vector(pendulum.impactor_centre(angle), out.impactor_centre);
    write_vector(pendulum.impactor_velocity(angle, angular_velocity), out.impactor_velocity);
    write_vector(pendulum.cg_position(angle), out.cg_position);
    out.gravity_moment = pendulum.gravity_moment(angle);
    out.potential_energy = pendulum.potential_energy(angle);
    out.kinetic_energy = pendulum.kinetic_energy(angular_velocity);
    out.axis_inertia = pendulum.axis_inertia();
    out.effective_mass = pendulum.effective_mass();
    needed(point, "point") = finite(out, "point");
  });
}

int gasjet_pendulum_moment(const gasjet_pendulum_model* model, const double force[3], const double point[3],
                           double* moment) {
  return call([&] {
    const auto pendulum = pendulum_of(model);
    const double found = pendulum.moment(vector_of(force, "force"), vector_of(point, "point"));
    needed(moment, "moment") = finite(found, "moment");
  });
}

int gasjet_pendulum_advance(const gasjet_pendulum_model* model, double moment, double dt_before,
                            double dt_after, double* angle, double* angular_velocity) {
  return call([&] {
    const auto pendulum = pendulum_of(model);
    number(moment, "moment");
    number(dt_before, "dt_before", 0.0);
    positive(dt_after, "dt_after");
    const coupling::PendulumState now{
        number(needed(angle, "angle"), "angle"),
        number(needed(angular_velocity, "angular_velocity"), "angular_velocity")};
    const auto next = pendulum.advance(now, moment, (dt_before + dt_after) / 2, dt_after);
    finite(next.angle, "angle");
    *angular_velocity = finite(next.angular_velocity, "angular_velocity");
    *angle = next.angle;
  });
}

int gasjet_contact_create(const double reference[], int64_t node_count, const int64_t reference_stride[],
                          const int32_t triangles[], int64_t triangle_count, const int64_t triangle_stride[],
                          const double mass[], double effective_mass, double radius, double stiffness,
                          double friction, gasjet_handle* contact) {
  return call([&] {
    needed(contact, "contact");
    *contact = contact_of(reference, node_count, reference_stride, triangles, triangle_count, triangle_stride,
                          mass, effective_mass, {coupling::Sphere{radius}, stiffness, friction});
  });
}

int gasjet_impactor_reach(const gasjet_impactor* impactor, double* reach) {
  return call([&] {
    const auto shape = shape_of(needed(impactor, "impactor"));
    coupling::require_valid(shape);
    needed(reach, "reach") = coupling::reach_of(shape);
  });
}

int gasjet_contact_create_body(const double reference[], int64_t node_count, const int64_t reference_stride[],
                               const int32_t triangles[], int64_t triangle_count,
                               const int64_t triangle_stride[], const double mass[], double effective_mass,
                               const gasjet_impactor* impactor, double stiffness, double friction,
                               gasjet_handle* contact) {
  return call([&] {
    needed(contact, "contact");
    *contact =
        contact_of(reference, node_count, reference_stride, triangles, triangle_count, triangle_stride, mass,
                   effective_mass, {shape_of(needed(impactor, "impactor")), stiffness, friction});
  });
}

int gasjet_contact_evaluate(gasjet_handle contact, const double nodes[], int64_t node_count,
                            const int64_t node_stride[], const double centre[3], const double turn[3],
                            double force[], int64_t force_count, gasjet_contact_sums* sums) {
  return gasjet_contact_evaluate_body(contact, nodes, node_count, node_stride, centre, nullptr, turn, force,
                                      force_count, sums);
}

int gasjet_contact_evaluate_body(gasjet_handle contact, const double nodes[], int64_t node_count,
                                 const int64_t node_stride[], const double centre[3], const double axes[9],
                                 const double turn[3], double force[], int64_t force_count,
                                 gasjet_contact_sums* sums) {
  return call([&] {
    const Use<Contact> use(contact, "contact");
    require_count(node_count, use->model.node_count(), "nodes");
    const Points points(nodes, node_count, node_stride, "nodes");
    coupling::Pose pose{vector_of(centre, "centre")};
    if (axes != nullptr)
      for (int i = 0; i < 3; ++i) pose.axes.col(i) = vector_of(axes + 3 * i, "axes");
    const Eigen::Vector3d turned = turn == nullptr ? Eigen::Vector3d::Zero().eval() : vector_of(turn, "turn");
    const auto out = output(force, force_count, 3 * node_count, "force");
    needed(sums, "sums");
    const auto result = use->model.evaluate(use->state, points.view(), pose,
                                            Eigen::Map<Eigen::Matrix3Xd>(out.data(), 3, node_count), turned);
    write_vector(result.force, sums->force);
    write_vector(result.couple, sums->couple);
    sums->energy = result.energy;
    sums->friction_loss = result.friction_loss;
    sums->area = result.area;
    sums->penetration = result.penetration;
    sums->frequency = result.omega_squared();
    sums->deepest_element = result.deepest_element;
  });
}

int gasjet_skin_contact_create(const double reference[], int64_t node_count, const int64_t reference_stride[],
                               const int32_t triangles[], int64_t triangle_count,
                               const int64_t triangle_stride[], const double mass[], double thickness,
                               double stiffness, double friction, gasjet_handle* skin_contact) {
  return call([&] {
    needed(skin_contact, "skin_contact");
    const Points points(reference, node_count, reference_stride, "reference");
    const auto elements = triangles_of(triangles, triangle_count, triangle_stride, node_count);
    needed(mass, "mass");
    const coupling::SkinContactParameters parameters{positive(thickness, "thickness"),
                                                     positive(stiffness, "stiffness"),
                                                     number(friction, "friction", 0.0)};
    *skin_contact = keep(std::make_shared<SkinContact>(
        elements, points, std::span(mass, static_cast<std::size_t>(node_count)), parameters));
  });
}

int gasjet_skin_contact_evaluate(gasjet_handle skin_contact, const double nodes[], int64_t node_count,
                                 const int64_t node_stride[], double force[], int64_t force_count,
                                 gasjet_skin_contact_sums* sums) {
  return call([&] {
    const Use<SkinContact> use(skin_contact, "skin_contact");
    require_count(node_count, use->model.node_count(), "nodes");
    const Points points(nodes, node_count, node_stride, "nodes");
    const auto out = output(force, force_count, 3 * node_count, "force");
    needed(sums, "sums");
    if (use->spoiled) refuse("skin_contact", "failed at the last call, allowed: a restart");
    use->spoiled = true;
    const auto result = use->model.evaluate(use->state, points.view(),
                                            Eigen::Map<Eigen::Matrix3Xd>(out.data(), 3, node_count));
    use->spoiled = false;
    sums->energy = result.energy;
    sums->friction_loss = result.friction_loss;
    sums->frequency = result.omega_squared;
    sums->gap = result.closest.gap;
    sums->approach = result.approach;
    sums->contacts = result.contacts;
    sums->limited_nodes = use->state.limited_nodes();
    std::ranges::copy(result.closest.first, sums->first_nodes);
    std::ranges::copy(result.closest.second, sums->second_nodes);
  });
}

int gasjet_skin_contact_restart(gasjet_handle skin_contact) {
  return call([&] {
    const Use<SkinContact> use(skin_contact, "skin_contact");
    use->state = use->model.make_state();
    use->spoiled = false;
  });
}

int gasjet_default_skin_stiffness(double share, double other_frequency, double surface_density,
                                  double* stiffness) {
  return call([&] {
    const double found = coupling::default_skin_stiffness(positive(share, "share"),
                                                          positive(other_frequency, "other_frequency"),
                                                          positive(surface_density, "surface_density"));
    needed(stiffness, "stiffness") = finite(found, "stiffness");
  });
}
