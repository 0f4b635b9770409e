// SPDX-License-Identifier: Apache-2.0
#include "closed_form/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "entries.hpp"

namespace closed_form {
namespace {

std::vector<Entry> build() {
  std::vector<Entry> list;
  entries::add_tanks(list);
  entries::add_tank_tests(list);
  entries::add_tank_test_readings(list);
  entries::add_outflow(list);
  entries::add_emptying_tanks(list);
  entries::add_exchanging_tanks(list);
  entries::add_inflated_shapes(list);
  entries::add_tension_and_waves(list);
  entries::add_weave(list);
  entries::add_stability(list);
  entries::add_jets(list);
  entries::add_jet_targets(list);
  entries::add_shadows(list);
  entries::add_pendulum(list);
  entries::add_contact_and_coupled(list);
  return list;
}

std::string parameter_names(const Entry& entry) {
  std::string names;
  for (const Parameter& p : entry.parameters) {
    names += (names.empty() ? "" : ", ") + p.name;
    if (!p.symbol.empty()) names += " (" + p.symbol + ")";
  }
  return names.empty() ? "none" : names;
}

const Parameter& find_parameter(const Entry& entry, const std::string& name) {
  for (const Parameter& p : entry.parameters)
    if (name == p.name || (!p.symbol.empty() && name == p.symbol)) return p;
  throw std::invalid_argument(entry.name + ": unknown parameter " + name +
                              "; allowed: " + parameter_names(entry));
}

std::vector<double> row(const Entry& entry, const ParameterMap& parameters, double abscissa) {
  std::vector<double> values;
  if (entry.has_abscissa()) values.push_back(abscissa);
  const std::vector<double> computed = entry.values(parameters, abscissa);
  values.insert(values.end(), computed.begin(), computed.end());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw std::invalid_argument(entry.name + ": " + entry.columns.at(i) +
                                  " is not finite at these parameters");
  return values;
}

}  // namespace

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> list = build();
  return list;
}

const Entry& find_entry(std::string_view name) {
  std::string names;
  for (const Entry& entry : catalogue()) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument("unknown closed form " + std::string(name) + "; there are: " + names);
}

ParameterMap complete_parameters(const Entry& entry, const ParameterMap& given) {
  ParameterMap complete;
  for (const auto& [name, value] : given) {
    const Parameter& parameter = find_parameter(entry, name);
    if (!std::isfinite(value))
      throw std::invalid_argument(entry.name + ": " + name + " must be a finite number");
    if (!complete.emplace(parameter.name, value).second)
      throw std::invalid_argument(entry.name + ": " + parameter.name + " is given twice");
  }
  for (const Parameter& parameter : entry.parameters) {
    if (complete.contains(parameter.name)) continue;
    if (!parameter.default_value)
      throw std::invalid_argument(entry.name + ": missing parameter " + parameter.name + " [" +
                                  parameter.unit + "]; allowed: " + parameter_names(entry));
    complete.emplace(parameter.name, *parameter.default_value);
  }
  return complete;
}

Table evaluate(const Entry& entry, const ParameterMap& given, std::span<const double> abscissae) {
  const ParameterMap parameters = complete_parameters(entry, given);
  Table table{entry.columns, {}};
  if (!entry.has_abscissa()) {
    if (!abscissae.empty())
      throw std::invalid_argument(entry.name + ": has no abscissa: one row, no list of values");
    table.rows.push_back(row(entry, parameters, 0.0));
    return table;
  }
  const std::span<const double> own(entry.default_abscissae);
  for (const double x : abscissae.empty() ? own : abscissae) {
    if (!std::isfinite(x))
      throw std::invalid_argument(entry.name + ": " + entry.columns.front() + " must be a finite number");
    table.rows.push_back(row(entry, parameters, x));
  }
  return table;
}

}  // namespace closed_form
