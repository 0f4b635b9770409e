// SPDX-License-Identifier: Apache-2.0
// Reference geometry, supports, straps, walls, gravity, damping and layers of a Radioss deck.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck_reader.hpp"
#include "radioss_tables.hpp"
#include "strap_curves.hpp"

namespace driver::imported {
namespace {

/// One method a kind of card.
class RadiossSurroundings {
 public:
  explicit RadiossSurroundings(RadiossContext& context) : c_(context), u_(context.units) {}
  void read();

 private:
  void read(const DeckCard& card);
  void reference(const DeckCard& card);
  void hold(const DeckCard& card);
  void pull(const DeckCard& card);
  void wall(const DeckCard& card);
  void damping(const DeckCard& card);
  void layers(const DeckCard& card);
  void other_parts();
  void strap(const RadiossSpring& spring);
  std::vector<long> of_bag(const std::set<long>& nodes) const {
    std::vector<long> own;
    std::ranges::set_intersection(nodes, bag_, std::back_inserter(own));
    return own;
  }

  RadiossContext& c_;
  const Units& u_;
  std::set<long> bag_;
};

void RadiossSurroundings::reference(const DeckCard& card) {
  const bool by_part = card.keyword.starts_with("/XREF");
  for (const DeckLine* line : filled(card, by_part ? 2 : 0)) {
    const DeckFields f(c_.text, card, *line, {10, 20, 20, 20});
    c_.bag.reference[f.whole(0, "node_ID")] =
        Eigen::Vector3d(f.real(1, "X"), f.real(2, "Y"), f.real(3, "Z")) * u_.length;
  }
  c_.report.became(card, {"membrane.mesh.initial_file"}, Mapping::exact,
                   "the stress-free shape; /NODE has the start");
}

// Codes of three translations and three turns, 1 for held.
void RadiossSurroundings::hold(const DeckCard& card) {
  const DeckFields f = c_.tens(card, 1);
  const auto nodes = of_bag(c_.nodes_of_group(f.whole(2, "grnod_ID"), f.at()));
  if (nodes.empty()) return;
  if (f.whole(1, "skew_ID") != 0) throw DeckFault(f.at(), "axes of a skew have no counterpart");
  const std::string_view code = f.text(0);
  std::array<bool, 3> along{};
  for (std::size_t i = 0; i < 3 && i < code.size(); ++i) along[i] = code[i] == '1';
  c_.bag.held.supports.push_back({along, nodes});
  c_.report.became(card, {"membrane.fixed_nodes", "membrane.roller"}, Mapping::exact,
                   "nodes by number; turns need none");
}

void RadiossSurroundings::pull(const DeckCard& card) {
  const DeckFields f(c_.text, card, line_or_blank(card, 1), {10, 10, 10, 10, 10, 10, 20, 20});
  if (const long group = f.whole(4, "grnod_ID");
      group != 0 && of_bag(c_.nodes_of_group(group, f.at())).empty())
    return;
  const std::string direction = in_capitals(f.text(1));
  const auto axis = std::string_view("XYZ").find(direction);
  if (direction.size() != 1 || axis == std::string_view::npos)
    throw DeckFault(f.at(), fmt::format("DIR = '{}', allowed: X, Y and Z", direction));
  const double scale = f.real(7, "Fscale_Y") == 0.0 ? 1.0 : f.real(7, "Fscale_Y");
  double factor = 1.0;
  Mapping mapping = Mapping::exact;
  if (const long function = f.whole(0, "funct_IDT"); function != 0) {
    const Knots knots = c_.curve(function, u_.time, 1.0, "scene.gravity", f.at());
    factor = knots.back()[1];
    if (std::ranges::any_of(knots, [&](const auto& knot) { return knot[1] != factor; }))
      mapping = Mapping::approximated;
  }
  c_.bag.gravity[static_cast<Eigen::Index>(axis)] += factor * scale * u_.acceleration();
  c_.report.became(card, {"scene.gravity"}, mapping,
                   mapping == Mapping::exact ? "acceleration of everything that moves"
                                             : "constant from the start, as at the function's end");
}

void RadiossSurroundings::wall(const DeckCard& card) {
  const DeckFields f = c_.tens(card, 1);
  const long near = f.whole(2, "grnd_ID1");
  if (near != 0 && of_bag(c_.nodes_of_group(near, f.at())).empty()) return;
  if (f.whole(0, "node_ID") != 0) throw DeckFault(f.at(), "a wall that moves with a node has no counterpart");
  const DeckFields a = c_.twenties(card, 3), b = c_.twenties(card, 4);
  const Eigen::Vector3d from(a.real(0, "XM"), a.real(1, "YM"), a.real(2, "ZM")),
      to(b.real(0, "XM1"), b.real(1, "YM1"), b.real(2, "ZM1"));
  if (!((to - from).norm() > 0.0))
    throw DeckFault(a.at(), "both points of the wall's normal are at one place");
  if (c_.bag.held.wall)
    return c_.report.left_out(card, Mapping::none, "a case has one plate: this one is left out");
  c_.bag.held.wall = BagWall{from * u_.length, (to - from).normalized(), c_.source(card)};
  c_.report.became(card, {"membrane.plate.point", "membrane.plate.normal"}, Mapping::approximated,
                   "a stiff plate by a penalty, without friction");
}

void RadiossSurroundings::damping(const DeckCard& card) {
  const DeckFields f(c_.text, card, line_or_blank(card, 1), {20, 20, 10, 10, 20, 20});
  if (of_bag(c_.nodes_of_group(f.whole(2, "grnod_ID"), f.at())).empty()) return;
  c_.bag.held.mass_damping = f.real(0, "Alpha") / u_.time;
  c_.bag.held.stiffness_damping = f.real(1, "Beta") * u_.time;
  c_.report.became(card, {"membrane.mass_damping", "membrane.stiffness_damping"},
                   c_.bag.held.stiffness_damping > 0.0 ? Mapping::approximated : Mapping::exact,
                   "of the whole bag");
}

// Nodes of the bag against the bag's own surface.
void RadiossSurroundings::layers(const DeckCard& card) {
  const DeckFields f = c_.tens(card, 1), g = c_.twenties(card, 4);
  const auto parts = c_.parts_of_surface(f.whole(1, "surf_ID"), f.at());
  if (std::ranges::any_of(parts, [&](long part) { return !c_.panels.contains(part); })) return;
  if (of_bag(c_.nodes_of_group(f.whole(0, "grnod_ID"), f.at())).empty()) return;
  const double gap = g.real(2, "GAPmin") * u_.length;
  if (!(gap > 0.0))
    return c_.report.left_out(card, Mapping::none,
                              "no gap (GAPmin) is given, so layers pass through each other; set "
                              "[membrane.self_contact] thickness by hand");
  c_.bag.held.layer_thickness = gap;
  c_.bag.held.layer_friction = g.real(1, "Fric");
  c_.report.became(card, {"membrane.self_contact", "membrane.self_contact.thickness"}, Mapping::approximated,
                   "pressure between layers with the program's own penalty");
}

void RadiossSurroundings::strap(const RadiossSpring& spring) {
  const bool from = bag_.contains(spring.from), to = bag_.contains(spring.to);
  if (!from && !to) return;
  const auto part = c_.tables.parts.find(spring.part);
  const auto property = part == c_.tables.parts.end() ? c_.tables.properties.end()
                                                      : c_.tables.properties.find(part->second.property);
  if (property == c_.tables.properties.end())
    throw DeckFault(spring.at, fmt::format("the property of part {} is not in the deck", spring.part));
  const DeckCard& card = *property->second;
  if (!card.keyword.starts_with("/PROP/SPRING/") && !card.keyword.starts_with("/PROP/TYPE4/"))
    throw DeckFault(card.at, "is no strap, allowed: springs /PROP/SPRING (TYPE4)");
  if (!from || !to)
    throw DeckFault(
        spring.at,
        "joins the bag to something else, which has no counterpart; allowed: two nodes of the bag");
  const double length = (c_.bag.nodes.at(spring.to) - c_.bag.nodes.at(spring.from)).norm();
  const DeckFields k = c_.twenties(card, 2), f = c_.tens(card, 3);
  StrapLaw law{k.real(0, "K") * u_.stiffness(), 0.0, 0.0};
  if (const long function = f.whole(0, "fct_ID11"); function != 0)
    law = strap_law(c_.curve(function, u_.length, u_.force(), "membrane.strap.stiffness", f.at()), f.at());
  c_.bag.held.straps.push_back({spring.from, spring.to, law.stiffness, length + law.slack,
                                fmt::format("{} {}", c_.text.where(spring.at), spring.card->keyword)});
  const bool exact = law.misfit == 0.0;
  c_.report.became(*spring.card, {"membrane.strap.from_node", "membrane.strap.to_node"}, Mapping::exact,
                   "straps by node");
  c_.report.became(
      card, {"membrane.strap.stiffness", "membrane.strap.free_length"},
      exact ? Mapping::exact : Mapping::approximated,
      exact ? "a linear strap without compression"
            : fmt::format("a linear strap without compression: off by up to {:.2g} of the largest force",
                          law.misfit));
  c_.report.told_elsewhere(*part->second.card);
}

// Shells that are joined to the bag but not of its surface.
void RadiossSurroundings::other_parts() {
  std::map<long, std::pair<int, const DeckCard*>> common;
  for (const RadiossShell& shell : c_.tables.shells) {
    if (c_.panels.contains(shell.part)) continue;
    for (const long node : shell.nodes)
      if (bag_.contains(node)) {
        ++common[shell.part].first;
        common[shell.part].second = shell.card;
      }
  }
  for (const auto& [part, found] : common)
    c_.report.refuse(*found.second, fmt::format("part {} is joined to the bag at {} corners, but is not of "
                                                "its surface: tethers and other parts of "
                                                "shells have no counterpart",
                                                part, found.first));
}

void RadiossSurroundings::read(const DeckCard& card) {
  const std::string_view word = card.keyword;
  const auto begins = [&](std::string_view start) { return word.starts_with(start); };
  if (begins("/XREF/") || begins("/REFSTA_FILE")) return reference(card);
  if (begins("/BCS/")) return hold(card);
  if (begins("/GRAV/")) return pull(card);
  if (begins("/RWALL/PLANE")) return wall(card);
  if (begins("/DAMP/")) return damping(card);
  if (begins("/INTER/TYPE7/")) return layers(card);
}

void RadiossSurroundings::read() {
  for (const Facet& facet : c_.bag.facets) bag_.insert(facet.nodes.begin(), facet.nodes.end());
  for (const DeckCard& card : c_.text.cards) {
    try {
      read(card);
    } catch (const DeckFault& fault) {
      c_.report.refuse(card.keyword, fault.at(), fault.what());
      c_.report.told_elsewhere(card);
    }
  }
  for (const RadiossSpring& spring : c_.tables.springs) {
    try {
      strap(spring);
    } catch (const DeckFault& fault) {
      c_.report.refuse(spring.card->keyword, fault.at(), fault.what());
      c_.report.told_elsewhere(*spring.card);
    }
  }
  other_parts();
}

}  // namespace

void map_surroundings(RadiossContext& context) {
  RadiossSurroundings(context).read();
}

}  // namespace driver::imported
