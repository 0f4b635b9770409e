// SPDX-License-Identifier: Apache-2.0
// Straps, walls, gravity, damping, layers that touch and the end of an LS-DYNA deck.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lsdyna_context.hpp"
#include "strap_curves.hpp"

namespace driver::imported {
namespace {

/// One method a kind of card.
class LsDynaSurroundings {
 public:
  explicit LsDynaSurroundings(LsDynaContext& context) : c_(context), u_(context.units) {}
  void read();

 private:
  void read(const DeckCard& card);
  void end(const DeckCard& card);
  void history(const DeckCard& card);
  void body_load(const DeckCard& card, int axis);
  void gravity_of_parts(const DeckCard& card);
  void wall(const DeckCard& card);
  void damping(const DeckCard& card);
  void layers(const DeckCard& card);
  void straps(const std::vector<LsDynaLine>& lines);
  void strap(const LsDynaLine& line, bool from, bool to);
  DeckFields fields(const DeckCard& card, std::size_t line) const {
    return {c_.text, card, line_or_blank(card, line), {10, 10, 10, 10, 10, 10, 10, 10}};
  }
  void pull(const DeckCard& card, long curve, int axis, double acceleration);
  bool is_anchored(long node) const;
  bool of_bag(long node) const { return bag_.contains(node); }

