// SPDX-License-Identifier: Apache-2.0
// Gas, inflators and vents of a case.
#include "case_blocks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/case_reader.hpp"
#include "gas/species.hpp"

namespace driver::imported {
namespace {

double cp_of(const BagGas& gas, double temperature) {
  double cp = 0.0;
  for (std::size_t i = gas.cp.size(); i-- > 0;) cp = cp * temperature + gas.cp[i];
  return cp;
}

// Temperatures over which the polynomial is a heat capacity: from 200 K to twice the hottest inflow, or as
// far as it is above R.
std::array<double, 2> range_of(const BagGas& gas, double hottest) {
  const double constant = gas::kMolarGasConstant / gas.molar_mass;
  double low = 200.0, high = std::max(1200.0, 2.0 * hottest);
  constexpr double margin = 1.0001, step = 10.0;
  for (double t = 990.0; t >= low; t -= step)
    if (cp_of(gas, t) <= margin * constant) low = t + step;
  for (double t = 1010.0; t <= high; t += step)
    if (cp_of(gas, t) <= margin * constant) high = t - step;
  return {low, high};
}

double hottest_of(const BagDeck& bag) {
  double hottest = bag.initial_temperature;
  for (const BagInflator& inflator : bag.inflators)
    for (const auto& knot : inflator.temperature) hottest = std::max(hottest, knot[1]);
  return hottest;
}

void species_table(const BagGas& gas, bool constant, double hottest, CaseText& out) {
  out.table("[[gas.species]]");
  out.line("name", quoted(gas.name));
  out.line("molar_mass", gas.molar_mass, "kg/mol");
  if (constant) return out.line("cp", gas.cp[0], "J/(kg K)");
  std::vector<std::string> factors;
  for (const double factor : gas.cp)
    factors.push_back(number(factor * gas.molar_mass / gas::kMolarGasConstant));
  factors.insert(factors.end(), {"0.0", "0.0"});
  const auto range = range_of(gas, hottest);
  const std::string list = fmt::format("{}", fmt::join(factors, ", "));
  out.line("nasa7", fmt::format("{{ range = [{}, {}], low = [{}], high = [{}] }}", number(range[0]),
                                number(range[1]), list, list));
}

std::string composition_of(const Mixture& mixture, const BagDeck& bag) {
  double sum = 0.0;
  for (const auto& [gas, share] : mixture.shares) sum += share;
  std::map<std::string, double> shares;
  for (const auto& [gas, share] : mixture.shares)
    if (share > 0.0) {
      const BagGas& own = bag.gases[gas];
      shares[own.built_in.empty() ? own.name : own.built_in] += share / sum;
    }
  std::vector<std::string> parts;
  for (const auto& [name, share] : shares)
    parts.push_back(fmt::format("{} = {}", quoted(name), number(share)));
  return fmt::format("{{ {} }}", fmt::join(parts, ", "));
}

std::string by_of(const Mixture& mixture) {
  return mixture.by_mole ? ", composition_by = \"mole\"" : "";
}

void gas_table(const BagDeck& bag, bool constant, CaseText& out) {
  out.table("[gas]");
  out.line("thermodynamics", constant ? "\"constant\"" : "\"nasa7\"");
  std::string initial =
      fmt::format("{{ composition = {}{}", composition_of(bag.initial_gas, bag), by_of(bag.initial_gas));
  if (bag.initial_pressure) initial += fmt::format(", pressure = {}", number(*bag.initial_pressure));
  out.line("initial", initial + fmt::format(", temperature = {} }}", number(bag.initial_temperature)),
           "Pa, K");
  if (bag.heat_transfer > 0.0)
    out.line("heat_loss", fmt::format("{{ coefficient = {} }}", number(bag.heat_transfer)), "W/(m2 K)");
}

void jet_table(const BagJet& jet, CaseText& out) {
  out.table("[inflator.jet]");
  out.line("shape", "\"round\"");
  out.line("centre", jet.centre, "m");
  out.line("axis", jet.axis);
  out.line("radius", jet.radius, "m");
  out.line("outlet_type", "\"contracting_nozzle\"");
}

void inflator_table(const BagInflator& inflator, std::size_t number_, const BagDeck& bag, CaseText& out) {
  out.table("[[inflator]]", inflator.source);
  out.line("composition", composition_of(inflator.gas, bag));
  if (inflator.gas.by_mole) out.line("composition_by", "\"mole\"");
  out.curve("mass_flow", inflator.mass_flow, "time", "kg/s", fmt::format("mass_flow_{}", number_));
  out.curve("temperature", inflator.temperature, "time", "K", fmt::format("temperature_{}", number_));
  if (inflator.start > 0.0) out.line("start_time", inflator.start, "s");
  if (inflator.jet) jet_table(*inflator.jet, out);
}

void vent_table(const BagVent& vent, std::size_t number_, CaseText& out) {
  const std::string sensor = fmt::format("opening_{}", number_);
  const bool triggered = vent.opens_at > 0.0 || vent.opens_at_overpressure;
  if (triggered) {
    out.table("[[sensor]]");
    out.line("name", quoted(sensor));
    if (vent.opens_at_overpressure)
      out.line("overpressure", *vent.opens_at_overpressure, "Pa");
    else
      out.line("time", vent.opens_at, "s");
  }
  out.table("[[vent]]", vent.source);
  if (!vent.of_time.empty())
    out.curve("area", vent.of_time, "time", "m2", fmt::format("vent_{}", number_));
  else if (!vent.of_overpressure.empty())
    out.curve("area", vent.of_overpressure, "overpressure", "m2", fmt::format("vent_{}", number_));
  else
    out.line("area", vent.area, "m2");
  if (triggered) out.line("trigger", quoted(sensor));
}

}  // namespace

void gas_blocks(const BagDeck& bag, CaseText& out) {
  out.table("[ambient]");
  out.line("pressure", bag.ambient_pressure, "Pa");
  out.line("temperature", bag.initial_temperature, "K");
  const bool constant = std::ranges::all_of(bag.gases, &BagGas::constant);
  gas_table(bag, constant, out);
  for (const BagGas& gas : bag.gases)
    if (gas.built_in.empty()) species_table(gas, constant, hottest_of(bag), out);
  for (std::size_t i = 0; i < bag.inflators.size(); ++i) inflator_table(bag.inflators[i], i + 1, bag, out);
  for (std::size_t i = 0; i < bag.vents.size(); ++i) vent_table(bag.vents[i], i + 1, out);
}

}  // namespace driver::imported
