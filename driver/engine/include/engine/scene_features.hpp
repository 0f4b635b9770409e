// SPDX-License-Identifier: Apache-2.0
// What a scene has: when its columns are there.
#pragma once

#include <algorithm>

#include "engine/scene.hpp"

namespace driver::has {

inline bool anything(const Scene&) {
  return true;
}
inline bool volume(const Scene& scene) {
  return scene.has_volume();
}
inline bool inflators(const Scene& scene) {
  return scene.has_volume() && !scene.gas->model.inflows.empty();
}
inline bool vents(const Scene& scene) {
  return scene.has_volume() && !scene.gas->model.vents.empty();
}
inline bool heat_loss(const Scene& scene) {
  return scene.has_volume() && scene.gas->model.heat_loss.conductance > 0.0;
}
inline bool backflow(const Scene& scene) {
  return vents(scene) &&
         std::ranges::any_of(scene.gas->model.vents, [](const auto& vent) { return vent.backflow; });
}
inline bool fabric_leak(const Scene& scene) {
  return scene.bag ? scene.gas && scene.bag->leak_law != LeakLaw::none
                   : scene.has_volume() && scene.gas->tank_leak_area > 0.0;
}
inline bool moving_tank(const Scene& scene) {
  return !scene.bag && scene.has_volume() &&
         (scene.gas->tank_volume || scene.gas->model.volume_of_overpressure);
}
inline bool bag(const Scene& scene) {
  return scene.bag.has_value();
}
inline bool bag_of_gas(const Scene& scene) {
  return scene.bag && scene.gas;
}
inline bool prescribed_pressure(const Scene& scene) {
  return scene.bag && scene.bag->overpressure;
}
inline bool straps(const Scene& scene) {
  return scene.bag && !scene.bag->model.description.straps.empty();
}
inline bool plates(const Scene& scene) {
  return scene.bag && !scene.bag->model.description.plates.empty();
}
inline bool weight(const Scene& scene) {
  return scene.bag && !scene.gravity.isZero(0.0);
}
inline bool damping(const Scene& scene) {
  if (!scene.bag) return false;
  const membrane::BagDescription& bag = scene.bag->model.description;
  return bag.mass_damping > 0.0 || bag.stiffness_damping > 0.0;
}
inline bool jets(const Scene& scene) {
  return !scene.jets.empty();
}
inline bool jets_on_bag(const Scene& scene) {
  return scene.bag && !scene.jets.empty();
}
inline bool contact(const Scene& scene) {
  return scene.contact.has_value();
}
inline bool friction(const Scene& scene) {
  return (scene.contact && scene.contact->parameters().friction > 0.0) ||
         (scene.skin_contact && scene.skin_contact->parameters().friction > 0.0);
}
inline bool self_contact(const Scene& scene) {
  return scene.skin_contact.has_value();
}
inline bool pendulum(const Scene& scene) {
  return scene.pendulum.has_value();
}
inline bool body(const Scene& scene) {
  return scene.body.has_value();
}
inline bool free_body(const Scene& scene) {
  return scene.body && scene.body->model.is_free();
}
inline bool rail_springs(const Scene& scene) {
  return scene.body && !scene.body->model.is_free() && !scene.body->model.parameters().rail->springs.empty();
}
inline bool impactor(const Scene& scene) {
  return scene.has_impactor();
}
inline bool driving(const Scene& scene) {
  return scene.driven || scene.field || (scene.pendulum && scene.pendulum->driving_moment) ||
         (scene.body && scene.body->force);
}
inline bool motion(const Scene& scene) {
  return scene.moves();
}

}  // namespace driver::has