  LsDynaContext& c_;
  const Units& u_;
  std::set<long> bag_;
};

void LsDynaSurroundings::end(const DeckCard& card) {
  c_.bag.end_time = fields(card, 0).real(0, "ENDTIM") * u_.time;
  if (!(c_.bag.end_time > 0.0)) throw DeckFault(card.at, "ENDTIM is 0, allowed: above 0");
  c_.report.became(card, {"scene.end_time"}, Mapping::exact);
}

void LsDynaSurroundings::history(const DeckCard& card) {
  const double interval = fields(card, 0).real(0, "DT") * u_.time;
  if (interval > 0.0) c_.bag.history_every = interval;
  c_.report.became(card, {"output.history_every"}, Mapping::exact);
}

// The curve gives a factor over time; only a constant one has a counterpart.
void LsDynaSurroundings::pull(const DeckCard& card, long curve, int axis, double acceleration) {
  double factor = 1.0;
  std::string how = "acceleration of everything that moves";
  if (curve != 0) {
    const Knots knots = c_.curve(curve, u_.time, 1.0, "scene.gravity", card.at);
    factor = knots.back()[1];
    for (const auto& knot : knots)
      if (knot[1] != factor)
        how = fmt::format("constant from the start with the factor {:g} of the curve's end", factor);
  }
  c_.bag.gravity[axis] += -factor * acceleration * u_.acceleration();
  c_.report.became(card, {"scene.gravity"}, how.starts_with("acc") ? Mapping::exact : Mapping::approximated,
                   how);
}

void LsDynaSurroundings::body_load(const DeckCard& card, int axis) {
  const DeckFields f = fields(card, 0);
  const double factor = f.real(1, "SF", 1.0);
  pull(card, f.whole(0, "LCID"), axis, factor);
}

void LsDynaSurroundings::gravity_of_parts(const DeckCard& card) {
  const DeckFields f = fields(card, head_lines(card));
  const long set = f.whole(0, "PSID"), direction = f.whole(1, "DOF");
  const bool of_set = card.keyword.find("_SET") != std::string::npos;
  const auto found = c_.tables.part_sets.find(set);
  if (of_set && found == c_.tables.part_sets.end())
    throw DeckFault(f.at(), fmt::format("names the part set {}, which the deck does not have", set));
  const bool pulls = of_set ? found != c_.tables.part_sets.end() &&
                                  std::ranges::any_of(found->second.members,
                                                      [&](long part) { return c_.panels.contains(part); })
                            : c_.panels.contains(set);
  if (!pulls) return;
  if (direction < 1 || direction > 3)
    throw DeckFault(f.at(), fmt::format("DOF = {}, allowed: 1, 2 and 3", direction));
  pull(card, f.whole(2, "LC"), static_cast<int>(direction) - 1, f.real(3, "ACCEL"));
}

void LsDynaSurroundings::wall(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  const DeckFields who = fields(card, head), where = fields(card, head + 1);
  if (const long set = who.whole(0, "NSID"); set != 0) {
    const auto found = c_.tables.node_sets.find(set);
    if (found == c_.tables.node_sets.end())
      throw DeckFault(who.at(), fmt::format("names the node set {}, which the deck does not have", set));
    const bool touches = found != c_.tables.node_sets.end() &&
                         std::ranges::any_of(found->second.members, [&](long node) { return of_bag(node); });
    if (!touches) return;
  }
  const Eigen::Vector3d tail(where.real(0, "XT"), where.real(1, "YT"), where.real(2, "ZT")),
      head_of(where.real(3, "XH"), where.real(4, "YH"), where.real(5, "ZH"));
  if (!((head_of - tail).norm() > 0.0))
    throw DeckFault(where.at(), "tail and head of the wall's normal are at one place");
  if (c_.bag.held.wall)
    return c_.report.left_out(card, Mapping::none, "a case has one plate: this one is left out");
  c_.bag.held.wall = BagWall{tail * u_.length, (head_of - tail).normalized(), c_.source(card)};
  const double friction = where.real(6, "FRIC");
  c_.report.became(card, {"membrane.plate.point", "membrane.plate.normal"}, Mapping::approximated,
                   friction > 0.0
                       ? fmt::format("a stiff plate by a penalty, without the friction FRIC = {:g}", friction)
                       : "a stiff plate by a penalty");
}

void LsDynaSurroundings::damping(const DeckCard& card) {
  const std::string& word = card.keyword;
  const DeckFields f = fields(card, head_lines(card));
  const bool of_bag_parts = c_.panels.contains(f.whole(0, "PID"));
  if (word.starts_with("*DAMPING_GLOBAL")) {
    if (const long curve = f.whole(0, "LCID"); curve != 0)
      throw DeckFault(f.at(), "damping over time has no counterpart, allowed: VALDMP");
    c_.bag.held.mass_damping = f.real(1, "VALDMP") / u_.time;
    return c_.report.became(card, {"membrane.mass_damping"}, Mapping::exact);
  }
  if (!of_bag_parts) return;
  if (word.starts_with("*DAMPING_PART_MASS")) {
    const Knots knots = c_.curve(f.whole(1, "LCID"), u_.time, 1.0, "membrane.mass_damping", f.at());
    c_.bag.held.mass_damping =
        std::max(c_.bag.held.mass_damping, f.real(2, "SF", 1.0) * knots.front()[1] / u_.time);
    c_.report.became(card, {"membrane.mass_damping"}, Mapping::exact, "of the whole bag");
  } else if (word.starts_with("*DAMPING_PART_STIFFNESS")) {
    const double coefficient = f.real(1, "COEF");
    if (coefficient >= 0.0)
      return c_.report.left_out(
          card, Mapping::none,
          "COEF above 0 is a share of the damping at high frequency, which has no counterpart");
    c_.bag.held.stiffness_damping = -coefficient * u_.time;
    c_.report.became(card, {"membrane.stiffness_damping"}, Mapping::approximated);
  }
}

// The thickness that pushes layers apart.
void LsDynaSurroundings::layers(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  const double thickness = fields(card, head + 2).real(2, "SST") * u_.length;
  if (!(thickness > 0.0))
    return c_.report.left_out(card, Mapping::none,
                              "no thickness (SST) is given, so layers pass through each other; set "
                              "[membrane.self_contact] thickness by hand");
  c_.bag.held.layer_thickness = thickness;
  c_.bag.held.layer_friction = fields(card, head + 1).real(0, "FS");
  c_.report.became(card, {"membrane.self_contact", "membrane.self_contact.thickness"}, Mapping::approximated,
                   "pressure between layers with the program's own penalty");
}

// A beam of a stiff material.
bool is_weld(const LsDynaEntry& material) {
  for (const char* word : {"*MAT_SPOTWELD", "*MAT_100", "*MAT_ELASTIC", "*MAT_001"})
    if (is_keyword(*material.card, word)) return true;
  return false;
}

// True for a node of a rigid part that cannot move.
bool LsDynaSurroundings::is_anchored(long node) const {
  bool held = false;
  const auto solid = c_.tables.part_of_solid_node.find(node);
  if (solid != c_.tables.part_of_solid_node.end()) return c_.is_rigid(solid->second, held) && held;
  for (const LsDynaShell& shell : c_.tables.shells)
    if (std::ranges::find(shell.nodes, node) != shell.nodes.end() && c_.is_rigid(shell.part, held) && held)
      return true;
  return false;
}

void LsDynaSurroundings::strap(const LsDynaLine& line, bool from, bool to) {
  const auto part = c_.tables.parts.find(line.part);
  if (part == c_.tables.parts.end())
    throw DeckFault(line.at, fmt::format("the part {} is not in the deck", line.part));
  const auto material = c_.tables.materials.find(part->second.material);
  if (material == c_.tables.materials.end())
    throw DeckFault(line.at, fmt::format("the material of part {} is not in the deck", line.part));
  const LsDynaEntry& m = material->second;
  if (from != to && is_weld(m) && is_anchored(from ? line.to : line.from)) {
    c_.bag.held.supports.push_back({{true, true, true}, {from ? line.from : line.to}});
    c_.report.became(*line.card, {"membrane.fixed_nodes"}, Mapping::approximated,
                     "stiff beams to held parts hold the bag's nodes");
    c_.report.told_elsewhere(*m.card);
    return;
  }
  if (!from || !to)
    throw DeckFault(
        line.at, "joins the bag to something else, which has no counterpart; allowed: two nodes of the bag");
  const double length = (c_.bag.nodes.at(line.to) - c_.bag.nodes.at(line.from)).norm();
  StrapLaw law;
  if (is_keyword(*m.card, "*MAT_SPRING_ELASTIC") || is_keyword(*m.card, "*MAT_S01"))
    law = {c_.real(m, 0, 1, "K") * u_.stiffness(), 0.0, 0.0};
  else if (is_keyword(*m.card, "*MAT_SPRING_NONLINEAR_ELASTIC") || is_keyword(*m.card, "*MAT_S04"))
    law = strap_law(
        c_.curve(c_.whole(m, 0, 1, "LCD"), u_.length, u_.force(), "membrane.strap.stiffness", line.at),
        line.at);
  else if (is_keyword(*m.card, "*MAT_SEATBELT") || is_keyword(*m.card, "*MAT_B01")) {
    law = strap_law(
        c_.curve(c_.whole(m, 0, 2, "LLCID"), 1.0, u_.force(), "membrane.strap.stiffness", line.at), line.at);
    law.stiffness /= length;
    law.slack *= length;
  } else {
    throw DeckFault(
        line.at,
        fmt::format(
            "{} is no strap, allowed: springs *MAT_SPRING_ELASTIC and _NONLINEAR_ELASTIC, and *MAT_SEATBELT",
            m.card->keyword));
  }
  c_.bag.held.straps.push_back({line.from, line.to, law.stiffness, length + law.slack,
                                fmt::format("{} {}", c_.text.where(line.at), line.card->keyword)});
  const std::string how =
      law.misfit > 1e-9
          ? fmt::format("a linear strap without compression: off by up to {:.2g} of the largest force",
                        law.misfit)
          : "a linear strap without compression";
  const Mapping mapping = law.misfit > 1e-9 ? Mapping::approximated : Mapping::exact;
  c_.report.became(*line.card, {"membrane.strap.from_node", "membrane.strap.to_node"}, Mapping::exact,
                   "straps by node");
  c_.report.became(*m.card, {"membrane.strap.stiffness", "membrane.strap.free_length"}, mapping, how);
  c_.report.told_elsewhere(*part->second.card);
}

void LsDynaSurroundings::straps(const std::vector<LsDynaLine>& lines) {
  for (const LsDynaLine& line : lines) {
    const bool from = of_bag(line.from), to = of_bag(line.to);
    if (!from && !to) continue;
    if (bool held = false; c_.is_rigid(line.part, held)) continue;  // a support, or refused as one that moves
    try {
      strap(line, from, to);
    } catch (const DeckFault& fault) {
      c_.report.refuse(line.card->keyword, fault.at(), fault.what());
      c_.report.told_elsewhere(*line.card);
    }
  }
}

void LsDynaSurroundings::read(const DeckCard& card) {
  const std::string_view word = card.keyword;
  const auto begins = [&](std::string_view start) { return word.starts_with(start); };
  if (word == "*CONTROL_TERMINATION") return end(card);
  if (word == "*DATABASE_ABSTAT") return history(card);
  if (word == "*LOAD_BODY_X" || word == "*LOAD_BODY_Y" || word == "*LOAD_BODY_Z")
    return body_load(card, word.back() - 'X');
  if (begins("*LOAD_GRAVITY_PART")) return gravity_of_parts(card);
  if (begins("*RIGIDWALL_PLANAR")) return wall(card);
  if (begins("*DAMPING_")) return damping(card);
  if (begins("*CONTACT_AIRBAG_SINGLE_SURFACE")) return layers(card);
}

void LsDynaSurroundings::read() {
  for (const Facet& facet : c_.bag.facets) bag_.insert(facet.nodes.begin(), facet.nodes.end());
  for (const DeckCard& card : c_.text.cards) {
    try {
      read(card);
    } catch (const DeckFault& fault) {
      c_.report.refuse(card.keyword, fault.at(), fault.what());
      c_.report.told_elsewhere(card);
    }
  }
  if (!(c_.bag.end_time > 0.0) && !c_.report.refused())
    c_.report.refuse(c_.airbag, "the deck has no *CONTROL_TERMINATION, and so no end of the run");
  straps(c_.tables.springs);
  straps(c_.tables.beams);
  straps(c_.tables.belts);
}

}  // namespace

void map_surroundings(LsDynaContext& context) {
  LsDynaSurroundings(context).read();
}

}  // namespace driver::imported
