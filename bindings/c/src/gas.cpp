// SPDX-License-Identifier: Apache-2.0
#include <gasjet/gas.h>

#include "gas/orifice.hpp"
#include "gas_object.hpp"

using namespace border;

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

double fraction_of(std::string_view part, const std::string& composition) {
  const double value = number_in(part);
  if (!(value > 0.0 && value <= 1.0))
    refuse("composition", "'" + composition + "' has the fraction '" + std::string(part) +
                              "', allowed: a number above 0, at most 1");
  return value;
}

std::vector<gas::Component> components_of(const std::string& composition) {
  std::vector<gas::Component> components;
  double sum = 0.0;
  for (std::size_t begin = 0; begin <= composition.size();) {
    const auto end = std::min(composition.find(',', begin), composition.size());
    const auto part = std::string_view(composition).substr(begin, end - begin);
    const auto equals = part.find('=');
    if (equals == std::string_view::npos || trimmed(part.substr(0, equals)).empty())
      refuse("composition",
             "'" + composition + "', allowed: species=fraction, with commas between, as N2=0.8, O2=0.2");
    components.push_back({std::string(trimmed(part.substr(0, equals))),
                          fraction_of(trimmed(part.substr(equals + 1)), composition)});
    sum += components.back().fraction;
    begin = end + 1;
  }
  if (!(std::abs(sum - 1.0) <= 1e-9))
    refuse("composition", "has fractions of sum " + shown(sum) + ", allowed: 1");
  return components;
}

std::vector<gas::Species> species_of(const std::vector<gas::Component>& components, double constant_cp_at) {
  number(constant_cp_at, "constant_cp_at", 0.0);
  std::vector<gas::Species> species;
  for (const auto& component : components)
    species.push_back(constant_cp_at > 0.0 ? gas::constant_cp_species(component.species, constant_cp_at)
                                           : gas::nasa7_species(component.species));
  return species;
}

}  // namespace

Gas::Gas(std::vector<gas::Species> species, const std::vector<gas::Component>& components)
    : thermo(std::move(species)), mass_fractions(thermo.mass_fractions_by_mole(components)) {}

int gasjet_gas_create(const char* composition, double constant_cp_at, gasjet_handle* gas) {
  return call([&] {
    needed(gas, "gas");
    const auto components = components_of(text(composition, "composition"));
    *gas = keep(std::make_shared<Gas>(species_of(components, constant_cp_at), components));
  });
}

int gasjet_gas_create_ideal(double gas_constant, double cp, gasjet_handle* gas) {
  return call([&] {
    needed(gas, "gas");
    const std::string name =
        "gas_constant " + shown(gas_constant) + ", cp " + shown(cp);  // equal gases are one
    *gas = keep(std::make_shared<Gas>(std::vector{gas::constant_cp_species(name, gas_constant, cp)},
                                      std::vector<gas::Component>{{name, 1.0}}));
  });
}

int gasjet_gas_evaluate(gasjet_handle gas, double temperature, gasjet_gas_values* values) {
  return call([&] {
    const Use<Gas> use(gas, "gas");
    number(temperature, "temperature");
    const gas::Thermo& thermo = use->thermo;
    const auto& y = use->mass_fractions;
    const gasjet_gas_values all{thermo.gas_constant(y),
                                thermo.cp(y, temperature),
                                thermo.cv(y, temperature),
                                thermo.gamma(y, temperature),
                                thermo.enthalpy(y, temperature),
                                thermo.internal_energy(y, temperature),
                                thermo.speed_of_sound(y, temperature)};
    needed(values, "values") = finite(all, "values");
  });
}

int gasjet_gas_temperature(gasjet_handle gas, double internal_energy, double* temperature) {
  return call([&] {
    const Use<Gas> use(gas, "gas");
    number(internal_energy, "internal_energy");
    const double found =
        use->thermo.temperature_from_internal_energy(use->mass_fractions, internal_energy, 300.0);
    needed(temperature, "temperature") = finite(found, "temperature");
  });
}

int gasjet_gas_entropy(gasjet_handle gas, double temperature, double pressure, double* entropy) {
  return call([&] {
    const Use<Gas> use(gas, "gas");
    number(temperature, "temperature");
    const double found =
        use->thermo.entropy(use->mass_fractions, temperature, positive(pressure, "pressure"));
    needed(entropy, "entropy") = finite(found, "entropy");
  });
}

int gasjet_critical_pressure_ratio(double gamma, double* ratio) {
  return call([&] {
    if (!(number(gamma, "gamma") > 1.0))
      refuse("gamma", "is " + shown(gamma) + ", allowed: a number above 1");
    needed(ratio, "ratio") = finite(gas::critical_pressure_ratio(gamma), "ratio");
  });
}

int gasjet_orifice(double effective_area, double pressure, double temperature, double gas_constant, double cp,
                   double ambient_pressure, double* mass_flow) {
  return call([&] {
    number(effective_area, "effective_area", 0.0);
    number(pressure, "pressure", 0.0);
    positive(temperature, "temperature");
    positive(gas_constant, "gas_constant");
    if (!(number(cp, "cp") > gas_constant))
      refuse("cp", "is " + shown(cp) + ", allowed: above gas_constant, " + shown(gas_constant));
    number(ambient_pressure, "ambient_pressure", 0.0);
    const double flow = gas::orifice_mass_flow(effective_area, pressure, temperature, gas_constant, cp,
                                               cp / (cp - gas_constant), ambient_pressure);
    needed(mass_flow, "mass_flow") = finite(flow, "mass_flow");
  });
}

int gasjet_fabric(double leak_area, double density, double overpressure, double* mass_flow) {
  return call([&] {
    number(leak_area, "leak_area", 0.0);
    number(density, "density", 0.0);
    number(overpressure, "overpressure");
    const double flow = gas::fabric_mass_flow(leak_area, density, overpressure);
    needed(mass_flow, "mass_flow") = finite(flow, "mass_flow");
  });
}
