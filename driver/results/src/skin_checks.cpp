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

void SkinChecks::go_on_as(const SkinChecks& other) {
  quarters_ = other.quarters_;
  schedule_ = other.schedule_;
  found_ = other.found_;
}

void SkinChecks::go_on_from(const State& state) {
  const SkinChecks fresh(scene_);
  quarters_ = fresh.quarters_;
  schedule_ = fresh.schedule_;
  if (state.steps > 0) due(state, false);
  std::erase_if(found_, [&](const SkinCheck& check) { return check.time > state.time; });
}

LevelView SkinChecks::view() {
  return {[this](const State& state, bool last) { return due(state, last); },
          [this](const State& state) { check(state); }};
}

void SkinChecks::check(const State& state) {
  const bool closed = scene_.gas.has_value();
  found_.push_back({state.time, closed ? state.bag->surface.volume : 0.0,
                    find_crossing(state.bag->position.map(), scene_.bag->mesh.elements, closed,
                                  scene_.bag->null_elements)});
}

void SkinChecks::note(RunOutcome& outcome) const {
  if (auto text = note_of_crossing(found_, scene_.skin_contact.has_value()); !text.empty())
    outcome.notes.push_back(std::move(text));
}

std::string note_of_crossing(const std::vector<SkinCheck>& checks, bool self_contact) {
  constexpr double limit = 0.01;
  if (self_contact) {
    const auto layers = [](const SkinCheck& check) { return check.time > 0.0 ? check.crossing.layers : 0; };
    const auto most = std::ranges::max_element(checks, {}, layers);
    if (most != checks.end() && layers(*most) > 0)
      return fmt::format(
          "membrane.self_contact: layers cross all the same: at {:.3g} s {}, {} of these pairs of "
          "elements that are no neighbours. Please report this case",
          most->time, text_of(most->crossing, most->volume), most->crossing.layers);
  }
  const auto share = [](const SkinCheck& check) {
    return check.time > 0.0 && check.volume > 0.0 ? check.crossing.miscounted() / check.volume : 0.0;
  };
  const auto worst = std::ranges::max_element(checks, {}, share);
  if (worst == checks.end() || share(*worst) <= limit) return {};
  return fmt::format(
      "membrane: the skin passes through itself{}: at {:.3g} s {}; above {:g} % pressure and volume are "
      "wrong "
      "by about that share. {}",
      self_contact ? " between neighbours" : ", because layers do not touch each other", worst->time,
      text_of(worst->crossing, worst->volume), 100.0 * limit,
      self_contact ? "Refine the mesh where it folds"
                   : "Use [membrane.self_contact], or start less folded or flattened");
}

void add_skin_warning(Scene& scene) {
  if (!scene.bag) return;
  const auto& elements = scene.bag->mesh.elements;
  const auto& position = scene.bag->initial_position;
  const Crossing crossing =
      find_crossing(position, elements, scene.gas.has_value(), scene.bag->null_elements);
  if (crossing.pairs == 0) return;
  const double volume = scene.gas ? mesh::enclosed_volume(position, elements) : 0.0;
  // Layers that are no neighbours are refused then.
  scene.warnings.push_back(fmt::format(
      "membrane: {} at the start: {}; {}",
      scene.skin_contact ? "neighbours, which self_contact does not part, cross"
                         : "the skin passes through itself",
      text_of(crossing, volume),
      scene.skin_contact ? "refine the mesh there, or fold less sharply" : "pull its layers apart"));
}

std::string crossed_layers(const Scene& scene) {
  const BagPart& bag = *scene.bag;
  const auto& elements = bag.mesh.elements;
  const auto& position = bag.initial_position;
  const Crossing crossing = find_crossing(position, elements, scene.gas.has_value(), bag.null_elements);
  if (crossing.layers == 0) return {};
  const auto [first, second] = crossing.first_layers;
  const auto centre = [&](int e) -> Eigen::Vector3d {
    return (position.col(elements(0, e)) + position.col(elements(1, e)) + position.col(elements(2, e))) / 3.0;
  };
  const auto name = [&](int e) {
    return bag.mesh.line.empty() ? fmt::format("{}", e)
                                 : fmt::format("of line {}", bag.mesh.line[static_cast<std::size_t>(e)]);
  };
  const Eigen::Vector3d x = 0.5 * (centre(first) + centre(second));
  const double volume = scene.gas ? mesh::enclosed_volume(position, elements) : 0.0;
  return fmt::format(
      "layers cross at the start, {} pairs of elements that are no neighbours, the first near [{:.3g}, "
      "{:.3g}, "
      "{:.3g}] m, elements {} and {}{}; in all {}",
      crossing.layers, x.x(), x.y(), x.z(), name(first), name(second),
      bag.mesh.line.empty() ? " (from 0)" : "", text_of(crossing, volume));
}

void require_separate_layers(CaseDocument& document, const Scene& scene) {
  const std::string crossed = crossed_layers(scene);
  if (crossed.empty()) return;
  TableReader membrane = document.root().table("membrane");
  membrane.table("self_contact")
      .fail("", crossed +
                    (membrane.has("perturbation")
                         ? ". Lower membrane.perturbation, which displaces nodes by up to " +
                               fmt::format("{:.3g} m", membrane.at("perturbation").number(any_number)) +
                               "; or pull"
                         : ". Pull") +
                    " the layers apart, or leave this table out");
}

}  // namespace driver
