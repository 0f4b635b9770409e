// SPDX-License-Identifier: Apache-2.0
#include "closed_form/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "entries.hpp"

namespace closed_form {
namespace {

struct Family {
  const char* name;
  std::vector<std::vector<Entry> (*)()> lists;
};

std::vector<Entry> build() {
  const Family families[] = {
      {"gas", {entries::tanks, entries::tank_tests}},
      {"outflow", {entries::outflow, entries::emptying_tanks, entries::exchanging_tanks, entries::bags}},
      {"membrane",
       {entries::polyhedra, entries::inflated_shapes, entries::flat_membranes, entries::logarithmic_bags,
        entries::discs, entries::vibration, entries::tension, entries::waves, entries::weave}},
      {"stability", {entries::time_steps, entries::drifts}},
      {"jet", {entries::jets, entries::jet_targets, entries::shadows}},
      {"pendulum", {entries::swings}},
      {"coupled", {entries::contact, entries::coupled}},
  };
  std::vector<Entry> all;
  for (const Family& family : families)
    for (const auto& list : family.lists)
      for (Entry& entry : list()) {
        entry.family = family.name;
        all.push_back(std::move(entry));
      }
  return all;
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
  throw std::invalid_argument("unknown parameter " + name + "; allowed: " + parameter_names(entry));
}

std::vector<double> row(const Entry& entry, const ParameterMap& parameters, double abscissa) {
  std::vector<double> values;
  if (entry.has_abscissa()) values.push_back(abscissa);
  const std::vector<double> computed = entry.values(parameters, abscissa);
  values.insert(values.end(), computed.begin(), computed.end());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw std::invalid_argument(entry.columns.at(i) + " is not finite at these parameters");
  return values;
}

// A refusal may speak of what was derived from a parameter: say which ones were given.
std::string given_values(const ParameterMap& given) {
  std::ostringstream text;
  for (const auto& [name, value] : given)
    text << (text.str().empty() ? "; given: " : ", ") << name << " = " << value;
  return text.str();
}

}  // namespace

bool Entry::is_constant(const std::string& column) const {
  return std::find(constants.begin(), constants.end(), column) != constants.end();
}

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> list = build();
  return list;
}

namespace {

/// Letters to change, add or leave out to make `b` of `a`.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({changed, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row.back();
}

std::string meant_by(std::string_view name) {
  if (name.size() > 64) return "";
  for (const Entry& entry : catalogue())
    if (edits(entry.name, name) <= entry.name.size() / 4) return "; is '" + entry.name + "' meant?";
  return "";
}

}  // namespace

const Entry& find_entry(std::string_view name) {
  std::string names;
  for (const Entry& entry : catalogue()) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument("unknown closed form " + std::string(name) + ", allowed: " + names +
                              meant_by(name));
}

ParameterMap complete_parameters(const Entry& entry, const ParameterMap& given) {
  ParameterMap complete;
  for (const auto& [name, value] : given) {
    const Parameter& parameter = find_parameter(entry, name);
    if (!std::isfinite(value)) throw std::invalid_argument(name + " must be a finite number");
    if (!complete.emplace(parameter.name, value).second)
      throw std::invalid_argument(parameter.name + " is given twice");
  }
  for (const Parameter& parameter : entry.parameters) {
    if (complete.contains(parameter.name)) continue;
    if (!parameter.default_value)
      throw std::invalid_argument("missing parameter " + parameter.name + " [" + parameter.unit +
                                  "]; allowed: " + parameter_names(entry));
    complete.emplace(parameter.name, *parameter.default_value);
  }
  return complete;
}

Table evaluate(const Entry& entry, const ParameterMap& given, std::span<const double> abscissae) {
  const ParameterMap parameters = complete_parameters(entry, given);
  if (!entry.has_abscissa() && !abscissae.empty())
    throw std::invalid_argument("has no abscissa: one row, no list of values");
  const std::vector<double> one_row{0.0};
  const std::span<const double> own(entry.has_abscissa() ? entry.default_abscissae : one_row);
  Table table{entry.columns, {}};
  for (const double x : abscissae.empty() ? own : abscissae) {
    if (!std::isfinite(x)) throw std::invalid_argument(entry.columns.front() + " must be a finite number");
    try {
      table.rows.push_back(row(entry, parameters, x));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(error.what() + given_values(given));
    }
  }
  return table;
}

}  // namespace closed_form
