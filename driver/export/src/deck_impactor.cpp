// SPDX-License-Identifier: Apache-2.0
// The rigid impactor of a deck.
#include "deck_impactor.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "deck_gas.hpp"
#include "engine/impactor.hpp"
#include "mesh/icosphere.hpp"
#include "results/impactor_picture.hpp"

namespace driver {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

// Triangles of the shape, in the body's axes. Those of a sphere are evenly spaced.
mesh::Mesh surface_of(const coupling::Impactor& shape) {
  constexpr int sphere_levels = 3;  // 1280 elements
  if (const auto* sphere = std::get_if<coupling::Sphere>(&shape))
    return mesh::icosphere(sphere->radius, sphere_levels);
  return impactor_picture(shape);
}

double distance(const coupling::Impactor& shape, const Vector3d& point) {
  return coupling::signed_distance(shape, {}, point).distance;
}

// Depth [m] of the middles of triangles and edges inside the shape.
double deepest_middle(const coupling::Impactor& shape, const mesh::Mesh& surface) {
  double deepest = 0.0;
  for (Eigen::Index e = 0; e < surface.elements.cols(); ++e) {
    const auto corner = [&](Eigen::Index i) { return surface.nodes.col(surface.elements(i % 3, e)); };
    const Vector3d middle = (corner(0) + corner(1) + corner(2)) / 3.0;
    deepest = std::max(deepest, -distance(shape, middle));
    for (Eigen::Index i = 0; i < 3; ++i)
      deepest = std::max(deepest, -distance(shape, 0.5 * (corner(i) + corner(i + 1))));
  }
  return deepest;
}

// A share of the mean radius of the largest section, and of the least radius of curvature.
double gap_of(const coupling::Impactor& shape) {
  constexpr double of_section = 0.02, of_curvature = 0.2;
  return std::min(of_section * std::sqrt(coupling::section_of(shape) / std::numbers::pi),
                  of_curvature * coupling::size_of(shape));
}

// Moves the nodes inwards by the gap, so that contact begins at the shape, and puts them into space.
void place_surface(const coupling::Impactor& shape, const coupling::Pose& pose, DeckImpactor& impactor) {
  for (Eigen::Index n = 0; n < impactor.surface.nodes.cols(); ++n) {
    const Vector3d node = impactor.surface.nodes.col(n);
    const Vector3d inner = node - impactor.gap * coupling::signed_distance(shape, {}, node).normal;
    impactor.surface.nodes.col(n) = pose.centre + pose.axes * inner;
  }
}

// Right-handed axes, x along a vector.
Matrix3d axes_along(const Vector3d& direction) {
  Matrix3d axes;
  axes.col(0) = direction.normalized();
  axes.col(1) = axes.col(0).unitOrthogonal();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

void set_pendulum(const PendulumPart& part, double end, DeckImpactor& impactor) {
  const coupling::PendulumParameters& p = part.model.parameters();
  constexpr double least = 1e-9;  // share of the inertia of a point mass at the centre of gravity, about the
                                  // pivot; a body needs some
  impactor.mass = p.mass;
  impactor.cg = part.model.cg_position(part.initial.angle);
  impactor.inertia =
      std::max(p.inertia_cg, least * p.mass * p.cg_distance * p.cg_distance) * Matrix3d::Identity();
  impactor.angular_velocity = part.initial.angular_velocity * p.axis;
  impactor.velocity = impactor.angular_velocity.cross(impactor.cg - p.pivot);
  impactor.axes = axes_along(p.axis);
  if (part.driving_moment) impactor.load = knots_of(*part.driving_moment, 0.0, end);
}

// [m] Ten times the size of the scene, and what the impactor moves by at its first speed.
double way_of(const Scene& scene) {
  const coupling::RigidBodyParameters& p = scene.body->model.parameters();
  const auto& start = scene.bag->initial_position;
  double size =
      std::max((start.colwise() - p.centre).colwise().norm().maxCoeff(), p.velocity.norm() * run_end(scene));
  for (const coupling::RailSpring& spring : p.rail->springs) size = std::max(size, std::abs(spring.at));
  return 10.0 * size;
}

void set_rail(const Scene& scene, DeckImpactor& impactor) {
  const coupling::Rail& rail = *scene.body->model.parameters().rail;
  const double way = way_of(scene);
  impactor.on_rail = true;
  impactor.axes = axes_along(rail.direction);
  impactor.anchor = impactor.cg - way * rail.direction;
  for (const coupling::RailSpring& s : rail.springs) {
    if (s.stiffness == 0.0 && s.damping == 0.0) continue;
    // Knots are even, as those of a strap.
    const double last = way * s.stiffness, first = s.one_sided ? 0.0 : -last;
    impactor.springs.push_back(
        {{{s.at - way, first}, {s.at, 0.0}, {s.at + way, last}}, s.stiffness, s.one_sided ? 0.0 : s.damping});
  }
}

void set_body(const Scene& scene, DeckImpactor& impactor) {
  const coupling::RigidBodyParameters& p = scene.body->model.parameters();
  impactor.mass = p.mass;
  impactor.cg = p.centre;
  impactor.velocity = p.velocity;
  impactor.angular_velocity = p.angular_velocity;
  if (scene.body->force) impactor.load = knots_of(*scene.body->force, 0.0, scene.time.end);
  if (!p.rail) {
    impactor.inertia = p.axes * p.inertia * p.axes.transpose();
    return;
  }
  // It does not turn, but decks need some inertia: that of a ball.
  const double reach = coupling::reach_of(scene.impactor);
  impactor.inertia = 0.4 * p.mass * reach * reach * Matrix3d::Identity();
  set_rail(scene, impactor);
}

// Notes that contact acts on the bag's nodes. Between the nodes of an equilateral triangle of edge L, a
// sphere of radius R sinks in by L^2/(6 R) before it meets one, as their circle has the radius L/sqrt(3).
void note_contact(const Scene& scene, Deck& deck) {
  const mesh::Mesh& mesh = scene.bag->mesh;
  double longest = 0.0;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e)
    for (Eigen::Index i = 0; i < 3; ++i)
      longest = std::max(
          longest,
          (mesh.nodes.col(mesh.elements(i, e)) - mesh.nodes.col(mesh.elements((i + 1) % 3, e))).norm());
  const double radius = coupling::size_of(scene.impactor), gap = deck.impactor->gap;
  const double depth = longest * longest / (6.0 * radius);
  if (depth <= gap) return;
  const char* which = std::holds_alternative<coupling::Sphere>(scene.impactor) ? "radius" : "least radius";
  deck.notes.push_back(
      {"membrane.mesh",
       fmt::format(
           "contact acts on the bag's nodes only: the longest edge is {:.3g} m, the impactor's {} {:.3g} m, "
           "so it sinks in by up to {:.2g} m between nodes; use edges below {:.2g} m",
           longest, which, radius, depth, std::sqrt(6.0 * radius * gap))});
}

void add_field(const Scene& scene, Deck& deck) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const gas::Curve& curve = (*scene.field)[axis];
    const auto is_zero = [](const auto& knot) { return knot.value == 0.0; };
    if (!std::ranges::all_of(curve.knots(), is_zero)) deck.field[axis] = knots_of(curve, 0.0, scene.time.end);
  }
}

}  // namespace

void add_impactor(const Scene& scene, Deck& deck) {
  if (scene.field) add_field(scene, deck);
  if (!scene.has_impactor()) return;
  const coupling::Pose pose = impactor_start(scene);
  DeckImpactor& impactor = deck.impactor.emplace();
  impactor.centre = pose.centre;
  impactor.gap = gap_of(scene.impactor);
  impactor.surface = surface_of(scene.impactor);
  deck.notes.push_back(
      {scene.pendulum && scene.pendulum->path == "pendulum" ? "pendulum.impactor_radius" : "impactor.shape",
       fmt::format("the surface is made of {} flat triangles, up to {:.2g} m inside the shape",
                   impactor.surface.elements.cols(), deepest_middle(scene.impactor, impactor.surface))});
  place_surface(scene.impactor, pose, impactor);
  if (scene.pendulum)
    set_pendulum(*scene.pendulum, scene.time.end, impactor);
  else
    set_body(scene, impactor);
  if (scene.contact) note_contact(scene, deck);
}

}  // namespace driver
