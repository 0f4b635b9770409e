// SPDX-License-Identifier: Apache-2.0
// [pendulum] and [contact] -> PendulumPart, ContactModel.
#include "scene/read_pendulum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "coupling/side.hpp"
#include "scene/contact_bounds.hpp"
#include "scene/gas_curve.hpp"
#include "scene/read_fabric.hpp"

namespace driver {
namespace {

// Share of the fabric's own omega^2 that contact adds by default: as stiff as the fabric itself, so that it
// governs at most half of omega^2. A quarter of it lets the paper's impactor sink in beyond half its radius.
constexpr double default_contact_share = 1.0;

// Beyond these a step would add nothing to the angle.
constexpr Bounds turns{-1000.0, 1000.0, false, "a number from -1000 to 1000"};

PendulumPart read_model(TableReader& table, const Eigen::Vector3d& gravity) {
  coupling::PendulumParameters p;
  p.pivot = table.at("pivot").vector("m");
  p.axis = table.at("axis").vector("");
  p.rest_direction = table.at("rest_direction").vector("");
  p.mass = table.at("mass").number(positive.in("kg"));
  p.inertia_cg = table.at("inertia_cg").number(non_negative.in("kg m²"));
  p.cg_distance = table.at("cg_distance").number(non_negative.in("m"));
  p.impactor_distance = table.at("impactor_distance").number(positive.in("m"));
  p.impactor_radius = table.at("impactor_radius").number(positive.in("m"));
  p.gravity = gravity;
  coupling::PendulumState initial;
  initial.angle = table.at("initial_angle").number(turns.in("rad"), 0.0);
  initial.angular_velocity = table.at("initial_angular_velocity").number(any_number.in("rad/s"), 0.0);
  PendulumPart part{coupling::PendulumModel(p), initial, {}};
  if (table.has("driving_moment"))
    table.located("driving_moment", [&] {
      part.driving_moment =
          to_gas_curve(CurveReader(table, "driving_moment").curve(any_number.in("N m")), gas::Outside::zero);
    });
  return part;
}

double contact_stiffness(TableReader& table, double friction, Scene& scene) {
  if (const auto stiffness = table.at("stiffness").optional_number(positive.in("N/m³"))) return *stiffness;
  scene.contact_share = table.at("stiffness_share").number(contact_share, default_contact_share);
  const auto& pendulum = scene.pendulum->model;
  // Of the other terms the fabric's alone never falls: stretch adds to it, gas and straps come and go.
  return coupling::default_contact_stiffness(
      {*scene.contact_share, scene.bag->model.fabric_frequency, lightest_fabric(scene.bag->model.description),
       coupling::Sphere{pendulum.parameters().impactor_radius}, pendulum.effective_mass(), friction});
}

coupling::ContactParameters read_contact(TableReader& table, Scene& scene) {
  const double friction = table.at("friction").number(contact_friction, 0.0);
  const double stiffness = contact_stiffness(table, friction, scene);
  return {coupling::Sphere{scene.pendulum->model.parameters().impactor_radius}, stiffness, friction};
}

void warn_of_late_moment(Scene& scene) {
  const auto& moment = scene.pendulum->driving_moment;
  if (!moment || moment->is_constant()) return;
  const double first = moment->knots().front().time, last = moment->knots().back().time;
  if (first >= scene.time.end || last <= 0.0)
    scene.warnings.push_back(
        fmt::format("pendulum.driving_moment is zero within the run: it acts from {} to "
                    "{} s, end_time is {} s",
                    first, last, scene.time.end));
}

}  // namespace

void read_pendulum(TableReader& root, Scene& scene) {
  auto table = root.optional_table("pendulum");
  auto contact = root.optional_table("contact");
  if (contact && !(table && scene.bag)) root.fail("contact", "needs [pendulum] and [membrane]");
  if (!table) return;
  table->located("", [&] { scene.pendulum.emplace(read_model(*table, scene.gravity)); });
  warn_of_late_moment(scene);
  table->finish();
  if (!scene.bag) return;
  const auto& model = scene.pendulum->model;
  table->located("", [&] {
    coupling::require_outside(scene.bag->mesh.elements, scene.bag->initial_position,
                              coupling::Sphere{model.parameters().impactor_radius},
                              {model.impactor_centre(scene.pendulum->initial.angle)});
  });
  if (!contact) root.fail("contact", "is missing: a pendulum in front of a bag needs it (it may be empty)");
  std::optional<coupling::ContactParameters> parameters;
  contact->located("", [&] { parameters = read_contact(*contact, scene); });
  // What a case can still get wrong is a sphere too small for the elements.
  table->located("impactor_radius", [&] {
    scene.contact.emplace(scene.bag->mesh.elements, scene.bag->model.description.reference,
                          scene.bag->model.node_mass, model.effective_mass(), *parameters,
                          scene.bag->null_elements);
  });
  contact->finish();
}

}  // namespace driver
