// SPDX-License-Identifier: Apache-2.0
#include "import/import_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_head.hpp"
#include "gas_at_start.hpp"
#include "import/bag_surface.hpp"
#include "import/case_writer.hpp"

namespace driver::imported {
namespace {

double extent_of(const mesh::Mesh& mesh) {
  return (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).maxCoeff();
}

// True for a node that is held along all axes that the normal has.
bool is_held(const BagDeck& bag, long node, const Eigen::Vector3d& normal) {
  std::array<bool, 3> held{};
  for (const BagSupport& support : bag.held.supports)
    if (std::ranges::find(support.nodes, node) != support.nodes.end())
      for (std::size_t i = 0; i < 3; ++i) held[i] = held[i] || support.along[i];
  for (std::size_t i = 0; i < 3; ++i)
    if (normal[static_cast<Eigen::Index>(i)] != 0.0 && !held[i]) return false;
  return true;
}

// A case's plate may not reach into the bag at the start: it moves back, or is left out.
void clear_wall(const BagSurface& surface, BagDeck& bag, ImportReport& report, const DeckCard& card) {
  if (!bag.held.wall) return;
  BagWall& wall = *bag.held.wall;
  const mesh::Mesh& mesh = surface.mesh;
  const double extent = extent_of(mesh);
  const Eigen::VectorXd depth = -(wall.normal.transpose() * (mesh.nodes.colwise() - wall.point)).transpose();
  constexpr double rounding = 1e-6, most = 0.1;  // of the bag's extent
  double deepest = 0.0;
  for (Eigen::Index n = 0; n < depth.size(); ++n)
    if (depth[n] > deepest && !is_held(bag, surface.numbers[static_cast<std::size_t>(n)], wall.normal))
      deepest = depth[n];
  if (-depth.minCoeff() < 0.0) {
    report.note(
        fmt::format("the bag starts wholly behind the rigid wall at {}, up to {:.3g} m: the wall is left out",
                    wall.source, deepest));
    bag.held.wall.reset();
    return;
  }
  if (deepest <= rounding * extent) return;
  if (deepest > most * extent)
    return report.refuse(
        card, fmt::format("the bag starts {:.3g} m behind the rigid wall at {}", deepest, wall.source));
  wall.point -= deepest * wall.normal;
  report.note(fmt::format(
      "the plate is moved back by {:.3g} m, so that the bag does not reach into it at the start", deepest));
}

// Layers that are thicker than elements are high cannot touch.
void thin_layers(const BagSurface& surface, BagDeck& bag, ImportReport& report) {
  if (bag.held.layer_thickness == 0.0) return;
  const Eigen::Matrix3Xd& nodes = surface.reference ? *surface.reference : surface.mesh.nodes;
  const double altitude = mesh::element_quality(nodes, surface.mesh.elements).min_altitude;
  constexpr double below = 0.999;
  if (bag.held.layer_thickness <= below * altitude) return;
  report.note(
      fmt::format("the thickness of layers that touch is {:.3g} m, not {:.3g}: at most the smallest altitude "
                  "of an element",
                  below * altitude, bag.held.layer_thickness));
  bag.held.layer_thickness = below * altitude;
}

}  // namespace

std::unique_ptr<ImportedCase> import_case(const std::filesystem::path& deck, const ImportOptions& options) {
  if (options.units) import_units(*options.units);
  auto result = std::make_unique<ImportedCase>(read_deck_text(deck));
  ImportReport& report = result->report;
  ImportedDeck mapped;
  try {
    mapped = result->text.program == DeckFormat::lsdyna ? map_lsdyna(result->text, options, report)
                                                        : map_radioss(result->text, options, report);
  } catch (const DeckFault& fault) {
    report.refuse("deck", fault.at(), fault.what());
  }
  const std::string stem = plain_name(deck.stem().string());
  if (mapped.bag.name.empty()) mapped.bag.name = stem;
  result->scene = mapped.bag.name;
  if (mapped.card != nullptr && !report.refused()) {
    if (const auto surface = surface_of(mapped.bag, *mapped.card, report)) {
      clear_wall(*surface, mapped.bag, report, *mapped.card);
      thin_layers(*surface, mapped.bag, report);
      gas_at_start(mapped.bag, mesh::enclosed_volume(surface->mesh.nodes, surface->mesh.elements), report);
      result->files =
          write_case(mapped.bag, *surface, stem.empty() ? "case" : stem, deck.filename().string());
    }
  }
  report.finish();
  if (report.refused()) result->files.clear();
  return result;
}

std::string import_json(const ImportedCase& result) {
  auto object = json_head<nlohmann::ordered_json>();
  object["scene"] = result.scene;
  object["deck"] = result.text.program == DeckFormat::lsdyna ? "lsdyna" : "radioss";
  object["written"] = !result.files.empty();
  object["cards"] = nlohmann::ordered_json::array();
  for (const CardOutcome& outcome : result.report.outcomes()) {
    nlohmann::ordered_json places = nlohmann::ordered_json::array({result.text.where(outcome.at)});
    for (const Place place : outcome.more) places.push_back(result.text.where(place));
    object["cards"].push_back({{"card", outcome.card},
                               {"places", places},
                               {"keys", outcome.keys},
                               {"mapping", outcome.refused ? "refused" : name_of(outcome.mapping)},
                               {"how", outcome.how}});
  }
  object["counts"] = result.report.counts();
  object["counts"]["cards"] = result.text.cards.size();
  object["notes"] = result.report.notes();
  return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace driver::imported
