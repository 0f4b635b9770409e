// SPDX-License-Identifier: Apache-2.0
// Gas and inflators of /MONVOL/AIRBAG1, /MONVOL/COMMU1 of one chamber and /MONVOL/GAS.
#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

#include "deck_reader.hpp"
#include "gas/species.hpp"
#include "radioss_injection.hpp"
#include "radioss_inline_gas.hpp"

namespace driver::imported {
namespace {

/// Reads gases, injectors and the volume's own lines.
class RadiossGas {
 public:
  explicit RadiossGas(RadiossContext& context) : c_(context), u_(context.units), bag_(context.bag) {}
  void airbag();
  void simple_gas();

 private:
  std::size_t gas(long material, Place at);
  void polynomial(const DeckCard& card, bool by_mole, BagGas& gas);
  void injector(long property, double start, Place at);
  void first_injector(const DeckCard& card, double start);
  void second_injector(const DeckCard& card, double start);

  RadiossContext& c_;
  const Units& u_;
  BagDeck& bag_;
};

constexpr std::array<std::array<const char*, 2>, 13> predefined{{{"N2", "N2"},
                                                                 {"O2", "O2"},
                                                                 {"CO2", "CO2"},
                                                                 {"CO", "CO"},
                                                                 {"H2", "H2"},
                                                                 {"H2O", "H2O"},
                                                                 {"AR", "Ar"},
                                                                 {"HE", "He"},
                                                                 {"NO", "NO"},
                                                                 {"N2O", "N2O"},
                                                                 {"NH3", "NH3"},
                                                                 {"CH4", "CH4"},
                                                                 {"AIR", "air"}}};

// cp = a + b T + c T^2 + d T^3 + e/T^2 + f T^4; with e, the nearest polynomial without it.
void RadiossGas::polynomial(const DeckCard& card, bool by_mole, BagGas& gas) {
  gas.molar_mass = c_.twenties(card, 1).real(0, "MW") * u_.mass;
  if (!(gas.molar_mass > 0.0)) throw DeckFault(card.at, "MW is 0, allowed: above 0");
  const double unit = by_mole ? u_.energy() / gas.molar_mass : u_.specific_energy();
  const DeckFields f = c_.twenties(card, 2);
  gas.cp = {f.real(0, "Cpa") * unit, f.real(1, "Cpb") * unit, f.real(2, "Cpc") * unit,
            f.real(3, "Cpd") * unit, by_mole ? 0.0 : c_.twenties(card, 3).real(0, "Cpf") * unit};
  const double inverse = f.real(4, "Cpe") * unit;
  if (inverse == 0.0) return;
  constexpr int points = 181;
  constexpr double low = 200.0, step = 10.0, scale = 1e-3;
  constexpr std::array powers{1.0, scale, scale * scale, scale * scale * scale,
                              scale * scale * scale * scale};
  Eigen::Matrix<double, points, 5> terms;
  Eigen::Matrix<double, points, 1> values;
  for (int i = 0; i < points; ++i) {
    const double t = low + step * i;
    double power = 1.0;
    values(i) = inverse / (t * t);
    for (int j = 0; j < 5; ++j, power *= t * scale) {
      terms(i, j) = power;
      values(i) += gas.cp[static_cast<std::size_t>(j)] * power / powers[static_cast<std::size_t>(j)];
    }
  }
  const Eigen::Matrix<double, 5, 1> fit = terms.colPivHouseholderQr().solve(values);
  const double misfit = ((terms * fit - values).array() / values.array()).abs().maxCoeff();
  for (int j = 0; j < 5; ++j)
    gas.cp[static_cast<std::size_t>(j)] = fit(j) * powers[static_cast<std::size_t>(j)];
  c_.report.note(fmt::format(
      "{}: the term Cpe/T^2 has no counterpart: a polynomial fits cp within {:.2g} from 200 to 2000 K",
      c_.text.where(card.at), misfit));
}

std::size_t RadiossGas::gas(long material, Place at) {
  const std::string name = fmt::format("gas_{}", material);
  if (const auto known = std::ranges::find(bag_.gases, name, &BagGas::name); known != bag_.gases.end())
    return static_cast<std::size_t>(known - bag_.gases.begin());
  const DeckCard& card = *entry_of(c_.tables.materials, material, "gas", at);
  const auto words = words_of(card);
  const std::string kind = words.size() > 2 && words[1] == "GAS" ? words[2] : "";
  BagGas gas{name, 0.0, {}, ""};
  Mapping mapping = Mapping::exact;
  std::string how = "a gas with this molar mass and heat capacity";
  if (kind == "MASS" || kind == "MOLE") {
    polynomial(card, kind == "MOLE", gas);
  } else if (kind == "PREDEF") {
    const std::string word = in_capitals(without_blanks(line_or_blank(card, 1).text));
    for (const auto& [theirs, ours] : predefined)
      if (word == theirs) gas.built_in = ours;
    if (gas.built_in.empty())
      throw DeckFault(card.at, fmt::format("the predefined gas '{}' has no counterpart", word));
    mapping = Mapping::approximated;
    how = fmt::format("the built-in gas {}, by this program's own heat capacity", gas.built_in);
  } else if (kind == "CSTA") {
    const double cp = c_.twenties(card, 1).real(0, "Cp") * u_.specific_energy(),
                 cv = c_.twenties(card, 1).real(1, "Cv") * u_.specific_energy();
    if (!(cp > cv) || !(cv > 0.0)) throw DeckFault(card.at, "Cp above Cv above 0 is needed");
    gas.molar_mass = gas::kMolarGasConstant / (cp - cv);
    gas.cp[0] = cp;
  } else {
    throw DeckFault(card.at, "is no gas, allowed: /MAT/GAS/MASS, MOLE, PREDEF and CSTA");
  }
  c_.report.became(card, {"gas.species.cp", "gas.species.molar_mass"}, mapping, how);
  bag_.gases.push_back(std::move(gas));
  return bag_.gases.size() - 1;
}

// A gas by gas with its own flow and temperature.
void RadiossGas::first_injector(const DeckCard& card, double start) {
  const DeckFields head(c_.text, card, line_or_blank(card, 1), {10, 10, 20});
  const long gases = head.whole(0, "N_gases"), is_flow = head.whole(1, "Iflow");
  const double time_unit = or_one(head.real(2, "Ascale_T")) * u_.time;
  constexpr long most = 100;
  if (gases < 1 || gases > most)
    throw DeckFault(head.at(), fmt::format("N_gases = {}, allowed: 1 to {}", gases, most));
  for (long i = 0; i < gases; ++i) {
    const DeckLine& line = line_or_blank(card, 2 + static_cast<std::size_t>(i));
    const DeckFields f(c_.text, card, line, {10, 10, 10, 10, 20, 20});
    BagInflator inflator;
    inflator.gas.shares = {{gas(f.whole(0, "Mat_ID"), f.at()), 1.0}};
    inject(c_, inflator, f.whole(1, "fun_ID_M"), or_one(f.real(4, "Fscale_M")), time_unit, is_flow == 1,
           f.at());
    const long heat = f.whole(2, "fun_ID_T");
    const double factor = or_one(f.real(5, "Fscale_T"));
    inflator.temperature =
        heat != 0 ? c_.curve(heat, time_unit, factor, "inflator.temperature", f.at()) : Knots{{0.0, factor}};
    inflator.start = start;
    inflator.source = c_.source(card);
    bag_.inflators.push_back(std::move(inflator));
  }
}

// A mixture by molar fractions.
void RadiossGas::second_injector(const DeckCard& card, double start) {
  const DeckFields head = c_.tens(card, 1);
  const long gases = head.whole(0, "N_gases"), is_flow = head.whole(1, "Iflow");
  const DeckFields f(c_.text, card, line_or_blank(card, 2), {10, 10, 20, 20, 20});
  const double time_unit = or_one(f.real(4, "Ascale_T")) * u_.time;
  constexpr long most = 100;
  if (gases < 1 || gases > most)
    throw DeckFault(head.at(), fmt::format("N_gases = {}, allowed: 1 to {}", gases, most));
  BagInflator inflator;
  inflator.gas.by_mole = true;
  for (long i = 0; i < gases; ++i) {
    const DeckFields g(c_.text, card, line_or_blank(card, 3 + static_cast<std::size_t>(i)), {10, 30, 10});
    if (g.whole(2, "fun_ID_mf") != 0)
      throw DeckFault(g.at(), "molar fractions over time have no counterpart");
    inflator.gas.shares.emplace_back(gas(g.whole(0, "mat_ID"), g.at()), g.real(1, "Molar_Fraction"));
  }
  inject(c_, inflator, f.whole(0, "fun_ID_M"), or_one(f.real(2, "Fscale_M")), time_unit, is_flow == 1,
         f.at());
  inflator.temperature = c_.curve(f.whole(1, "fun_ID_T"), time_unit, or_one(f.real(3, "Fscale_T")),
                                  "inflator.temperature", f.at());
  inflator.start = start;
  inflator.source = c_.source(card);
  bag_.inflators.push_back(std::move(inflator));
}

void RadiossGas::injector(long property, double start, Place at) {
  const DeckCard& card = *entry_of(c_.tables.properties, property, "injector", at);
  if (card.keyword.starts_with("/PROP/INJECT1"))
    first_injector(card, start);
  else if (card.keyword.starts_with("/PROP/INJECT2"))
    second_injector(card, start);
  else
    throw DeckFault(card.at, "is no injector, allowed: /PROP/INJECT1 and INJECT2");
  c_.report.became(card, {"inflator.mass_flow", "inflator.temperature", "inflator.composition"},
                   Mapping::exact, "an inflator a gas or mixture");
}

void RadiossGas::airbag() {
  const DeckCard& card = c_.volume;
  if (const double loss = DeckFields(c_.text, card, line_or_blank(card, 1), {10, 10, 20}).real(2, "Hconv");
      loss > 0.0)
    c_.report.note(fmt::format("Hconv = {:g}: heat loss through the fabric has no counterpart here", loss));
  const DeckFields f(c_.text, card, line_or_blank(card, 3), {10, 10, 20, 20, 20, 10, 10});
  require_plain_volume(c_, c_.twenties(card, 2), f.real(2, "Mu"));
  constexpr double usual = 295.0;  // [K] the program's default
  bag_.ambient_pressure = f.real(3, "Pext") * u_.pressure();
  if (!(bag_.ambient_pressure > 0.0))
    throw DeckFault(f.at(), "Pext is 0, allowed: above 0, as it is the pressure of the gas at the start");
  bag_.initial_temperature = f.real(4, "T0") > 0.0 ? f.real(4, "T0") : usual;
  bag_.initial_gas.shares = {{gas(f.whole(0, "mat_ID"), f.at()), 1.0}};
  const long jets = injectors_of(c_, 4);
  std::size_t line = 5;
  for (long i = 0; i < jets; ++i) {
    const DeckFields j = c_.tens(card, line++);
    if (j.whole(2, "Ijet") > 0) {
      ++line;
      c_.report.note(fmt::format(
          "{}: jetting by curves of angle and distance (Ijet) has no counterpart: this inflator has no jet",
          c_.text.where(j.at())));
    }
    injector(j.whole(0, "inject_ID"), start_of_sensor(c_, j.whole(1, "sens_ID"), j.at()), j.at());
  }
  map_openings(c_, line);
}

// An ideal gas with constant gamma. Molar mass and temperature do not matter for it without inflow: those of
// air.
void RadiossGas::simple_gas() {
  const DeckCard& card = c_.volume;
  const DeckFields f = c_.twenties(card, 3), p = c_.twenties(card, 4);
  const double gamma = f.real(0, "Gamma");
  if (!(gamma > 1.0)) throw DeckFault(f.at(), fmt::format("Gamma = {:g}, allowed: above 1", gamma));
  constexpr double molar_mass = 0.0289, temperature = 293.15;
  bag_.gases.push_back(
      {"gas", molar_mass, {gamma / (gamma - 1.0) * gas::kMolarGasConstant / molar_mass}, ""});
  bag_.initial_gas.shares = {{0, 1.0}};
  bag_.initial_temperature = temperature;
  bag_.ambient_pressure = p.real(0, "Pext") * u_.pressure();
  bag_.initial_pressure = p.real(1, "Pini") * u_.pressure();
  for (const auto& [i, name] : {std::pair{2, "Pmax"}, std::pair{3, "Vinc"}, std::pair{4, "Mini"}})
    if (p.real(static_cast<std::size_t>(i), name) != 0.0 && p.real(static_cast<std::size_t>(i), name) < 1e19)
      c_.report.note(fmt::format("{} = {:g} of the volume has no counterpart", name,
                                 p.real(static_cast<std::size_t>(i), name)));
  if (c_.tens(card, 5).whole(0, "Nvent") != 0)
    throw DeckFault(card.at, "vents of /MONVOL/GAS are not read, allowed: none; use /MONVOL/AIRBAG1");
}

}  // namespace

void map_gas(RadiossContext& context) {
  RadiossGas reader(context);
  if (has_inline_gas(context.volume))
    map_inline_gas(context);
  else if (context.volume.keyword.starts_with("/MONVOL/GAS"))
    reader.simple_gas();
  else
    reader.airbag();
  std::vector<std::string> keys{"gas.initial.composition", "gas.initial.temperature", "ambient.pressure"};
  if (!context.bag.vents.empty()) keys.emplace_back("vent.area");
  context.report.became(context.volume, keys, Mapping::exact, "gas, inflators and vents; see also below");
}

}  // namespace driver::imported
