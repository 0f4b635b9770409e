// SPDX-License-Identifier: Apache-2.0
// Reference geometry, supports, straps, walls, gravity, damping and layers of a Radioss deck.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck_reader.hpp"
#include "radioss_tables.hpp"
#include "surroundings.hpp"

namespace driver::imported {
namespace {

/// One method a kind of card.
class RadiossSurroundings {
 public:
  explicit RadiossSurroundings(RadiossContext& context)
      : c_(context), u_(context.units), around_(context.bag, context.text, context.report) {}
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
  void strap(const DeckLink& spring);
  bool has_group(long group, Place at) const { return around_.has_any(c_.nodes_of_group(group, at)); }

  RadiossContext& c_;
  const Units& u_;
  Surroundings around_;
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
  const auto nodes = around_.own(c_.nodes_of_group(f.whole(2, "grnod_ID"), f.at()));
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
  if (const long group = f.whole(4, "grnod_ID"); group != 0 && !has_group(group, f.at())) return;
  const std::string direction = in_capitals(f.text(1));
  const auto axis = std::string_view("XYZ").find(direction);
  if (direction.size() != 1 || axis == std::string_view::npos)
    throw DeckFault(f.at(), fmt::format("DIR = '{}', allowed: X, Y and Z", direction));
  const double scale = or_one(f.real(7, "Fscale_Y"));
  const long function = f.whole(0, "funct_IDT");
  const Knots factor = function != 0 ? c_.curve(function, u_.time, 1.0, "scene.gravity", f.at()) : Knots{};
  around_.gravity(card, factor,
                  scale * u_.acceleration() * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)));
}

void RadiossSurroundings::wall(const DeckCard& card) {
  const DeckFields f = c_.tens(card, 1);
  const long near = f.whole(2, "grnd_ID1");
  if (near != 0 && !has_group(near, f.at())) return;
  if (f.whole(0, "node_ID") != 0) throw DeckFault(f.at(), "a wall that moves with a node has no counterpart");
  const DeckFields a = c_.twenties(card, 3), b = c_.twenties(card, 4);
  const Eigen::Vector3d from(a.real(0, "XM"), a.real(1, "YM"), a.real(2, "ZM")),
      to(b.real(0, "XM1"), b.real(1, "YM1"), b.real(2, "ZM1"));
  around_.wall(card, from * u_.length, to * u_.length, c_.source(card),
               "a stiff plate by a penalty, without friction");
}

void RadiossSurroundings::damping(const DeckCard& card) {
  const DeckFields f(c_.text, card, line_or_blank(card, 1), {20, 20, 10, 10, 20, 20});
  if (!has_group(f.whole(2, "grnod_ID"), f.at())) return;
  c_.bag.held.mass_damping = f.real(0, "Alpha") / u_.time;
  c_.bag.held.stiffness_damping = f.real(1, "Beta") * u_.time;
  c_.report.became(card, {"membrane.mass_damping", "membrane.stiffness_damping"},
                   c_.bag.held.stiffness_damping > 0.0 ? Mapping::approximated : Mapping::exact,
                   "of the whole bag");
}

// Nodes of the bag against the bag's own surface.
void RadiossSurroundings::layers(const DeckCard& card) {
  const DeckFields f = c_.tens(card, 1), g = c_.twenties(card, 4);
  const auto parts = c_.surface(f.whole(1, "surf_ID"), f.at()).parts;
  if (std::ranges::any_of(parts, [&](long part) { return !c_.panels.contains(part); })) return;
  if (!has_group(f.whole(0, "grnod_ID"), f.at())) return;
  around_.layers(card, g.real(2, "GAPmin") * u_.length, g.real(1, "Fric"), "GAPmin");
}

void RadiossSurroundings::strap(const DeckLink& spring) {
  const auto part = c_.tables.parts.find(spring.part);
  const auto property = part == c_.tables.parts.end() ? c_.tables.properties.end()
                                                      : c_.tables.properties.find(part->second.property);
  if (property == c_.tables.properties.end())
    throw DeckFault(spring.at, fmt::format("the property of part {} is not in the deck", spring.part));
  const DeckCard& card = *property->second;
  if (!card.keyword.starts_with("/PROP/SPRING/") && !card.keyword.starts_with("/PROP/TYPE4/"))
    throw DeckFault(card.at, "is no strap, allowed: springs /PROP/SPRING (TYPE4)");
  const DeckFields k = c_.twenties(card, 2), f = c_.tens(card, 3);
  StrapLaw law{k.real(0, "K") * u_.stiffness(), 0.0, 0.0};
  if (const long function = f.whole(0, "fct_ID11"); function != 0)
    law = strap_law(c_.curve(function, u_.length, u_.force(), "membrane.strap.stiffness", f.at()), f.at());
  around_.strap(spring, law, card, *part->second.card);
}

// Shells that are joined to the bag but not of its surface.
void RadiossSurroundings::other_parts() {
  std::map<long, std::pair<int, const DeckCard*>> common;
  for (const DeckShell& shell : c_.tables.shells) {
    if (c_.panels.contains(shell.part)) continue;
    for (const long node : shell.nodes)
      if (around_.has(node)) {
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
  c_.report.each_card([this](const DeckCard& card) { read(card); });
  around_.straps(c_.tables.springs, [this](const DeckLink& spring) { strap(spring); });
  other_parts();
}

}  // namespace

void map_surroundings(RadiossContext& context) {
  RadiossSurroundings(context).read();
}

}  // namespace driver::imported
