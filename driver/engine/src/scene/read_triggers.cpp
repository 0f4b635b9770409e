// SPDX-License-Identifier: Apache-2.0
// [[sensor]] and [[trigger]] -> the nodes of gas::TriggerModel, by name.
#include "scene/read_triggers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "scene/gas_curve.hpp"

namespace driver {
namespace {

gas::Sensor read_signal(TableReader& table) {
  std::optional<gas::Curve> signal;
  const double above = table.at("above").number(any_number);
  table.located("signal", [&] {
    signal = to_gas_curve(CurveReader(table, "signal").curve(any_number), gas::Outside::held);
  });
  return {gas::SensorKind::signal, above, {}, signal};
}

gas::Sensor read_pressure(TableReader& table) {
  const double threshold = table.at("overpressure").number(any_number.in("Pa"));
  const auto reset = table.at("reset").optional_number(any_number.in("Pa"));
  if (reset && !(*reset < threshold))
    table.fail("reset", fmt::format("is {}, allowed: less than overpressure, {}", *reset, threshold));
  return {gas::SensorKind::pressure, threshold, reset, {}};
}

// Of the kinds one is given; an unknown key is told first, for it may be meant as one.
void require_one(const TableReader& table, const std::vector<std::string>& kinds,
                 const std::set<std::string>& others) {
  const auto given = std::count_if(kinds.begin(), kinds.end(), [&](const auto& k) { return table.has(k); });
  if (given == 1) return;
  std::set<std::string> allowed = others;
  allowed.insert(kinds.begin(), kinds.end());
  table.allow_only(allowed);
  table.fail("", fmt::format("has {} of {}, exactly one is needed", given, fmt::join(kinds, ", ")));
}

gas::Sensor read_sensor(TableReader& table) {
  require_one(table, {"time", "signal", "overpressure", "contact", "external"}, {"name", "above", "reset"});
  if (table.has("signal")) return read_signal(table);
  if (table.has("overpressure")) return read_pressure(table);
  if (table.has("time"))
    return {gas::SensorKind::time, table.at("time").number(non_negative.in("s")), {}, {}};
  if (table.has("contact") && !table.at("contact").flag(true))
    table.fail("contact", "is false, allowed: true");
  if (table.has("external") && !table.at("external").flag(true))
    table.fail("external", "is false, allowed: true");
  return {gas::SensorKind::input, 0.0, {}, {}};
}

gas::Gate read_gate(TableReader& table, const TriggerNames& names) {
  require_one(table, {"all", "any", "not"}, {"name", "delay", "latch"});
  gas::Gate gate{gas::Logic::negated, {}};
  const auto add = [&](const std::string& key, gas::Logic logic, const std::vector<std::string>& inputs) {
    gate.logic = logic;
    for (const auto& name : inputs) gate.inputs.push_back(names.node(table, key, name));
    if (inputs.empty()) table.fail(key, "is empty, needed: names of sensors and triggers");
  };
  if (table.has("not"))
    add("not", gas::Logic::negated, {table.at("not").text()});
  else if (table.has("all"))
    add("all", gas::Logic::all, table.at("all").texts(""));
  else
    add("any", gas::Logic::any, table.at("any").texts(""));
  gate.delay = table.at("delay").number(non_negative.in("s"), 0.0);
  gate.latch = table.at("latch").flag(false);
  return gate;
}

}  // namespace

std::size_t TriggerNames::node(const TableReader& table, const std::string& key,
                               const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (names_.empty())
    table.fail(key, fmt::format("is \"{}\", allowed: the name of a [[sensor]], but the case has none", name));
  if (found == names_.end())
    table.fail(key, fmt::format("is \"{}\", allowed: a [[sensor]] or an earlier [[trigger]], \"{}\"", name,
                                fmt::join(names_, "\", \"")));
  return static_cast<std::size_t>(found - names_.begin());
}

void TriggerNames::add(TableReader& table) {
  const std::string name = table.at("name").text();
  if (name.empty()) table.fail("name", "is empty, needed: a name");
  if (std::find(names_.begin(), names_.end(), name) != names_.end())
    table.fail("name", fmt::format("names \"{}\" a second time", name));
  names_.push_back(name);
}

std::optional<std::size_t> TriggerNames::optional_node(TableReader& table) {
  if (!table.has("trigger")) return {};
  const std::size_t found = node(table, "trigger", table.at("trigger").text());
  used_.insert(found);
  return found;
}

TriggerNames read_triggers(TableReader& root, GasPart& part) {
  TriggerNames names;
  gas::TriggerModel& model = part.model.triggers;
  for (auto& table : root.tables("sensor")) {
    names.add(table);
    part.sensor_names.push_back(table.at("name").text());
    if (table.has("contact")) part.contact_sensors.push_back(model.sensors.size());
    model.sensors.push_back(read_sensor(table));
    table.finish();
  }
  for (auto& table : root.tables("trigger")) {
    gas::Gate gate = read_gate(table, names);
    names.add(table);
    names.use(gate.inputs);
    model.gates.push_back(std::move(gate));
    table.finish();
  }
  return names;
}

void TriggerNames::warn_of_idle(Scene& scene) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (!used_.contains(i))
      scene.warnings.push_back(fmt::format("sensor or trigger \"{}\" has no effect", names_[i]));
}

}  // namespace driver
