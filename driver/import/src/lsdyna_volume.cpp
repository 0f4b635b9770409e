// SPDX-License-Identifier: Apache-2.0
// The control volume of an LS-DYNA deck, and what holds it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lsdyna_context.hpp"

namespace driver::imported {
namespace {

std::vector<long> sorted(std::vector<long> nodes) {
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void claim_mesh(LsDynaContext& c) {
  claim_shells(c.tables.shells, c.panels, c.report);
  for (const auto& [part, panel] : c.panels)
    if (const auto found = c.tables.parts.find(part);
        found != c.tables.parts.end() && !c.report.told(*found->second.card))
      c.report.became(*found->second.card, {"membrane.mesh.file"}, Mapping::exact, "panels of the mesh");
}

void take_part(LsDynaContext& c, long part) {
  const auto found = c.tables.parts.find(part);
  if (!c.panels.contains(part))
    c.panels[part] = panel_name(found == c.tables.parts.end() ? "" : found->second.title, part, c.panels);
}

void facets_of_parts(LsDynaContext& c, const LsDynaSet& set) {
  for (const long part : set.members) take_part(c, part);
  for (const DeckShell& shell : c.tables.shells)
    if (const auto panel = c.panels.find(shell.part); panel != c.panels.end())
      c.bag.facets.push_back({shell.nodes, panel->second, shell.at});
}

// A segment on a shell is fabric of its part; one without closes a hole.
void facets_of_segments(LsDynaContext& c, const LsDynaSet& set) {
  std::map<std::vector<long>, const DeckShell*> by_nodes;
  for (const DeckShell& shell : c.tables.shells) by_nodes[sorted(shell.nodes)] = &shell;
  std::size_t caps = 0;
  for (const Facet& segment : set.segments) {
    const auto found = by_nodes.find(sorted(segment.nodes));
    Facet facet = segment;
    if (found != by_nodes.end()) {
      take_part(c, found->second->part);
      facet.panel = c.panels.at(found->second->part);
      facet.nodes = found->second->nodes;
    } else {
      facet.panel = "segments";
      ++caps;
    }
    c.bag.facets.push_back(std::move(facet));
  }
  if (caps == 0) return;
  c.bag.null_panels.emplace_back("segments");
  c.report.note(fmt::format(
      "{} segments of the control volume have no shell: they close it as the null panel segments", caps));
}

void take_reference(LsDynaContext& c) {
  for (const DeckCard& card : c.text.cards) {
    const bool by_shell = card.keyword.starts_with("*AIRBAG_SHELL_REFERENCE_GEOMETRY");
    if (by_shell) {
      c.report.refuse(
          card, "a reference geometry by shells is not read; allowed: *AIRBAG_REFERENCE_GEOMETRY, by nodes");
      continue;
    }
    if (!card.keyword.starts_with("*AIRBAG_REFERENCE_GEOMETRY")) continue;
    std::size_t first = card.keyword.ends_with("_ID") ? 1 : 0;
    if (card.keyword.find("_BIRTH") != std::string::npos) ++first;
    for (const DeckLine* line : filled(card, first)) {
      const DeckFields f(c.text, card, *line, {8, 16, 16, 16});
      c.bag.reference[f.whole(0, "NID")] =
          Eigen::Vector3d(f.real(1, "X"), f.real(2, "Y"), f.real(3, "Z")) * c.units.length;
    }
    c.report.became(card, {"membrane.mesh.initial_file"}, Mapping::exact,
                    "the stress-free shape; *NODE has the start");
  }
}

}  // namespace

void map_volume(LsDynaContext& c, long set, bool is_part_set) {
  take_nodes(c.tables.nodes, c.units.length, c.bag, c.report);
  take_reference(c);
  const auto& sets = is_part_set ? c.tables.part_sets : c.tables.segment_sets;
  const auto found = sets.find(set);
  if (found == sets.end())
    return c.report.refuse(c.airbag, fmt::format("SID = {} is no set of {} in this deck", set,
                                                 is_part_set ? "parts" : "segments"));
  if (is_part_set)
    facets_of_parts(c, found->second);
  else
    facets_of_segments(c, found->second);
  c.report.became(*found->second.card, {"membrane.mesh.file"}, Mapping::exact,
                  "the surface of the control volume");
  claim_mesh(c);
}

namespace {

/// Nodes of the bag that other cards of the deck hold or move.
class LsDynaSupports {
 public:
  explicit LsDynaSupports(LsDynaContext& context) : c_(context), bag_(nodes_of(context.bag)) {}
  void read();

