// SPDX-License-Identifier: Apache-2.0
// [pendulum] or [impactor], and [contact] -> PendulumPart or BodyPart, ContactModel.
#include "scene/read_pendulum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "coupling/side.hpp"
#include "engine/impactor.hpp"
#include "scene/contact_bounds.hpp"
#include "scene/read_fabric.hpp"
#include "scene/read_impactor.hpp"

namespace driver {
namespace {

// Share of the fabric's own omega^2 that contact adds by default: as stiff as the fabric itself, so that it
// governs at most half of omega^2. A quarter of it lets the paper's impactor sink in beyond half its radius.
constexpr double default_contact_share = 1.0;

double contact_stiffness(TableReader& table, double friction, Scene& scene) {
  if (const auto stiffness = table.at("stiffness").optional_number(positive.in("N/m³"))) return *stiffness;
  scene.contact_share = table.at("stiffness_share").number(contact_share, default_contact_share);
  // Of the other terms the fabric's alone never falls: stretch adds to it, gas and straps come and go.
  return coupling::default_contact_stiffness({*scene.contact_share, scene.bag->model.fabric_frequency,
                                              lightest_fabric(scene.bag->model.description), scene.impactor,
                                              impactor_mass(scene), friction});
}

coupling::ContactParameters read_contact(TableReader& table, Scene& scene) {
  const double friction = table.at("friction").number(contact_friction, 0.0);
  const double stiffness = contact_stiffness(table, friction, scene);
  return {scene.impactor, stiffness, friction};
}

void warn_of_late_drive(const std::optional<gas::Curve>& drive, const std::string& key, Scene& scene) {
  if (!drive || drive->is_constant()) return;
  const double first = drive->knots().front().time, last = drive->knots().back().time;
  if (first >= scene.time.end || last <= 0.0)
    scene.warnings.push_back(
        fmt::format("{} is zero within the run: it acts from {} to {} s, end_time is {} s", key, first, last,
                    scene.time.end));
}

// [pendulum] is a sphere on a pendulum.
void read_sphere_on_pendulum(TableReader& table, Scene& scene) {
  table.located("", [&] {
    const double radius = table.at("impactor_radius").number(positive.in("m"));
    scene.impactor = coupling::Sphere{radius};
    scene.pendulum.emplace(read_pendulum_motion(table, radius, scene.gravity));
  });
}

void read_contact_model(TableReader& table, TableReader& contact, const char* sized, Scene& scene) {
  table.located("", [&] {
    coupling::require_outside(scene.bag->mesh.elements, scene.bag->initial_position, scene.impactor,
                              impactor_start(scene));
  });
  std::optional<coupling::ContactParameters> parameters;
  contact.located("", [&] { parameters = read_contact(contact, scene); });
  // What a case can still get wrong is an impactor too small for the elements.
  table.located(sized, [&] {
    scene.contact.emplace(scene.bag->mesh.elements, scene.bag->model.description.reference,
                          scene.bag->model.node_mass, impactor_mass(scene), *parameters,
                          scene.bag->null_elements);
  });
  contact.finish();
}

}  // namespace

void read_pendulum(TableReader& root, Scene& scene) {
  auto pendulum = root.optional_table("pendulum"), impactor = root.optional_table("impactor");
  auto contact = root.optional_table("contact");
  if (pendulum && impactor)
    root.fail("impactor", "a scene has one impactor: [pendulum], a sphere on a pendulum, or [impactor]");
  if (contact && !((pendulum || impactor) && scene.bag))
    root.fail("contact", "needs [membrane], and [pendulum] or [impactor]");
  if (!pendulum && !impactor) return;
  if (pendulum) read_sphere_on_pendulum(*pendulum, scene);
  if (impactor) read_impactor(*impactor, scene);
  if (scene.pendulum)
    warn_of_late_drive(scene.pendulum->driving_moment, scene.pendulum->path + ".driving_moment", scene);
  if (scene.body) warn_of_late_drive(scene.body->force, "impactor.motion.force", scene);
  TableReader& table = pendulum ? *pendulum : *impactor;
  table.finish();
  if (!scene.bag) return;
  if (!contact) root.fail("contact", "is missing: an impactor in front of a bag needs it (it may be empty)");
  read_contact_model(table, *contact, pendulum ? "impactor_radius" : "shape", scene);
}

}  // namespace driver
