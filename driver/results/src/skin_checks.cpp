// SPDX-License-Identifier: Apache-2.0
#include "results/skin_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace driver {

SkinChecks::SkinChecks(const Scene& scene) : scene_(scene), schedule_(scene.output.self_intersection_every) {
  if (!scene.bag || !scene.gas) return;
  const mesh::Mesh& mesh = scene.bag->mesh;
  initial_volume_ = mesh::enclosed_volume(scene.bag->initial_position, mesh.elements);
  design_volume_ = mesh::enclosed_volume(mesh.nodes, mesh.elements);
  if (design_volume_ > initial_volume_) quarters_ = 0;
}

bool SkinChecks::due(const State& state, bool last) {
  if (!scene_.bag) return false;
  bool due = schedule_.due(state.time) || last || state.steps == 0;
  for (; quarters_ < 3; ++quarters_, due = true) {
    const double share = 0.25 * (quarters_ + 1);
    if (state.bag->surface.volume < initial_volume_ + share * (design_volume_ - initial_volume_)) break;
  }
  return due;
}

LevelView SkinChecks::view() {
  return {[this](const State& state, bool last) { return due(state, last); },
          [this](const State& state) { check(state); }};
}

void SkinChecks::check(const State& state) {
  const bool closed = scene_.gas.has_value();
  found_.push_back({state.time, closed ? state.bag->surface.volume : 0.0,
                    find_crossing(state.bag->position.map(), scene_.bag->mesh.elements, closed)});
}

void SkinChecks::note(RunOutcome& outcome) const {
  if (auto text = note_of_crossing(found_); !text.empty()) outcome.notes.push_back(std::move(text));
}

std::string note_of_crossing(const std::vector<SkinCheck>& checks) {
  constexpr double limit = 0.01;
  const auto share = [](const SkinCheck& check) {
    return check.time > 0.0 && check.volume > 0.0 ? check.crossing.miscounted() / check.volume : 0.0;
  };
  const auto worst = std::ranges::max_element(checks, {}, share);
  if (worst == checks.end() || share(*worst) <= limit) return {};
  return fmt::format(
      "membrane: the skin passes through itself, because layers do not touch each other: at {:.3g} s {}; "
      "above {:g} % pressure and volume are wrong by about that share. Start less folded or flattened",
      worst->time, text_of(worst->crossing, worst->volume), 100.0 * limit);
}

void add_skin_warning(Scene& scene) {
  if (!scene.bag) return;
  const auto& elements = scene.bag->mesh.elements;
  const auto& position = scene.bag->initial_position;
  const Crossing crossing = find_crossing(position, elements, scene.gas.has_value());
  if (crossing.pairs == 0) return;
  const double volume = scene.gas ? mesh::enclosed_volume(position, elements) : 0.0;
  scene.warnings.push_back(
      fmt::format("membrane: the skin passes through itself at the start: {}; pull its layers apart",
                  text_of(crossing, volume)));
}

}  // namespace driver
