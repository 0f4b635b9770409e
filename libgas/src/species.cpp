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

/// Coefficients of a polynomial, the constant one first.
using Polynomial = std::vector<double>;

double value(const Polynomial& p, double t) {
  double sum = 0.0;
  for (std::size_t i = p.size(); i-- > 0;) sum = p[i] + t * sum;
  return sum;
}

Polynomial cp_over_gas_constant(const Nasa7& a) {
  return {a.begin(), a.begin() + 5};
}

double cp_over_gas_constant(const Species& species, double t) {
  return value(cp_over_gas_constant(t <= kJointTemperature ? species.low : species.high), t);
}

/// a, the extrema of p in between, and b, rising. p is monotonic from each to the next.
std::vector<double> extrema(const Polynomial& p, double a, double b) {
  if (p.size() < 2) return {a, b};
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(static_cast<double>(i) * p[i]);
  std::vector<double> found{a};
  const std::vector<double> turns = extrema(slope, a, b);
  for (std::size_t i = 1; i < turns.size(); ++i) {
    double left = turns[i - 1], right = turns[i];
    const bool rises = value(slope, left) > 0.0;
    if (rises == (value(slope, right) > 0.0)) continue;
    for (double t; (t = 0.5 * (left + right)) > left && t < right;)
      ((value(slope, t) > 0.0) == rises ? left : right) = t;
    found.push_back(right);
  }
  found.push_back(b);
  return found;
}

/// Requires cp > R between a and b [K], so that u rises with T.
void require_heat_capacity(const std::string& range, const Nasa7& coefficients, double a, double b) {
  const Polynomial cp = cp_over_gas_constant(coefficients);
  for (const double t : extrema(cp, a, b))
    require(value(cp, t) > 1.0 && std::isfinite(value(cp, t)),
            "cp/R of " + range + " at " + to_short_text(t) + " K", value(cp, t),
            "must be finite and above 1 in its whole range");
}

void require_joint(const Nasa7& low, const Nasa7& high) {
  constexpr double kAllowed = 1e-5;
  const double t = kJointTemperature;
  const auto h = [&](const Nasa7& a) {
    return a[0] + t * (a[1] / 2.0 + t * (a[2] / 3.0 + t * (a[3] / 4.0 + t * a[4] / 5.0))) + a[5] / t;
  };
  const double cp = value(cp_over_gas_constant(low), t), above = value(cp_over_gas_constant(high), t);
  require(std::abs(above - cp) <= kAllowed * cp, "jump of cp/R at 1000 K", above - cp,
          "must not exceed 1e-5 of cp/R");
  require(std::abs(h(high) - h(low)) <= kAllowed * cp, "jump of h/(R T) at 1000 K", h(high) - h(low),
          "must not exceed 1e-5 of cp/R");
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

Species nasa7_species(std::string_view name, double molar_mass, double minimum_temperature,
                      double maximum_temperature, const Nasa7& low, const Nasa7& high) {
  require(std::isfinite(molar_mass) && molar_mass > 0.0, "molar_mass [kg/mol]", molar_mass,
          "must be positive and finite");
  require(minimum_temperature > 0.0 && minimum_temperature < kJointTemperature, "minimum temperature [K]",
          minimum_temperature, "must be positive and below 1000");
  require(std::isfinite(maximum_temperature) && maximum_temperature > kJointTemperature,
          "maximum temperature [K]", maximum_temperature, "must be finite and above 1000");
  for (const Nasa7& a : {low, high})
    for (const double coefficient : a)
      require(std::isfinite(coefficient), "NASA-7 coefficient", coefficient, "must be finite");
  require_heat_capacity("low", low, minimum_temperature, kJointTemperature);
  require_heat_capacity("high", high, kJointTemperature, maximum_temperature);
  require_joint(low, high);
  return {std::string(name), molar_mass, minimum_temperature, maximum_temperature, low, high, false};
}

Species constant_cp_species(const Species& species, double temperature) {
  const double low = species.minimum_temperature, high = species.maximum_temperature;
  require(temperature >= low && temperature <= high, "temperature of constant cp [K]", temperature,
          "must be " + to_text(low) + " to " + to_text(high));
  return with_constant_cp(species.name, species.molar_mass, cp_over_gas_constant(species, temperature));
}

Species constant_cp_species(std::string_view name, double temperature) {
  return constant_cp_species(nasa7_species(name), temperature);
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
