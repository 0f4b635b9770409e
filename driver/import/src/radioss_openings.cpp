// SPDX-License-Identifier: Apache-2.0
// Vents and porous surfaces of a monitored volume.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bag_fabric.hpp"
#include "radioss_inline_gas.hpp"
#include "vent_curves.hpp"

namespace driver::imported {
namespace {

constexpr double never = 1e19;  // [deck's unit] times and pressures above it stand for none

/// Reads the lines after those of the jets.
class RadiossOpenings {
 public:
  RadiossOpenings(RadiossContext& context, std::size_t line) : c_(context), u_(context.units), line_(line) {}
  void read();

 private:
  void vent();
  void opening(BagVent& vent, const DeckFields& f, bool is_inline = false);
  void exchange();
  void porous();
  void leak(long part, long law, const Knots& velocity, Place at);

  RadiossContext& c_;
  const Units& u_;
  std::size_t line_;
};

// When it opens: from Tstart on, or at the overpressure dPdef. The older form has Tstop elsewhere.
void RadiossOpenings::opening(BagVent& vent, const DeckFields& f, bool is_inline) {
  const std::size_t of_pressure = is_inline ? 1 : 2;
  const double start = f.real(0, "Tstart"), stop = is_inline ? 0.0 : f.real(1, "Tstop"),
               pressure = f.real(of_pressure, "dPdef");
  if (stop > 0.0 && stop < never && stop * u_.time < c_.bag.end_time)
    throw DeckFault(f.at(), fmt::format("Tstop = {:g} before the end of the run has no counterpart", stop));
  if (const double delay = f.real(of_pressure + 1, "dtPdef"); delay > 0.0 && delay < never)
    c_.report.note(fmt::format("{}: dtPdef = {:g}: a vent opens at once here when the pressure is reached",
                               c_.text.where(f.at()), delay));
  if (pressure > 0.0 && pressure < never)
    vent.opens_at_overpressure = pressure * u_.pressure();
  else if (start > 0.0 && start < never)
    vent.opens_at = start * u_.time;
  if (vent.opens_at_overpressure && start > 0.0 && start < never)
    c_.report.note(fmt::format("{}: the vent opens at the pressure dPdef, and not also at Tstart",
                               c_.text.where(f.at())));
}

void RadiossOpenings::vent() {
  const DeckCard& card = c_.volume;
  const bool is_inline = has_inline_gas(card);
  const DeckFields head = is_inline ? DeckFields(c_.text, card, line_or_blank(card, line_), {10, 20, 20, 20})
                                    : DeckFields(c_.text, card, line_or_blank(card, line_), {10, 10, 20, 20});
  const long surface = head.whole(0, "surf_IDv"), form = is_inline ? 1 : head.whole(1, "Iform");
  const double given = head.real(is_inline ? 1 : 2, "Avent");
  double area = given * u_.area();
  if (const double stop = is_inline ? head.real(3, "Tstop") : 0.0;
      stop > 0.0 && stop < never && stop * u_.time < c_.bag.end_time)
    throw DeckFault(head.at(),
                    fmt::format("Tstop = {:g} before the end of the run has no counterpart", stop));
  BagVent vent;
  vent.source = c_.text.where(head.at());
  if (surface != 0) {
    area = 0.0;
    for (const long part : c_.surface(surface, head.at()).parts) area += area_of(c_.bag, c_.panels, part);
    area *= given;
    c_.report.note(
        fmt::format("{}: the vent's area is that of surface {} at the start, {:.3g} m2 with its factor, and "
                    "does not change",
                    vent.source, surface, area));
  }
  opening(vent, c_.twenties(card, line_ + 1), is_inline);
  const DeckFields f(c_.text, card, line_or_blank(card, line_ + 2), {10, 10, 10, 10, 20, 20, 20});
  const long of_time = f.whole(0, "fct_IDt"), of_pressure = f.whole(1, "fct_IDP");
  if (f.whole(2, "fct_IDA") != 0)
    throw DeckFault(f.at(), "fct_IDA, an area over that of the surface, has no counterpart");
  if (of_time != 0 && of_pressure != 0)
    throw DeckFault(f.at(), "an area of time and of pressure has no counterpart, allowed: one of them");
  if (of_time != 0) {
    vent.of_time = c_.curve(of_time, u_.time, area * or_one(f.real(4, "Fscalet")), "vent.area", f.at());
    if (vent.opens_at_overpressure)
      throw DeckFault(f.at(), "an area of time with an opening pressure has no counterpart");
    if (vent.opens_at > 0.0) {
      const double at_opening = value_at(vent.of_time, vent.opens_at);
      for (auto& knot : vent.of_time) knot[0] -= vent.opens_at;
      std::erase_if(vent.of_time, [](const auto& knot) { return knot[0] <= 0.0; });
      vent.of_time.insert(vent.of_time.begin(), {0.0, at_opening});
    }
    not_below_zero(vent.of_time, "vent.area", c_.report);
  } else if (of_pressure != 0) {
    vent.of_overpressure =
        c_.curve(of_pressure, u_.pressure(), area * or_one(f.real(5, "FscaleP")), "vent.area", f.at());
    from_rest(vent.of_overpressure);
    not_below_zero(vent.of_overpressure, "vent.area", c_.report);
  } else {
    vent.area = area;
  }
  line_ += 4;
  if (form == 2)
    throw DeckFault(head.at(), "Iform = 2, a velocity of the outflow, has no counterpart, allowed: 1");
  if (form == 3)
    throw DeckFault(head.at(), "Iform = 3, Graefe's formula for a vent, has no counterpart, allowed: 1");
  if (vent.is_open()) c_.bag.vents.push_back(std::move(vent));
}

// The leak of one part by its material: 1, 4 through an orifice, 2 a curve of velocity, 3 Graefe's law.
void RadiossOpenings::leak(long part, long law, const Knots& velocity, Place at) {
  const auto own = c_.tables.parts.find(part);
  const auto panel = c_.panels.find(part);
  if (own == c_.tables.parts.end() || panel == c_.panels.end()) return;
  const auto found = c_.tables.leaks.find(own->second.material);
  if (found == c_.tables.leaks.end()) return;  // the program treats it as tight
  const DeckCard& card = *found->second;
  const long kind = c_.tens(card, 1).whole(0, "Ileakage");
  const DeckFields f = c_.twenties(card, 3);
  double share = 1.0;
  if (kind == 1)
    share = f.real(0, "LC") * f.real(1, "AC");
  else if (kind != 0)
    throw DeckFault(card.at, fmt::format("Ileakage = {} has no counterpart, allowed: 1", kind));
  c_.report.became(card, {"fabric.porosity", "fabric.leak_law"}, Mapping::approximated,
                   "the open share of its parts");
  if (share == 0.0) return;
  if (law == 1 || law == 4) {
    return take_orifice(c_.bag, share * area_of(c_.bag, c_.panels, part),
                        c_.text.where(at) + ", porous part " + panel->second,
                        fmt::format("Iformps = {}: part {}", law, panel->second), c_.report);
  }
  take_leak(c_.bag, law == 2 ? BagLeak::table : BagLeak::screen, velocity, at);
  c_.bag.fabrics[panel->second].open_share = share;
}

void RadiossOpenings::porous() {
  const DeckCard& card = c_.volume;
  const DeckFields head = c_.tens(card, line_);
  const long surface = head.whole(0, "surf_IDps"), law = head.whole(1, "Iformps");
  BagVent timed;
  opening(timed, c_.twenties(card, line_ + 1));
  if (timed.opens_at > 0.0 || timed.opens_at_overpressure)
    throw DeckFault(
        head.at(),
        "fabric that leaks from a time or a pressure on has no counterpart, allowed: from the start");
  line_ += 2;
  Knots velocity;
  if (law == 0) {
    const DeckFields f(c_.text, card, line_or_blank(card, line_++), {20, 20, 10, 10, 20, 20});
    if (f.whole(2, "fct_IDcps") != 0 || f.whole(3, "fct_IDaps") != 0)
      throw DeckFault(f.at(), "leakage by functions (Iformps = 0) has no counterpart");
    BagVent vent;
    vent.area = f.real(0, "Cps") * f.real(1, "Areaps") * u_.area();
    vent.source = c_.text.where(f.at());
    if (vent.area > 0.0) c_.bag.vents.push_back(std::move(vent));
    return;
  }
  if (law == 2) {
    const DeckFields f(c_.text, card, line_or_blank(card, line_++), {10, 10, 20});
    const double factor = or_one(f.real(2, "Fscalevps"));
    velocity =
        c_.curve(f.whole(0, "fct_IDvps"), u_.pressure(), factor * u_.velocity(), "fabric.velocity", f.at());
    from_rest(velocity);
    velocity.front()[1] = 0.0;
  }
  if (law < 1 || law > 4)
    throw DeckFault(head.at(), fmt::format("Iformps = {} has no counterpart, allowed: 0 to 4", law));
  for (const long part : c_.surface(surface, head.at()).parts) leak(part, law, velocity, head.at());
}

void RadiossOpenings::read() {
  const DeckFields f = c_.tens(c_.volume, line_++);
  const long vents = f.whole(0, "Nvent"), surfaces = has_inline_gas(c_.volume) ? 0 : f.whole(1, "Nporsurf");
  constexpr long most = 1000;
  if (vents < 0 || surfaces < 0 || vents > most || surfaces > most)
    throw DeckFault(f.at(), fmt::format("Nvent and Nporsurf, allowed: 0 to {}", most));
  for (long i = 0; i < vents; ++i) vent();
  for (long i = 0; i < surfaces; ++i) porous();
  if (c_.volume.keyword.starts_with("/MONVOL/COMMU")) exchange();
}

// What flows between chambers: freely if they are one.
void RadiossOpenings::exchange() {
  if (c_.tens(c_.volume, line_).whole(0, "Nbag") <= 0) return;
  if (!c_.chambers_are_one)
    throw DeckFault(c_.volume.at,
                    "chambers that exchange gas (Nbag above 0) have no counterpart, allowed: one chamber, "
                    "or all as one by --merge-chambers");
}

}  // namespace

void map_openings(RadiossContext& context, std::size_t first_line) {
  RadiossOpenings(context, first_line).read();
}

}  // namespace driver::imported
