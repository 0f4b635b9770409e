// SPDX-License-Identifier: Apache-2.0
#include "gas/species.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "nasa7_csv.hpp"
#include "require.hpp"

namespace gas {
namespace {

struct Row {
  std::string species;
  double molar_mass;  // [kg/mol]
  double minimum_temperature;
  double maximum_temperature;
  Nasa7 coefficients;
};

Row parse_row(const std::string& line) {
  std::istringstream fields(line);
  std::string field;
  const auto number = [&] {
    std::getline(fields, field, ',');
    double value = 0.0;
    std::from_chars(field.data(), field.data() + field.size(), value);
    return value;
  };
  Row row;
  std::getline(fields, row.species, ',');
  row.molar_mass = number() / 1000.0;
  row.minimum_temperature = number();
  row.maximum_temperature = number();
  for (double& a : row.coefficients) a = number();
  return row;
}

void add_row(const Row& row, std::vector<Species>& table) {
  if (table.empty() || table.back().name != row.species) {
    table.push_back({row.species, row.molar_mass, row.minimum_temperature, row.maximum_temperature,
                     row.coefficients, row.coefficients, false});
  } else {
    table.back().high = row.coefficients;
    table.back().maximum_temperature = row.maximum_temperature;
  }
}

std::vector<Species> parse_table() {
  std::vector<Species> table;
  std::istringstream text(kNasa7Csv);
  bool header_read = false;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (header_read) add_row(parse_row(line), table);
    header_read = true;
  }
  return table;
}

const std::vector<Species>& table() {
  static const std::vector<Species> species = parse_table();
  return species;
}

double cp_over_gas_constant(const Species& species, double t) {
  const Nasa7& a = t <= kJointTemperature ? species.low : species.high;
  return a[0] + t * (a[1] + t * (a[2] + t * (a[3] + t * a[4])));
}

Species with_constant_cp(std::string_view name, double molar_mass, double cp_over_r) {
  const Nasa7 a{cp_over_r, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  return {std::string(name), molar_mass, 0.0, std::numeric_limits<double>::infinity(), a, a, true};
}

}  // namespace

std::vector<std::string> species_names() {
  std::vector<std::string> names;
  for (const Species& s : table()) names.push_back(s.name);
  return names;
}

Species nasa7_species(std::string_view name) {
  const auto found = std::ranges::find(table(), name, &Species::name);
  if (found != table().end()) return *found;
  std::string known;
  for (const Species& s : table()) known += " " + s.name;
  throw std::invalid_argument("species = \"" + std::string(name) + "\": must be one of" + known);
}

Species constant_cp_species(std::string_view name, double temperature) {
  const Species s = nasa7_species(name);
  require(temperature >= s.minimum_temperature && temperature <= s.maximum_temperature,
          "temperature of constant cp [K]", temperature, "must be 200 to 6000");
  return with_constant_cp(name, s.molar_mass, cp_over_gas_constant(s, temperature));
}

Species constant_cp_species(std::string_view name, double gas_constant, double cp) {
  require(std::isfinite(gas_constant) && gas_constant > 0.0, "gas_constant [J/(kg K)]", gas_constant,
          "must be positive and finite");
  require(std::isfinite(cp) && cp > gas_constant, "cp [J/(kg K)]", cp,
          "must be finite and greater than gas_constant");
  return with_constant_cp(name, kMolarGasConstant / gas_constant, cp / gas_constant);
}

std::vector<Component> air_by_mole() {
  return {{"N2", 0.7808}, {"O2", 0.2095}, {"Ar", 0.0093}, {"CO2", 1.0 - 0.7808 - 0.2095 - 0.0093}};
}

}  // namespace gas
