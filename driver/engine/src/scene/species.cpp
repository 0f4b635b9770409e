// SPDX-License-Identifier: Apache-2.0
// [[gas.species]]
#include "engine/species.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace driver {
namespace {

double read_molar_mass(TableReader& table) {
  if (table.has("molar_mass") && table.has("gas_constant"))
    table.fail("gas_constant", "is given with molar_mass: leave out one of the two");
  if (table.has("gas_constant"))
    return gas::kMolarGasConstant / table.at("gas_constant").number(positive.in("J/(kg K)"));
  constexpr Bounds molar{1e-3, 1.0, false, "1e-3 to 1", "kg/mol"};
  return table.at("molar_mass").number(molar);
}

gas::Nasa7 read_coefficients(TableReader& table, const std::string& key) {
  const auto numbers = table.at(key).numbers(any_number);
  gas::Nasa7 coefficients{};
  if (numbers.size() != coefficients.size())
    table.fail(key, fmt::format("has {} numbers, needed: {}", numbers.size(), coefficients.size()));
  std::ranges::copy(numbers, coefficients.begin());
  return coefficients;
}

gas::Species read_nasa7(TableReader& species, const std::string& name, double molar_mass) {
  TableReader table = species.table("nasa7");
  const double middle = table.at("middle").number(gas_temperature, gas::kJointTemperature);
  if (middle != gas::kJointTemperature)
    table.fail("middle", fmt::format("is {}, allowed: {} K", middle, gas::kJointTemperature));
  const auto range = table.at("range").numbers(gas_temperature);
  if (range.size() != 2)
    table.fail("range", fmt::format("has {} numbers, needed: 2, the lowest and highest temperature [K]",
                                    range.size()));
  const gas::Nasa7 low = read_coefficients(table, "low"), high = read_coefficients(table, "high");
  table.finish();
  gas::Species gas;
  species.located("nasa7",
                  [&] { gas = gas::nasa7_species(name, molar_mass, range[0], range[1], low, high); });
  return gas;
}

gas::Species read_own(TableReader& table, const std::string& name) {
  const double molar_mass = read_molar_mass(table);
  if (table.has("cp") && table.has("nasa7"))
    table.fail("cp", "is given with nasa7: leave out one of the two");
  if (table.has("nasa7")) return read_nasa7(table, name, molar_mass);
  gas::Species gas;
  const double cp = table.at("cp").number(positive.in("J/(kg K)"));
  table.located("cp", [&] { gas = gas::constant_cp_species(name, gas::kMolarGasConstant / molar_mass, cp); });
  return gas;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// The known name that is meant, if any: formulas of few letters are alike by chance, so their letters must
// agree.
std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t formula = 4;  // letters at most
  const std::string small = lower(name);
  auto like = std::ranges::find_if(known, [&](const auto& other) { return lower(other) == small; });
  if (like == known.end() && name.size() > formula)
    like = std::ranges::find_if(known, [&](const auto& other) { return is_like(small, lower(other)); });
  return like == known.end() ? "" : fmt::format("; is '{}' meant?", *like);
}

}  // namespace

void SpeciesCatalogue::read(TableReader& gas) {
  for (auto& table : gas.tables("species")) {
    const std::string name = table.at("name").text();
    require_new(table, name);
    own_.push_back(read_own(table, name));
    table.finish();
    if (law_ == Thermodynamics::constant_cp)
      table.located("nasa7", [&] { own_.back() = gas::constant_cp_species(own_.back(), reference_); });
  }
}

void SpeciesCatalogue::require_new(const TableReader& table, const std::string& name) const {
  if (name.empty()) table.fail("name", "is empty, needed: a name");
  if (std::ranges::find(own_, name, &gas::Species::name) != own_.end())
    table.fail("name", fmt::format("names \"{}\" a second time", name));
  auto built_in = gas::species_names();
  built_in.emplace_back("air");
  if (std::ranges::find(built_in, name) != built_in.end())
    table.fail("name", fmt::format("is \"{}\", allowed: any name except the built-in {}", name,
                                   fmt::join(built_in, " ")));
}

gas::Species SpeciesCatalogue::named(const std::string& name) const {
  if (const auto own = std::ranges::find(own_, name, &gas::Species::name); own != own_.end()) return *own;
  auto known = gas::species_names();
  if (std::ranges::find(known, name) == known.end()) {
    known.emplace_back("air");
    for (const auto& own : own_) known.push_back(own.name);
    throw std::invalid_argument(fmt::format("species = \"{}\": must be one of {}{}", name,
                                            fmt::join(known, " "), meant_by(name, known)));
  }
  return law_ == Thermodynamics::nasa7 ? gas::nasa7_species(name)
                                       : gas::constant_cp_species(name, reference_);
}

}  // namespace driver
