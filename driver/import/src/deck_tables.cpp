// SPDX-License-Identifier: Apache-2.0
#include "deck_tables.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "import/case_writer.hpp"

namespace driver::imported {

void NodeTable::put(long number, const Eigen::Vector3d& place) {
  const auto [found, is_new] = places.try_emplace(number, place);
  if (is_new || found->second == place) return;
  found->second = place;
  ++moved;
}

void add_knot(NumberedCurve& curve, double x, double y, Place at) {
  if (!curve.knots.empty() && x < curve.knots.back()[0])
    throw DeckFault(at, fmt::format("the curve falls back to {:g} after {:g}", x, curve.knots.back()[0]));
  curve.knots.push_back({x, y});
}

Knots take_curve(const CurveTable& curves, long number, double x_unit, double y_unit, const std::string& key,
                 Place at, ImportReport& report) {
  const NumberedCurve& curve = entry_of(curves, number, "curve", at);
  Knots knots;
  for (const auto& [x, y] : curve.knots) knots.push_back({x * x_unit, y * y_unit});
  report.became(*curve.card, {key}, Mapping::exact, "knots in SI units, with all scales applied");
  return knots;
}

void take_nodes(const NodeTable& nodes, double length, BagDeck& bag, ImportReport& report) {
  for (const auto& [id, place] : nodes.places) bag.nodes[id] = place * length;
  if (nodes.moved > 0)
    report.note(
        fmt::format("{} nodes stand twice, at different places: the last ones are taken", nodes.moved));
  for (const DeckCard& card : report.deck().cards)
    if (card.keyword == "*NODE" || card.keyword == "/NODE")
      report.became(card, {"membrane.mesh.file"}, Mapping::exact,
                    "nodes of the mesh; those of other parts are left out");
}

void claim_shells(const std::vector<DeckShell>& shells, const PanelNames& panels, ImportReport& report) {
  const DeckCard* last = nullptr;
  for (const DeckShell& shell : shells)
    if (shell.card != last && panels.contains(shell.part)) {
      last = shell.card;
      report.became(*last, {"membrane.mesh.file"}, Mapping::exact,
                    "elements of the mesh; quads are cut in two");
    }
}

std::string panel_name(const std::string& title, long part, const PanelNames& panels) {
  std::string name = plain_name(title);
  if (name.empty()) name = fmt::format("part_{}", part);
  const bool is_taken = std::ranges::any_of(panels, [&](const auto& other) { return other.second == name; });
  return is_taken ? fmt::format("{}_{}", name, part) : name;
}

void require_nodes(const BagDeck& bag) {
  for (const Facet& facet : bag.facets)
    for (const long node : facet.nodes)
      if (!bag.nodes.contains(node))
        throw DeckFault(facet.at,
                        fmt::format("an element of the bag has node {}, which the deck does not have", node));
}

std::set<long> nodes_of(const BagDeck& bag) {
  std::set<long> nodes;
  for (const Facet& facet : bag.facets) nodes.insert(facet.nodes.begin(), facet.nodes.end());
  return nodes;
}

double area_of(const BagDeck& bag, const PanelNames& panels, long part) {
  const auto panel = panels.find(part);
  double area = 0.0;
  for (const Facet& facet : bag.facets) {
    if (panel == panels.end() || facet.panel != panel->second) continue;
    for (std::size_t i = 1; i + 1 < facet.nodes.size(); ++i) {
      const auto at = [&](std::size_t n) -> const Eigen::Vector3d& { return bag.nodes.at(facet.nodes[n]); };
      area += 0.5 * (at(i) - at(0)).cross(at(i + 1) - at(0)).norm();
    }
  }
  return area;
}

}  // namespace driver::imported
