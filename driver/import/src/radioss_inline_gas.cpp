// SPDX-License-Identifier: Apache-2.0
#include "radioss_inline_gas.hpp"

#include <fmt/format.h>

#include "gas/species.hpp"
#include "radioss_injection.hpp"

namespace driver::imported {
namespace {

constexpr double usual_temperature = 295.0;  // [K] the program's default

// The program takes the gas constant of gamma and of cp at the start's temperature.
std::size_t inline_gas(RadiossContext& c, const DeckFields& f) {
  const double unit = c.units.specific_energy(), gamma = f.real(0, "Gamma"), t = c.bag.initial_temperature;
  BagGas gas;
  gas.cp = {f.real(1, "cpa") * unit, f.real(2, "cpb") * unit, f.real(3, "cpc") * unit, 0.0, 0.0};
  const double cp = gas.cp[0] + t * (gas.cp[1] + t * gas.cp[2]);
  if (!(gamma > 1.0) || !(cp > 0.0))
    throw DeckFault(f.at(),
                    fmt::format("Gamma = {:g}, allowed: above 1, with a heat capacity above 0", gamma));
  gas.molar_mass = gas::kMolarGasConstant * gamma / (cp * (gamma - 1.0));
  auto& gases = c.bag.gases;
  for (std::size_t i = 0; i < gases.size(); ++i)
    if (gases[i].molar_mass == gas.molar_mass && gases[i].cp == gas.cp) return i;
  gas.name = fmt::format("gas_{}", gases.size() + 1);
  gases.push_back(std::move(gas));
  return gases.size() - 1;
}

// An injector of three lines, and one more of a jet's functions.
void inline_injector(RadiossContext& c, std::size_t& line) {
  const DeckCard& card = c.volume;
  const DeckFields of_gas = c.twenties(card, line),
                   f(c.text, card, line_or_blank(card, line + 1), {10, 10, 20, 10, 20, 10});
  const bool has_jet = c.tens(card, line + 2).whole(0, "Ijet") > 0;
  line += has_jet ? 4 : 3;
  const long mass = f.whole(0, "fct_IDmas"), heat = f.whole(3, "fct_IDT");
  if (mass == 0 && f.real(2, "Fscalemas") == 0.0) return;
  if (mass == 0)
    throw DeckFault(f.at(), "an injector without a function of mass (fct_IDmas) has no counterpart");
  if (has_jet)
    c.report.note(
        fmt::format("{}: jetting by functions of time, angle and distance (Ijet) has no "
                    "counterpart: this inflator has no jet",
                    c.text.where(f.at())));
  BagInflator inflator;
  inflator.gas.shares = {{inline_gas(c, of_gas), 1.0}};
  inject(c, inflator, mass, or_one(f.real(2, "Fscalemas")), c.units.time, f.whole(1, "Iflow") == 1, f.at());
  const double factor = f.real(4, "FscaleT");
  inflator.temperature = heat != 0
                             ? c.curve(heat, c.units.time, or_one(factor), "inflator.temperature", f.at())
                             : Knots{{0.0, factor > 0.0 ? factor : usual_temperature}};
  inflator.start = start_of_sensor(c, f.whole(5, "sens_ID"), f.at());
  inflator.source = c.text.where(f.at());
  c.bag.inflators.push_back(std::move(inflator));
}

}  // namespace

bool has_inline_gas(const DeckCard& volume) {
  return volume.keyword.starts_with("/MONVOL/AIRBAG/") || volume.keyword.starts_with("/MONVOL/COMMU/");
}

void map_inline_gas(RadiossContext& c) {
  const DeckCard& card = c.volume;
  const DeckFields f(c.text, card, line_or_blank(card, 3), {20, 20, 20, 20, 10, 10});
  require_plain_volume(c, c.twenties(card, 2), f.real(1, "Mu"));
  c.bag.ambient_pressure = f.real(2, "Pext") * c.units.pressure();
  if (!(c.bag.ambient_pressure > 0.0))
    throw DeckFault(f.at(), "Pext is 0, allowed: above 0, as it is the pressure of the gas at the start");
  c.bag.initial_temperature = f.real(3, "T0") > 0.0 ? f.real(3, "T0") : usual_temperature;
  c.bag.initial_gas.shares = {{inline_gas(c, c.twenties(card, 4)), 1.0}};
  const long jets = injectors_of(c, 5);
  std::size_t line = 6;
  for (long i = 0; i < jets; ++i) inline_injector(c, line);
  map_openings(c, line);
}

}  // namespace driver::imported
