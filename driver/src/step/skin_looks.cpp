// SPDX-License-Identifier: Apache-2.0
#include "step/skin_looks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace driver {
SkinLooks::SkinLooks(const Scene& scene) : scene_(scene), schedule_(scene.output.self_intersection_every) {
  if (!scene.bag || !scene.gas) return;
  const membrane::Mesh& mesh = scene.bag->mesh;
  initial_volume_ = membrane::enclosed_volume(scene.bag->initial_position, mesh.elements);
  design_volume_ = membrane::enclosed_volume(mesh.nodes, mesh.elements);
  if (design_volume_ > initial_volume_) quarters_ = 0;
}

bool SkinLooks::due(const State& state, bool last) {
  if (!scene_.bag) return false;
  bool due = schedule_.due(state.time) || last || state.steps == 0;
  for (; quarters_ < 3; ++quarters_, due = true) {
    const double share = 0.25 * (quarters_ + 1);
    if (state.bag->surface.volume < initial_volume_ + share * (design_volume_ - initial_volume_)) break;
  }
  return due;
}

SkinLook SkinLooks::look(const State& state) const {
  const bool closed = scene_.gas.has_value();
  return {state.time, closed ? state.bag->surface.volume : 0.0,
          find_crossing(state.bag->position.map(), scene_.bag->mesh.elements, closed)};
}

std::string note_of_crossing(const std::vector<SkinLook>& looks) {
  constexpr double limit = 0.01;
  const auto share = [](const SkinLook& look) {
    return look.time > 0.0 && look.volume > 0.0 ? look.crossing.miscounted() / look.volume : 0.0;
  };
  const auto worst = std::ranges::max_element(looks, {}, share);
  if (worst == looks.end() || share(*worst) <= limit) return {};
  return fmt::format(
      "membrane: the skin passes through itself, since nothing keeps its layers apart: at {:.3g} s {}; above "
      "{:g} % pressure and volume are off by about that share; a start less folded or flattened crosses less",
      worst->time, text_of(worst->crossing, worst->volume), 100.0 * limit);
}

}  // namespace driver