 private:
  void hold(std::array<bool, 3> along, const std::vector<long>& nodes);
  void constraints();
  void boundary(const DeckCard& card);
  void rigid_parts();
  void rigid_groups(const DeckCard& card);
  void moved(const DeckCard& card);
  std::vector<long> of_bag(const std::vector<long>& nodes) const {
    std::vector<long> own;
    std::ranges::copy_if(nodes, std::back_inserter(own), [&](long node) { return bag_.contains(node); });
    return own;
  }

  LsDynaContext& c_;
  std::set<long> bag_;
};

void LsDynaSupports::hold(std::array<bool, 3> along, const std::vector<long>& nodes) {
  if (nodes.empty() || along == std::array{false, false, false}) return;
  c_.bag.held.supports.push_back({along, nodes});
}

// Codes of translations: 1 x, 2 y, 3 z, 4 xy, 5 yz, 6 zx, 7 all.
std::array<bool, 3> axes_of(long code) {
  return {code == 1 || code == 4 || code == 6 || code == 7, code == 2 || code == 4 || code == 5 || code == 7,
          code == 3 || code == 5 || code == 6 || code == 7};
}

void LsDynaSupports::constraints() {
  std::map<long, std::vector<long>> by_code;
  for (const auto& [node, code] : c_.tables.held)
    if (bag_.contains(node)) by_code[code].push_back(node);
  for (const auto& [code, nodes] : by_code) hold(axes_of(code), nodes);
}

void LsDynaSupports::boundary(const DeckCard& card) {
  const bool by_set = card.keyword.starts_with("*BOUNDARY_SPC_SET");
  bool held = false;
  for (const DeckLine* line : filled(card, head_lines(card))) {
    const DeckFields f(c_.text, card, *line, {10, 10, 10, 10, 10, 10, 10, 10});
    std::vector<long> nodes{f.whole(0, "NID")};
    if (by_set) {
      const LsDynaSet& set = entry_of(c_.tables.node_sets, nodes.front(), "node set", line->at);
      nodes = set.members;
      if (!of_bag(nodes).empty())
        c_.report.became(*set.card, {"membrane.fixed_nodes"}, Mapping::exact, "held nodes");
    }
    nodes = of_bag(nodes);
    if (nodes.empty()) continue;
    if (const long system = f.whole(1, "CID"); system != 0)
      throw DeckFault(line->at, fmt::format("CID = {}: axes of a local system have no counterpart", system));
    const std::array<bool, 3> along{f.whole(2, "DOFX") != 0, f.whole(3, "DOFY") != 0,
                                    f.whole(4, "DOFZ") != 0};
    hold(along, nodes);
    held = true;
  }
  if (held)
    c_.report.became(card, {"membrane.fixed_nodes", "membrane.roller"}, Mapping::exact,
                     "nodes by number; turns need none");
}

// A rigid part that is held holds the nodes that it has in common with the bag. One that moves, or a part of
// fabric or another material that the control volume does not have, is more than supports.
void LsDynaSupports::rigid_parts() {
  std::map<long, std::vector<long>> common;
  for (const DeckShell& shell : c_.tables.shells)
    for (const long node : of_bag(shell.nodes)) common[shell.part].push_back(node);
  for (const auto& [node, part] : c_.tables.part_of_solid_node)
    if (bag_.contains(node)) common[part].push_back(node);
  for (const DeckLink& beam : c_.tables.beams) {
    bool held = false;
    if (c_.is_rigid(beam.part, held))
      for (const long node : of_bag({beam.from, beam.to})) common[beam.part].push_back(node);
  }
  for (const auto& [part, nodes] : common) {
    bool held = false;
    const bool rigid = c_.is_rigid(part, held);
    if (!rigid && c_.panels.contains(part)) continue;
    const auto found = c_.tables.parts.find(part);
    const std::string title = found == c_.tables.parts.end() ? "" : found->second.title;
    const Place at = found == c_.tables.parts.end() ? c_.airbag.at : found->second.card->at;
    if (!rigid) {
      c_.report.refuse(
          "*PART", at,
          fmt::format(
              "part {} ({}) is joined to the bag at {} nodes, but is not in its control volume: tethers "
              "and other parts of shells or solids have no counterpart",
              part, title, sorted(nodes).size()));
    } else if (!held) {
      c_.report.refuse(
          "*PART", at,
          fmt::format("the rigid part {} ({}) is joined to the bag at {} nodes and can move, which has no "
                      "counterpart; allowed: CMO = 1 with CON1 = 7",
                      part, title, sorted(nodes).size()));
    } else {
      hold({true, true, true}, sorted(nodes));
      c_.report.became(*c_.material_of(part)->card, {"membrane.fixed_nodes"}, Mapping::exact,
                       fmt::format("the rigid part {} ({}) holds the bag's nodes that it has", part, title));
    }
  }
}

// Nodes that move as one body.
void LsDynaSupports::rigid_groups(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  const bool of_nodes = card.keyword.starts_with("*CONSTRAINED_NODAL_RIGID_BODY");
  const DeckFields f(c_.text, card, line_or_blank(card, head), {10, 10, 10});
  const long set = f.whole(of_nodes                                               ? 2
                           : card.keyword.starts_with("*CONSTRAINED_EXTRA_NODES") ? 1
                                                                                  : 0,
                           "NSID");
  const auto found = c_.tables.node_sets.find(set);
  const std::vector<long> nodes = card.keyword.starts_with("*CONSTRAINED_EXTRA_NODES_NODE") ? std::vector{set}
                                  : found != c_.tables.node_sets.end() ? found->second.members
                                                                       : std::vector<long>{};
  if (const auto own = of_bag(nodes); !own.empty())
    throw DeckFault(card.at,
                    fmt::format("{} nodes of the bag move as part of a rigid body, which has no counterpart",
                                own.size()));
}

void LsDynaSupports::moved(const DeckCard& card) {
  const auto lines = filled(card, head_lines(card));
  if (lines.empty()) return;
  const long id = DeckFields(c_.text, card, *lines.front(), {10}).whole(0, "NID");
  const bool of_set = card.keyword.find("_SET") != std::string::npos;
  const auto set = c_.tables.node_sets.find(id);
  const bool moves =
      of_set ? set != c_.tables.node_sets.end() && !of_bag(set->second.members).empty() : bag_.contains(id);
  if (moves)
    throw DeckFault(lines.front()->at, "nodes of the bag move as prescribed, which has no counterpart");
}

void LsDynaSupports::read() {
  constraints();
  c_.report.each_card([&](const DeckCard& card) {
    const auto begins = [&](const char* word) { return card.keyword.starts_with(word); };
    if (begins("*BOUNDARY_SPC_NODE") || begins("*BOUNDARY_SPC_SET")) boundary(card);
    if (begins("*CONSTRAINED_NODAL_RIGID_BODY") || begins("*CONSTRAINED_EXTRA_NODES") ||
        begins("*CONSTRAINED_NODE_SET"))
      rigid_groups(card);
    if (begins("*BOUNDARY_PRESCRIBED_MOTION")) moved(card);
  });
  rigid_parts();
}

}  // namespace

void map_supports(LsDynaContext& context) {
  LsDynaSupports(context).read();
}

}  // namespace driver::imported
