// SPDX-License-Identifier: Apache-2.0
#include "plain_gas.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace random_tanks {
namespace {

constexpr double kMolar = 8.31446261815324;  // [J/(mol K)]
constexpr double kZero = 298.15;             // [K] where enthalpies are zero

void shift(PlainSpecies& species) {
  const double zero = polynomial_enthalpy(species.lower, kZero, species.minimum, species.maximum);
  species.lower[5] -= zero;
  species.upper[5] -= zero;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
  return result;
}

PlainSpecies read_one(const std::string& name, const std::string& csv) {
  std::ifstream in(csv);
  PlainSpecies species;
  bool found = false;
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> row = cells(line);
    if (row.empty() || row[0] != name) continue;
    species.gas_constant = kMolar / (1e-3 * std::stod(row.at(1)));
    const double low = std::stod(row.at(2)), high = std::stod(row.at(3));
    Coefficients a;
    for (std::size_t j = 0; j < a.size(); ++j) a[j] = species.gas_constant * std::stod(row.at(4 + j));
    if (!found) species.minimum = low;
    if (!found) species.lower = a;
    species.upper = a;
    species.maximum = high;
    found = true;
  }
  if (!found) throw std::runtime_error("no row " + name + " in " + csv);
  shift(species);
  return species;
}

}  // namespace

double polynomial_cp(const Coefficients& a, double t) {
  return a[0] + t * (a[1] + t * (a[2] + t * (a[3] + t * a[4])));
}

double polynomial_enthalpy(const Coefficients& a, double t, double low, double high) {
  const double x = std::clamp(t, low, high);
  const double inside = a[5] + x * (a[0] + x * (a[1] / 2 + x * (a[2] / 3 + x * (a[3] / 4 + x * a[4] / 5))));
  return x == t ? inside : inside + polynomial_cp(a, x) * (t - x);
}

std::vector<PlainSpecies> read_species(const std::vector<Gas>& gases, const std::string& csv) {
  std::vector<PlainSpecies> species;
  for (const Gas& gas : gases) {
    if (gas.cp == 0.0) {
      species.push_back(read_one(gas.name, csv));
      continue;
    }
    species.push_back({gas.gas_constant, {gas.cp}, {gas.cp}, 0.0, HUGE_VAL});
    shift(species.back());
  }
  return species;
}

}  // namespace random_tanks
