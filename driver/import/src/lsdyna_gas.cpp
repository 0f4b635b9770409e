// SPDX-License-Identifier: Apache-2.0
// Gas, inflators and vents of *AIRBAG_SIMPLE_AIRBAG_MODEL, _WANG_NEFSKE, _HYBRID and _HYBRID_JETTING.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/species.hpp"
#include "gas_at_start.hpp"
#include "lsdyna_context.hpp"
#include "vent_curves.hpp"

namespace driver::imported {
namespace {

/// Reads the airbag's cards, one method a kind.
class LsDynaGas {
 public:
  explicit LsDynaGas(LsDynaContext& context)
      : c_(context),
        u_(context.units),
        bag_(context.bag),
        entry_{&context.airbag, head_lines(context.airbag)} {}
  long read();

 private:
  void simple();
  void wang_nefske();
  void hybrid();
  void core();
  double real(std::size_t line, std::size_t field, const char* name) const {
    return c_.real(entry_, line, field, name);
  }
  long whole(std::size_t line, std::size_t field, const char* name) const {
    return c_.whole(entry_, line, field, name);
  }
  Place at(std::size_t line) const {
    const Place place = line_or_blank(c_.airbag, entry_.first + line).at;
    return place.line > 0 ? place : c_.airbag.at;
  }
  void none(std::size_t line, std::size_t field, const char* name, const char* what) const {
    if (real(line, field, name) != 0.0)
      throw DeckFault(at(line),
                      fmt::format("{} = {:g} has no counterpart: {}", name, real(line, field, name), what));
  }
  void one_gas(std::size_t line, std::size_t first, double density);
  Knots flow(long curve, std::size_t line);
  void vent(std::size_t line, std::size_t first, const char* name, double opens_at_overpressure);

