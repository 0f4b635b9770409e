// SPDX-License-Identifier: Apache-2.0
// The monitored volume of a Radioss deck: /MONVOL/AIRBAG1.
#include <fmt/format.h>

#include "radioss_blocks.hpp"

namespace driver {
namespace {

constexpr int gas_material = 1000;  // the first gas; the inflators' gases follow
constexpr int injector = 2000;      // the first injector
constexpr double never = 1e20;      // [s], [Pa] in the deck's units

void gas_card(int id, const DeckGas& gas, const Units& u, Cards& out) {
  out.line(fmt::format("/MAT/GAS/MASS/{}", id));
  out.label(gas.name, 80);
  out.line("#                 MW");
  out.card({real(gas.molar_mass / u.mass, 20)});
  out.line(
      "#                Cpa                 Cpb                 Cpc                 Cpd                 Cpe");
  const auto& a = gas.cp;
  const double unit = u.specific_energy();
  out.card({real(a[0] / unit, 20), real(a[1] / unit, 20), real(a[2] / unit, 20), real(a[3] / unit, 20),
            real(0.0, 20)});
  out.line("#                Cpf");
  out.card({real(a[4] / unit, 20)});
}

void injectors(const Deck& deck, RadiossCards& out) {
  const Units& u = out.units();
  for (std::size_t i = 0; i < deck.inflators.size(); ++i) {
    const DeckInflator& inflator = deck.inflators[i];
    const int number = static_cast<int>(i);
    gas_card(gas_material + 1 + number, inflator.gas, u, out);
    const int flow = out.function(inflator.of_mass ? "mass" : "mass flow", inflator.mass_flow, u.time,
                                  inflator.of_mass ? u.mass : u.mass_flow());
    const int temperature = out.function("temperature", inflator.temperature, u.time, 1.0);
    out.line(fmt::format("/PROP/INJECT1/{}", injector + number));
    out.line("inflator");
    out.line("#  N_gases     Iflow            Ascale_T");
    out.card({whole(1, 10), whole(inflator.of_mass ? 0 : 1, 10), real(1.0, 20)});
    out.line("#   Mat_ID  fun_ID_M  fun_ID_T                      Fscale_M            Fscale_T");
    out.card({whole(gas_material + 1 + number, 10), whole(flow, 10), whole(temperature, 10), blank(10),
              real(1.0, 20), real(1.0, 20)});
  }
}

struct VentFunctions {
  int of_time = 0, of_pressure = 0;
};

void vent_cards(const DeckVent& vent, const VentFunctions& functions, const Units& u, Cards& out) {
  const bool by_curve = vent.of_time || vent.of_overpressure;
  const bool by_pressure = vent.opens_at_overpressure.has_value();
  out.line(
      "# surf_IDv     Iform               Avent               Bvent                              vent_title");
  out.card({whole(0, 10), whole(1, 10), real(by_curve ? vent.area : vent.area / u.area(), 20), real(0.0, 20),
            blank(20), word("vent", 20)});
  out.line(
      "#             Tstart               Tstop               dPdef              dtPdef             IdtPdef");
  out.card({real(by_pressure ? never : vent.opens_at / u.time, 20), real(never, 20),
            real(by_pressure           ? *vent.opens_at_overpressure / u.pressure()
                 : vent.opens_at > 0.0 ? never
                                       : 0.0,
                 20),
            real(0.0, 20), blank(10), whole(0, 10)});
  out.line(
      "#  fct_IDt   fct_IDP   fct_IDA                       Fscalet             FscaleP             FscaleA");
  out.card({whole(functions.of_time, 10), whole(functions.of_pressure, 10), whole(0, 10), blank(10),
            real(1.0, 20), real(1.0, 20), real(1.0, 20)});
  out.line(
      "# fct_IDt'  fct_IDP'  fct_IDA'                      Fscalet'            FscaleP'            FscaleA'");
  out.card(
      {whole(0, 10), whole(0, 10), whole(0, 10), blank(10), real(1.0, 20), real(1.0, 20), real(1.0, 20)});
}

// The material of the part gives the open share of the surface. Its flow never chokes (Graefe's formula).
void leak_cards(const DeckLeak& leak, int surface, int velocity, Cards& out) {
  constexpr int by_velocity = 2, by_share = 3;
  out.line(
      "#surf_IDps   Iformps Iblockage                                                         surface_title");
  out.card({whole(surface, 10), whole(leak.velocity ? by_velocity : by_share, 10), whole(0, 10), blank(50),
            word("fabric", 20)});
  out.line(
      "#             Tstart               Tstop               dPdef              dtPdef             IdtPdef");
  out.card({real(0.0, 20), real(never, 20), real(0.0, 20), real(0.0, 20), blank(10), whole(0, 10)});
  if (!leak.velocity) return;
  out.line("#fct_IDvps                     Fscalevps");
  out.card({whole(velocity, 10), blank(10), real(1.0, 20)});
}

std::vector<VentFunctions> vent_functions(const Deck& deck, RadiossCards& out) {
  const Units& u = out.units();
  std::vector<VentFunctions> all;
  for (const DeckVent& vent : deck.vents) {
    VentFunctions functions;
    if (vent.of_time) functions.of_time = out.function("vent area", *vent.of_time, u.time, u.area());
    if (vent.of_overpressure)
      functions.of_pressure = out.function("vent area", *vent.of_overpressure, u.pressure(), u.area());
    all.push_back(functions);
  }
  return all;
}

std::vector<int> leak_functions(const Deck& deck, RadiossCards& out) {
  const Units& u = out.units();
  std::vector<int> all;
  for (const DeckLeak& leak : deck.leaks) {
    all.push_back(leak.velocity ? out.function("leakage velocity", *leak.velocity, u.pressure(), u.velocity())
                                : 0);
  }
  return all;
}

}  // namespace

void write_radioss_airbag(const Deck& deck, RadiossCards& out) {
  constexpr int leak_surface = 100;
  const Units& u = out.units();
  gas_card(gas_material, deck.initial_gas, u, out);
  injectors(deck, out);
  const auto vents = vent_functions(deck, out);
  const auto leaks = leak_functions(deck, out);
  for (const DeckLeak& leak : deck.leaks) {
    out.line(fmt::format("/SURF/PART/{}", leak_surface + leak.part));
    out.line("porous fabric");
    out.list({leak.part}, 10);
  }
  const gas::Ambient& ambient = deck.scene->ambient;
  out.line("/MONVOL/AIRBAG1/1");
  out.line("bag");
  out.line("#surf_IDex                         Hconv");
  out.card({whole(RadiossIds::bag_surface, 10), blank(10), real(0.0, 20)});
  out.line(
      "#            AscaleT             AscaleP             AscaleS             AscaleA             AscaleD");
  out.card({real(1.0, 20), real(1.0, 20), real(1.0, 20), real(1.0, 20), real(1.0, 20)});
  out.line(
      "#   mat_ID                            Mu                Pext                  T0     Iequi      Ittf");
  constexpr double no_viscosity = 1e-10;  // zero would mean the default, 0.01
  out.card({whole(gas_material, 10), blank(10), real(no_viscosity, 20),
            real(ambient.pressure / u.pressure(), 20), real(deck.scene->gas->initial_temperature, 20),
            whole(0, 10), whole(0, 10)});
  out.line("#     Njet");
  out.card({whole(static_cast<long>(deck.inflators.size()), 10)});
  for (std::size_t i = 0; i < deck.inflators.size(); ++i) {
    out.line("#inject_ID   sens_ID      Ijet  node_ID1  node_ID2  node_ID3");
    out.card({whole(injector + static_cast<long>(i), 10), whole(0, 10), whole(0, 10), whole(0, 10),
              whole(0, 10), whole(0, 10)});
  }
  out.line("#    Nvent  Nporsurf");
  out.card(
      {whole(static_cast<long>(deck.vents.size()), 10), whole(static_cast<long>(deck.leaks.size()), 10)});
  for (std::size_t i = 0; i < deck.vents.size(); ++i) vent_cards(deck.vents[i], vents[i], u, out);
  for (std::size_t i = 0; i < deck.leaks.size(); ++i)
    leak_cards(deck.leaks[i], leak_surface + deck.leaks[i].part, leaks[i], out);
}

}  // namespace driver
