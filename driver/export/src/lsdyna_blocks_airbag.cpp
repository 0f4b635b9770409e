// SPDX-License-Identifier: Apache-2.0
// The airbag of an LS-DYNA deck: *AIRBAG_HYBRID, whose first gas is the initial gas.
#include <fmt/format.h>

#include <algorithm>

#include "export/lsdyna.hpp"
#include "lsdyna_blocks.hpp"

namespace driver {
namespace {

double value_at(const DeckCurve& curve, double x) {
  if (x <= curve.front()[0]) return curve.front()[1];
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto& [x0, y0] = curve[i - 1];
    const auto& [x1, y1] = curve[i];
    if (x <= x1) return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return curve.back()[1];
}

// A curve and its factor in a sum of curves.
struct Term {
  double factor;
  DeckCurve curve;
};

DeckCurve sum_of(const std::vector<Term>& terms) {
  std::vector<double> knots;
  for (const Term& term : terms)
    for (const auto& point : term.curve) knots.push_back(point[0]);
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  DeckCurve sum;
  for (const double x : knots) {
    double y = 0.0;
    for (const Term& term : terms) y += term.factor * value_at(term.curve, x);
    sum.push_back({x, y});
  }
  return sum;
}

DeckCurve open_from(double time, double end) {
  const double jump = 1e-6 * end;
  if (time <= 0.0) return {{0.0, 1.0}, {2.0 * end, 1.0}};
  return {{0.0, 0.0}, {time, 0.0}, {time + jump, 1.0}, {time + 2.0 * end, 1.0}};
}

bool is_plain(const DeckVent& vent) {
  return !vent.of_time && !vent.of_overpressure && vent.opens_at == 0.0 && !vent.opens_at_overpressure;
}

// One vent with its coefficient over time, area over pressure and pressure of opening.
LsDynaVents single(const DeckVent& vent, double end) {
  LsDynaVents vents;
  vents.area = vent.area;
  vents.opens_at_overpressure = vent.opens_at_overpressure.value_or(0.0);
  if (vent.of_overpressure) vents.of_overpressure = sum_of({{vent.area, *vent.of_overpressure}});
  if (vent.of_overpressure) vents.area = 0.0;
  if (vent.of_time && vent.opens_at_overpressure) {
    vents.area = 0.0;
    vents.omissions.push_back(
        {fmt::format("vent.{}", vent.number),
         "its curve begins when a pressure is reached, at a time known only in the run"});
    return vents;
  }
  if (vent.of_time || vent.opens_at > 0.0) {
    const DeckCurve factor = vent.of_time ? *vent.of_time : open_from(vent.opens_at, end);
    double peak = 0.0;
    for (const auto& point : factor) peak = std::max(peak, point[1]);
    vents.area *= peak;
    if (peak > 0.0) vents.of_time = sum_of({{1.0 / peak, factor}});
  }
  return vents;
}

}  // namespace

LsDynaVents lsdyna_vents(const Deck& deck) {
  const double end = deck.scene->time.end;
  if (deck.vents.size() == 1) return single(deck.vents.front(), end);
  LsDynaVents vents;
  std::vector<Term> timed, pressed;
  for (const DeckVent& vent : deck.vents) {
    const bool left_out =
        vent.opens_at_overpressure || (vent.of_overpressure && (vent.opens_at > 0.0 || !deck.leaks.empty()));
    if (left_out)
      vents.omissions.push_back(
          {fmt::format("vent.{}", vent.number),
           vent.opens_at_overpressure ? "with other vents, the airbag cannot have one that opens by pressure"
           : deck.leaks.empty()
               ? "with other vents, the airbag cannot have a later one with a curve of pressure"
               : "with other vents and leaking fabric, the airbag cannot have a vent with a curve of "
                 "pressure"});
    else if (vent.of_overpressure)
      pressed.push_back({vent.area, *vent.of_overpressure});
    else if (is_plain(vent))
      timed.push_back({vent.area, open_from(0.0, end)});
    else
      timed.push_back({vent.area, vent.of_time ? *vent.of_time : open_from(vent.opens_at, end)});
  }
  if (!pressed.empty()) vents.second = sum_of(pressed);
  if (timed.empty()) return vents;
  DeckCurve areas = sum_of(timed);
  for (const auto& point : areas) vents.area = std::max(vents.area, point[1]);
  if (std::ranges::all_of(areas, [&](const auto& point) { return point[1] == vents.area; })) return vents;
  vents.of_time = sum_of({{1.0 / vents.area, areas}});
  return vents;
}

void leave_out_lsdyna_vents(Deck& deck) {
  for (DeckOmission& omission : lsdyna_vents(deck).omissions) deck.omissions.push_back(std::move(omission));
}

namespace {

void gas_cards(const DeckGas& mixture, double initial, const std::array<int, 2>& curves, LsDynaCards& out) {
  const Units& u = out.units();
  const double unit = u.energy() / mixture.molar_mass;  // unit of cp by amount
  out.row({{"LCIDM", whole(curves[0], 10)},
           {"LCIDT", whole(curves[1], 10)},
           {"", blank(10)},
           {"MW", narrow(mixture.molar_mass / u.mass)},
           {"INITM", narrow(initial)},
           {"A", narrow(mixture.parabola[0] / unit)},
           {"B", narrow(mixture.parabola[1] / unit)},
           {"C", narrow(mixture.parabola[2] / unit)}});
  out.row({{"FMASS", narrow(0.0)}});
}

}  // namespace

void write_lsdyna_airbag(const Deck& deck, LsDynaCards& out) {
  const Units& u = out.units();
  const Scene& scene = *deck.scene;
  const double start_temperature = scene.gas->initial_temperature;
  const LsDynaVents vents = lsdyna_vents(deck);
  std::vector<std::array<int, 2>> flows{{0, 0}};  // first, without inflow: the gas in the bag at the start
  for (const DeckInflator& inflator : deck.inflators) {
    const int flow = out.next_curve();
    flows.push_back({flow, out.next_curve()});
    out.curve(flows.back()[0], inflator.mass_flow, u.time, u.mass_flow(), 0, inflator.title);
    out.curve(flows.back()[1], inflator.temperature, u.time, 1.0);
  }
  const int coefficient = vents.of_time ? out.next_curve() : 0,
            area = vents.of_overpressure ? out.next_curve() : 0, second = vents.second ? out.next_curve() : 0;
  if (vents.of_time) out.curve(coefficient, *vents.of_time, u.time, 1.0);
  if (vents.of_overpressure)
    out.curve_of_pressure(area, *vents.of_overpressure, scene.ambient.pressure, u.area());
  if (vents.second) out.curve_of_pressure(second, *vents.second, scene.ambient.pressure, u.area());
  const double density =
      scene.ambient.pressure * deck.initial_gas.molar_mass / (gas::kMolarGasConstant * start_temperature);
  out.keyword("AIRBAG_HYBRID_ID");
  out.line(fmt::format("{:>10}{}", 1, "bag"));
  out.row({{"SID", whole(LsDynaIds::bag_parts, 10)},
           {"SIDTYP", whole(1, 10)},
           {"RBID", whole(0, 10)},
           {"VSCA", narrow(1.0)},
           {"PSCA", narrow(1.0)},
           {"VINI", narrow(0.0)},
           {"MWD", narrow(0.0)},
           {"SPSF", narrow(0.0)}});
  out.row({{"ATMOST", narrow(start_temperature)},
           {"ATMOSP", narrow(scene.ambient.pressure / u.pressure())},
           {"ATMOSD", narrow(density / u.density())},
           {"GC", narrow(gas::kMolarGasConstant / u.energy())},
           {"CC", narrow(1.0)},
           {"HCONV", narrow(0.0)}});
  out.row({{"C23", narrow(vents.of_time ? 0.0 : 1.0)},
           {"LCC23", whole(coefficient, 10)},
           {"A23", narrow(vents.area / u.area())},
           {"LCA23", whole(area, 10)},
           {"CP23", narrow(vents.second ? 1.0 : 0.0)},
           {"LCCP23", whole(0, 10)},
           {"AP23", narrow(0.0)},
           {"LCAP23", whole(second, 10)}});
  constexpr int by_share = 3, by_velocity = 7;  // of MAT_FABRIC
  const int leakage = deck.leaks.empty() ? 0 : deck.leaks.front().velocity ? by_velocity : by_share;
  out.row({{"OPT", whole(leakage, 10)},
           {"PVENT", narrow(vents.opens_at_overpressure / u.pressure())},
           {"NGAS", whole(static_cast<long>(flows.size()), 10)},
           {"LCEFR", whole(0, 10)},
           {"LCIDM0", whole(0, 10)},
           {"VNTOPT", whole(0, 10)}});
  gas_cards(deck.initial_gas, 1.0, flows.front(), out);
  for (std::size_t i = 0; i < deck.inflators.size(); ++i)
    gas_cards(deck.inflators[i].gas, 0.0, flows[i + 1], out);
}

}  // namespace driver