  LsDynaContext& c_;
  const Units& u_;
  BagDeck& bag_;
  LsDynaEntry entry_;
};

void LsDynaGas::core() {
  const auto scale = [&](std::size_t field, const char* name) {
    const double value = real(0, field, name);
    if (value != 0.0 && value != 1.0)
      throw DeckFault(at(0), fmt::format("{} = {:g} has no counterpart, allowed: 1", name, value));
  };
  none(0, 2, "RBID", "a subroutine starts the inflator");
  scale(3, "VSCA");
  scale(4, "PSCA");
  if (const double filled_volume = real(0, 5, "VINI"); filled_volume != 0.0)
    throw DeckFault(
        at(0), fmt::format("VINI = {:g} has no counterpart: the volume is that of the mesh", filled_volume));
  if (const double damping = real(0, 6, "MWD"); damping > 0.0) {
    bag_.held.mass_damping = damping / u_.time;
    c_.report.note(
        fmt::format("MWD = {:g}: damps all motion of the bag here, in the deck motion about its mean "
                    "velocity only",
                    damping));
  }
  if (const double stagnation = real(0, 7, "SPSF"); stagnation != 0.0)
    c_.report.note(
        fmt::format("SPSF = {:g} (stagnation pressure of the flow) has no counterpart", stagnation));
}

// By CP and CV, or if CV is 0 by the molar A, B and MW on a line. The temperature at the start follows from
// the density by the ideal gas law.
void LsDynaGas::one_gas(std::size_t line, std::size_t first, double density) {
  const double cv = real(1, 0, "CV") * u_.specific_energy(), cp = real(1, 1, "CP") * u_.specific_energy();
  if (cv != 0.0) {
    if (!(cp > cv) || !(cv > 0.0))
      throw DeckFault(at(1), fmt::format("CP = {:g} and CV = {:g}, allowed: CP above CV above 0", cp, cv));
    bag_.gases.push_back({"gas", gas::kMolarGasConstant / (cp - cv), {cp}, ""});
  } else {
    const double a = real(line, first, "A"), mass = real(line, first + 2, "MW") * u_.mass;
    if (!(a > 0.0) || !(mass > 0.0))
      throw DeckFault(at(line), "CV is 0, so A and MW of the gas are needed, above 0");
    const double unit = u_.energy() / mass;
    bag_.gases.push_back({"gas", mass, {a * unit, real(line, first + 1, "B") * unit}, ""});
  }
  bag_.initial_gas.shares = {{0, 1.0}};
  if (!(bag_.ambient_pressure > 0.0))
    throw DeckFault(at(1),
                    "the ambient pressure is 0, allowed: above 0, as it is that of the gas at the start");
  if (!(density > 0.0)) throw DeckFault(at(1), "RO, the density at the start, is 0, allowed: above 0");
  const double constant = gas::kMolarGasConstant / bag_.gases.front().molar_mass;
  bag_.initial_temperature = bag_.ambient_pressure / (density * constant);
}

Knots LsDynaGas::flow(long curve, std::size_t line) {
  Knots knots = c_.curve(curve, u_.time, u_.mass_flow(), "inflator.mass_flow", at(line));
  const double last = knots.back()[1], end = knots.back()[0];
  if (last != 0.0 && end < bag_.end_time)
    c_.report.note(
        fmt::format("the mass flow of curve {} ends at {:.3g} s with {:.3g} kg/s: it is zero from there to "
                    "the end of the run",
                    curve, end, last));
  not_below_zero(knots, "inflator.mass_flow", c_.report);
  return knots;
}

void LsDynaGas::vent(std::size_t line, std::size_t first, const char* name, double opens_at_overpressure) {
  const double c = real(line, first, "coefficient"), a = real(line, first + 2, "area");
  const long c_curve = whole(line, first + 1, "curve of the coefficient"),
             a_curve = whole(line, first + 3, "curve of the area");
  if ((c == 0.0 && c_curve == 0) || (a == 0.0 && a_curve == 0)) return;
  BagVent vent;
  vent.source = fmt::format("{} {}", c_.text.where(at(line)), name);
  double area = a * u_.area();
  if (a < 0.0) {
    area = area_of(c_.bag, c_.panels, std::lround(-a));
    if (!(area > 0.0))
      throw DeckFault(
          at(line), fmt::format("{}: the area of part {:g} is asked for, which is not in the control volume",
                                name, -a));
    c_.report.note(fmt::format(
        "{}: the area of part {:g} is that of the start, {:.3g} m2, and does not change", name, -a, area));
  }
  const bool by_time = c == 0.0, by_pressure = a == 0.0;
  if (by_time && by_pressure)
    throw DeckFault(
        at(line), fmt::format("{}: a coefficient of time with an area of pressure has no counterpart", name));
  if (by_pressure) {
    vent.of_overpressure = c_.curve_of_pressure(a_curve, c * u_.area(), "vent.area", at(line));
    from_rest(vent.of_overpressure);
  } else if (by_time) {
    vent.of_time = c_.curve(c_curve, u_.time, area, "vent.area", at(line));
    if (opens_at_overpressure > 0.0)
      throw DeckFault(
          at(line),
          fmt::format("{}: a coefficient of time with an opening pressure has no counterpart", name));
  } else {
    vent.area = std::abs(c) * area;
  }
  not_below_zero(vent.of_overpressure, "vent.area", c_.report);
  not_below_zero(vent.of_time, "vent.area", c_.report);
  if (opens_at_overpressure > 0.0) vent.opens_at_overpressure = opens_at_overpressure;
  if (vent.is_open()) bag_.vents.push_back(std::move(vent));
}

void LsDynaGas::simple() {
  bag_.ambient_pressure = real(1, 6, "PE") * u_.pressure();
  one_gas(2, 2, real(1, 7, "RO") * u_.density());
  none(2, 0, "LOU", "the flow out is a curve of pressure");
  if (const long curve = whole(1, 3, "LCID"); curve != 0)
    bag_.inflators.push_back(
        {bag_.initial_gas, flow(curve, 1), {{0.0, real(1, 2, "T")}}, 0.0, {}, c_.source(c_.airbag)});
  const double mu = real(1, 4, "MU"), area = real(1, 5, "AREA");
  BagVent vent;
  vent.source = c_.text.where(at(1)) + " MU, AREA";
  if (mu < 0.0 && area < 0.0) throw DeckFault(at(1), "MU and AREA are both curves, allowed: one of them");
  if (mu < 0.0)
    vent.of_overpressure = c_.curve_of_pressure(std::lround(-mu), area * u_.area(), "vent.area", at(1));
  else if (area < 0.0)
    vent.of_overpressure = c_.curve_of_pressure(std::lround(-area), mu * u_.area(), "vent.area", at(1));
  else
    vent.area = mu * area * u_.area();
  if (!vent.of_overpressure.empty()) from_rest(vent.of_overpressure);
  if (vent.is_open()) bag_.vents.push_back(std::move(vent));
}

void LsDynaGas::wang_nefske() {
  bag_.ambient_pressure = real(3, 0, "PE") * u_.pressure();
  one_gas(5, 1, real(3, 1, "RO") * u_.density());
  if (const double over = real(3, 4, "POVER") * u_.pressure(); over > 0.0)
    bag_.initial_pressure = bag_.ambient_pressure + over;
  const double stated = real(1, 7, "IABT");
  constexpr double close = 1e-3;
  if (stated > 0.0 && std::abs(stated / bag_.initial_temperature - 1.0) > close)
    c_.report.note(
        fmt::format("IABT = {:g} K, but PE and RO give {:.4g} K for the gas at the start: that is taken",
                    stated, bag_.initial_temperature));
  none(3, 3, "LCEFR", "the flow out is a curve of pressure");
  const long flow_curve = whole(1, 4, "LCMT"), heat_curve = whole(1, 3, "LCT");
  if (flow_curve == 0 && real(4, 2, "IVOL") != 0.0)
    throw DeckFault(
        at(1), "LCMT is 0: an inflator by its tank (IVOL, IRO, IT) has no counterpart; give its mass flow");
  Knots temperature{{0.0, real(1, 2, "T")}};
  if (heat_curve != 0) temperature = c_.curve(heat_curve, u_.time, 1.0, "inflator.temperature", at(1));
  if (flow_curve != 0)
    bag_.inflators.push_back(
        {bag_.initial_gas, flow(flow_curve, 1), temperature, 0.0, {}, c_.source(c_.airbag)});
  const double pops = real(3, 5, "PPOP") * u_.pressure();
  vent(2, 0, "C23, A23", pops);
  if (whole(3, 6, "OPT") == 0) vent(2, 4, "CP23, AP23", pops);
}

// Molar cp = A + B T + C T^2 of each gas; the first with INITM fills the bag.
void LsDynaGas::hybrid() {
  const double heat = real(1, 0, "ATMOST");
  bag_.ambient_pressure = real(1, 1, "ATMOSP") * u_.pressure();
  if (!(bag_.ambient_pressure > 0.0))
    throw DeckFault(at(1), "ATMOSP is 0, allowed: above 0, as it is the pressure of the gas at the start");
  bag_.initial_temperature = heat;
  if (const double loss = real(1, 5, "HCONV"); loss > 0.0)
    c_.report.note(fmt::format("HCONV = {:g}: heat loss through the fabric has no counterpart here", loss));
  none(3, 3, "LCEFR", "the flow out is a curve of pressure");
  none(3, 4, "LCIDM0", "the mass flow is one curve for all gases");
  const long count = whole(3, 2, "NGAS");
  constexpr long most = 100;
  if (count < 1 || count > most)
    throw DeckFault(at(3), fmt::format("NGAS = {}, allowed: 1 to {}", count, most));
  for (long i = 0; i < count; ++i) {
    const std::size_t line = 4 + 2 * static_cast<std::size_t>(i);
    const double mass = real(line, 3, "MW") * u_.mass;
    if (!(mass > 0.0)) throw DeckFault(at(line), "MW, the molar mass of a gas, is 0, allowed: above 0");
    const double unit = u_.energy() / mass;
    bag_.gases.push_back({fmt::format("gas_{}", i + 1),
                          mass,
                          {real(line, 5, "A") * unit, real(line, 6, "B") * unit, real(line, 7, "C") * unit},
                          ""});
    none(line + 1, 0, "FMASS", "the inflator draws in gas from outside");
    const auto gas = static_cast<std::size_t>(i);
    if (const double share = real(line, 4, "INITM"); share > 0.0)
      bag_.initial_gas.shares.emplace_back(gas, share);
    const long flow_curve = whole(line, 0, "LCIDM"), heat_curve = whole(line, 1, "LCIDT");
    if (flow_curve == 0) continue;
    BagInflator inflator;
    inflator.gas.shares = {{gas, 1.0}};
    inflator.mass_flow = flow(flow_curve, line);
    if (c_.title_of(*c_.tables.curves.at(flow_curve).card) == initial_overpressure_title)
      inflator.at_once = mass_of(inflator.mass_flow);
    if (heat_curve == 0) throw DeckFault(at(line), "a gas flows in without a temperature (LCIDT)");
    inflator.temperature = c_.curve(heat_curve, u_.time, 1.0, "inflator.temperature", at(line));
    inflator.source = fmt::format("{} gas {}", c_.text.where(at(line)), i + 1);
    bag_.inflators.push_back(std::move(inflator));
  }
  if (bag_.initial_gas.shares.empty()) {
    bag_.initial_gas.shares = {{0, 1.0}};
    c_.report.note("no gas has a share at the start (INITM): the first gas fills the bag");
  }
  const double opens = real(3, 1, "PVENT") * u_.pressure();
  vent(2, 0, "C23, A23", opens);
  if (whole(3, 0, "OPT") == 0) vent(2, 4, "CP23, AP23", 0.0);
  if (c_.airbag.keyword.find("JETTING") != std::string::npos)
    map_jet(c_, {entry_.card, entry_.first + 4 + 2 * static_cast<std::size_t>(count)});
}

long LsDynaGas::read() {
  core();
  const std::string& word = c_.airbag.keyword;
  long option = 0;
  if (word.starts_with("*AIRBAG_SIMPLE_AIRBAG_MODEL")) {
    simple();
  } else if (is_keyword(c_.airbag, "*AIRBAG_WANG_NEFSKE")) {
    wang_nefske();
    option = whole(3, 6, "OPT");
  } else {
    hybrid();
    option = whole(3, 0, "OPT");
  }
  std::vector<std::string> keys{"gas.initial.composition", "gas.initial.temperature", "ambient.pressure"};
  if (!bag_.inflators.empty()) keys.emplace_back("inflator.mass_flow");
  if (!bag_.vents.empty()) keys.emplace_back("vent.area");
  c_.report.became(c_.airbag, keys, Mapping::exact, "gas, inflators and vents; see also below");
  return option;
}

}  // namespace

long map_gas(LsDynaContext& context) {
  return LsDynaGas(context).read();
}

}  // namespace driver::imported
