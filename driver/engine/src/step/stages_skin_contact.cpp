// SPDX-License-Identifier: Apache-2.0
// S4: the skin against itself.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "engine/stages.hpp"

namespace driver {
namespace {

double surface_density(const membrane::BagModel& bag) {
  return bag.fabric_mass / std::accumulate(bag.node_area.begin(), bag.node_area.end(), 0.0);
}

// Two layers that close at v stop within their limit l if half of the mass per area times v^2 / 2 is less
// than phi(l, 0) = 6 kappa l^2 / 2, by both halves of (K.44). Eight times that stiffness, as found by trials:
// pairs share a load unevenly, and edges that cross at a corner bear less.
std::string stiffer(const Scene& scene, const State& state, const coupling::GapError& error) {
  const coupling::SkinContactParameters& p = scene.skin_contact->parameters();
  const bool edges = error.pair().first[1] >= 0;
  const double rate = error.motion() / state.step.before / (edges ? 0.8 * p.thickness : p.thickness);
  const double needed = surface_density(scene.bag->model) * rate * rate / (2.0 * 6.0);
  const double factor = std::max(4.0, 8.0 * needed / p.stiffness);
  const double now = scene.skin_contact_share.value_or(p.stiffness);
  const char* key = scene.skin_contact_share ? "stiffness_share" : "stiffness";
  return fmt::format("membrane.self_contact.{} = {:.3g}, then {:.3g} (now {:.3g})", key, factor * now,
                     4.0 * factor * now, now);
}

// The numbers of the elements that have all these nodes, at most two.
std::string elements_with(const mesh::Mesh& mesh, std::span<const int> nodes) {
  std::vector<std::string> names;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e)
    if (std::ranges::all_of(nodes, [&](int n) { return n < 0 || (mesh.elements.col(e).array() == n).any(); }))
      names.push_back(mesh.line.empty() ? fmt::format("{}", e)
                                        : fmt::format("of line {}", mesh.line[static_cast<std::size_t>(e)]));
  if (names.size() > 2) names.resize(2);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string told(const Scene& scene, const State& state, const coupling::GapError& error) {
  const mesh::Mesh& mesh = scene.bag->mesh;
  std::string text =
      fmt::format("{} (elements {} against {}", error.what(), elements_with(mesh, error.pair().first),
                  elements_with(mesh, error.pair().second));
  text += mesh.line.empty() ? ", from 0)" : ")";
  if (!(state.step.before > 0.0)) return text + "; pull the layers apart";
  text += fmt::format(
      " in a step of {:.3g} s; try {}: layers then come less close; a smaller {} and a larger "
      "membrane.self_contact.thickness help, too",
      state.step.before, stiffer(scene, state, error), scene.time.step ? "time.step" : "time.safety");
  if (const double least = state.skin_contact_cache->smallest_limit();
      least < 0.1 * scene.skin_contact->parameters().thickness)
    text += fmt::format(
        "; nodes that started as close as {:.3g} m to another layer touch within that (K.45): pull the "
        "layers apart, as by a larger membrane.fold.gap",
        least);
  return text;
}

}  // namespace

void skin_contact(const Scene& scene, State& state) {
  try {
    state.skin_contact = scene.skin_contact->evaluate(*state.skin_contact_cache, state.bag->position.map(),
                                                      state.bag->contact_force.map());
  } catch (const coupling::GapError& error) {
    throw coupling::GapError(told(scene, state, error), error.pair(), error.motion());
  }
  state.flows.friction_loss += state.skin_contact.friction_loss;
}

double skin_contact_stiffness(const Scene& scene, const State& state) {
  const coupling::SkinContactResult& now = state.skin_contact;
  if (!scene.skin_contact || (now.contacts == 0 && !(now.approach > 0.0))) return 0.0;
  return scene.skin_contact->full_omega_squared();
}

double deep_contact_stiffness(const Scene& scene, const State& state) {
  return scene.skin_contact ? std::max(0.0, state.skin_contact.omega_squared - state.step.self_contact) : 0.0;
}

}  // namespace driver
