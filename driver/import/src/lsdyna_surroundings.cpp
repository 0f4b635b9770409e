// SPDX-License-Identifier: Apache-2.0
// Straps, walls, gravity, damping, layers that touch and the end of an LS-DYNA deck.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lsdyna_context.hpp"
#include "surroundings.hpp"

namespace driver::imported {
namespace {

/// One method a kind of card.
class LsDynaSurroundings {
 public:
  explicit LsDynaSurroundings(LsDynaContext& context)
      : c_(context), u_(context.units), around_(context.bag, context.text, context.report) {}
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
  void strap(const DeckLink& line);
  DeckFields fields(const DeckCard& card, std::size_t line) const {
    return {c_.text, card, line_or_blank(card, line), {10, 10, 10, 10, 10, 10, 10, 10}};
  }
  void pull(const DeckCard& card, long curve, int axis, double acceleration);
  bool is_anchored(long node) const;

  LsDynaContext& c_;
  const Units& u_;
  Surroundings around_;
};

void LsDynaSurroundings::end(const DeckCard& card) {
  if (c_.bag.end_time > 0.0) throw DeckFault(card.at, "stands twice, allowed: once");
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
  const Knots factor = curve != 0 ? c_.curve(curve, u_.time, 1.0, "scene.gravity", card.at) : Knots{};
  around_.gravity(card, factor, -acceleration * u_.acceleration() * Eigen::Vector3d::Unit(axis));
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
  const auto is_own = [&](long part) { return c_.panels.contains(part); };
  const bool pulls =
      of_set ? std::ranges::any_of(entry_of(c_.tables.part_sets, set, "part set", f.at()).members, is_own)
             : is_own(set);
  if (!pulls) return;
  if (direction < 1 || direction > 3)
    throw DeckFault(f.at(), fmt::format("DOF = {}, allowed: 1, 2 and 3", direction));
  pull(card, f.whole(2, "LC"), static_cast<int>(direction) - 1, f.real(3, "ACCEL"));
}

void LsDynaSurroundings::wall(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  const DeckFields who = fields(card, head), where = fields(card, head + 1);
  if (const long set = who.whole(0, "NSID");
      set != 0 && !around_.has_any(entry_of(c_.tables.node_sets, set, "node set", who.at()).members))
    return;
  const Eigen::Vector3d tail(where.real(0, "XT"), where.real(1, "YT"), where.real(2, "ZT")),
      head_of(where.real(3, "XH"), where.real(4, "YH"), where.real(5, "ZH"));
  const double friction = where.real(6, "FRIC");
  around_.wall(card, tail * u_.length, head_of * u_.length, c_.source(card),
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
  around_.layers(card, fields(card, head + 2).real(2, "SST") * u_.length,
                 fields(card, head + 1).real(0, "FS"), "SST");
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
  for (const DeckShell& shell : c_.tables.shells)
    if (std::ranges::find(shell.nodes, node) != shell.nodes.end() && c_.is_rigid(shell.part, held) && held)
      return true;
  return false;
}

void LsDynaSurroundings::strap(const DeckLink& line) {
  if (bool held = false; c_.is_rigid(line.part, held)) return;  // a support, or refused as one that moves
  const auto part = c_.tables.parts.find(line.part);
  if (part == c_.tables.parts.end())
    throw DeckFault(line.at, fmt::format("the part {} is not in the deck", line.part));
  const auto material = c_.tables.materials.find(part->second.material);
  if (material == c_.tables.materials.end())
    throw DeckFault(line.at, fmt::format("the material of part {} is not in the deck", line.part));
  const LsDynaEntry& m = material->second;
  const bool from = around_.has(line.from);
  if (from != around_.has(line.to) && is_weld(m) && is_anchored(from ? line.to : line.from)) {
    c_.bag.held.supports.push_back({{true, true, true}, {from ? line.from : line.to}});
    for (const DeckCard* card : {line.card, m.card, part->second.card})
      c_.report.became(*card, {"membrane.fixed_nodes"}, Mapping::approximated,
                       "stiff beams to held parts hold the bag's nodes");
    return;
  }
  const double length = around_.length_of(line);
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
  around_.strap(line, law, *m.card, *part->second.card);
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
  c_.report.each_card([this](const DeckCard& card) { read(card); });
  if (!(c_.bag.end_time > 0.0) && !c_.report.refused())
    c_.report.refuse(c_.airbag, "the deck has no *CONTROL_TERMINATION, and so no end of the run");
  for (const auto* links : {&c_.tables.springs, &c_.tables.beams, &c_.tables.belts})
    around_.straps(*links, [this](const DeckLink& link) { strap(link); });
}

}  // namespace

void map_surroundings(LsDynaContext& context) {
  LsDynaSurroundings(context).read();
}

}  // namespace driver::imported
