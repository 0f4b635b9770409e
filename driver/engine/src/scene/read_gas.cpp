// SPDX-License-Identifier: Apache-2.0
// [gas], [[inflator]] -> GasPart.
#include "scene/read_gas.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/species.hpp"
#include "scene/gas_curve.hpp"
#include "scene/plausibility.hpp"
#include "scene/read_openings.hpp"
#include "scene/read_triggers.hpp"

namespace driver {
namespace {

using Composition = std::map<std::string, double>;
enum class By { mass, mole };

struct NamedComposition {
  Composition fractions;
  By by = By::mass;
};

NamedComposition read_composition(TableReader& table) {
  NamedComposition composition;
  composition.fractions = table.at("composition").composition();
  composition.by = table.at("composition_by").choice<By>({{"mass", By::mass}, {"mole", By::mole}}, "mass");
  return composition;
}

// The species of the scene, in the order in which the case names them; "air" stands for its four.
class SpeciesList {
 public:
  explicit SpeciesList(SpeciesCatalogue catalogue) : catalogue_(std::move(catalogue)) {}

  void add(const std::string& name) {
    if (name == "air") {
      for (const auto& part : gas::air_by_mole()) add(part.species);
    } else if (std::ranges::find(species_, name, &gas::Species::name) == species_.end()) {
      species_.push_back(catalogue_.named(name));
    }
  }
  const std::vector<gas::Species>& species() const { return species_; }

 private:
  SpeciesCatalogue catalogue_;
  std::vector<gas::Species> species_;
};

SpeciesList read_species(TableReader& table) {
  const auto law =
      table.at("thermodynamics")
          .choice<Thermodynamics>(
              {{"constant", Thermodynamics::constant_cp}, {"nasa7", Thermodynamics::nasa7}}, "constant");
  double reference = gas::kReferenceTemperature;
  if (law == Thermodynamics::constant_cp)
    reference =
        table.at("reference_temperature").number(Bounds{200.0, 6000.0, false, "200 to 6000", "K"}, reference);
  SpeciesCatalogue catalogue(law, reference);
  catalogue.read(table);
  return SpeciesList(std::move(catalogue));
}

std::vector<double> mass_fractions(const gas::Thermo& thermo, const NamedComposition& composition) {
  std::vector<gas::Component> parts;
  const auto add = [&](const std::string& species, double fraction) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.species == species; });
    if (found == parts.end())
      parts.push_back({species, fraction});
    else
      found->fraction += fraction;
  };
  for (const auto& [name, fraction] : composition.fractions) {
    if (name != "air") {
      add(name, fraction);
    } else if (composition.by == By::mole) {
      for (const auto& part : gas::air_by_mole()) add(part.species, fraction * part.fraction);
    } else {
      const auto air = thermo.mass_fractions_by_mole(gas::air_by_mole());
      for (std::size_t k = 0; k < thermo.size(); ++k)
        if (air[k] > 0.0) add(thermo.species(k).name, fraction * air[k]);
    }
  }
  return composition.by == By::mole ? thermo.mass_fractions_by_mole(parts)
                                    : thermo.mass_fractions_by_mass(parts);
}

void add_species(TableReader& reader, const NamedComposition& composition, SpeciesList& list) {
  reader.located("composition", [&] {
    for (const auto& entry : composition.fractions) list.add(entry.first);
  });
}

/// Of each sensor alone what the gas refuses: a reset too near to the threshold.
void require_sensors(TableReader& root, const gas::ControlVolumeModel& model) {
  gas::ControlVolumeModel alone{model.thermo, model.ambient, {}, {}};
  auto sensor = model.triggers.sensors.begin();
  for (auto& table : root.tables("sensor")) {
    alone.triggers.sensors.assign(1, *sensor++);
    table.located("reset", [&] { gas::validate(alone); });
  }
}

/// Composition of the gas outside; asked for only where a vent lets it in.
std::optional<NamedComposition> read_ambient_composition(TableReader& root,
                                                         std::optional<TableReader>& ambient) {
  bool named = false;
  for (const auto& vent : root.tables("vent")) named = named || vent.has("backflow");
  for (const char* key : {"composition", "composition_by"})
    if (!named && ambient && ambient->has(key)) ambient->fail(key, "has no effect: no [[vent]] has backflow");
  if (!named) return {};
  if (ambient && ambient->has("composition")) return read_composition(*ambient);
  return NamedComposition{{{"air", 1.0}}, By::mole};
}

gas::Inflow read_inflow(TableReader& reader, std::vector<double> fractions, TriggerNames& names) {
  std::optional<gas::Curve> mass_flow, temperature;
  reader.located("mass_flow", [&] {
    mass_flow =
        to_gas_curve(CurveReader(reader, "mass_flow").curve_or_integral(non_negative.in("kg/s"), "kg"),
                     gas::Outside::zero);
  });
  reader.located("temperature", [&] {
    temperature = to_gas_curve(CurveReader(reader, "temperature").curve(gas_temperature), gas::Outside::held);
  });
  const double start = reader.at("start_time").number(non_negative.in("s"), 0.0);
  return {std::move(fractions), *mass_flow, *temperature, start, names.optional_node(reader)};
}

void warn_of_idle_inflators(Scene& scene) {
  const auto& inflows = scene.gas->model.inflows;
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    const double length = scene.time.end - inflows[i].start_time;
    if (!(length > 0.0 && inflows[i].mass_flow.integral(0.0, length) > 0.0))
      scene.warnings.push_back(fmt::format("inflator.{} delivers nothing before end_time", i));
  }
}

void read_initial(TableReader& initial, const NamedComposition& composition, Scene& scene) {
  GasPart& part = *scene.gas;
  initial.located("composition",
                  [&] { part.initial_fractions = mass_fractions(part.model.thermo, composition); });
  part.initial_pressure =
      initial.at("pressure").number(non_negative.in("Pa"), scene.ambient.pressure, "ambient");
  part.initial_temperature =
      initial.at("temperature").number(gas_temperature, scene.ambient.temperature, "ambient");
  initial.finish();
}

/// What needs a gas and has none.
void refuse_without_gas(TableReader& root) {
  for (const char* key : {"tank", "inflator", "vent", "sensor", "trigger"})
    if (root.has(key)) root.fail(key, "needs a table [gas]");
}

}  // namespace

void read_gas(TableReader& root, std::optional<TableReader>& ambient, std::vector<TableReader>& inflators,
              Scene& scene) {
  auto table = root.optional_table("gas");
  if (!table) return refuse_without_gas(root);
  SpeciesList list = read_species(*table);
  std::optional<TableReader> initial;
  NamedComposition initial_composition;
  if (root.has("tank") || root.has("membrane")) {
    initial = table->table("initial");
    initial_composition = read_composition(*initial);
    add_species(*initial, initial_composition, list);
  } else if (table->has("initial")) {
    table->fail("initial", "the scene has no volume of gas, [tank] or [membrane]");
  }
  std::vector<NamedComposition> compositions;
  for (auto& inflator : inflators) {
    compositions.push_back(read_composition(inflator));
    add_species(inflator, compositions.back(), list);
  }
  if (!initial && compositions.empty())
    table->fail("", "has no gas: add an [[inflator]], or a volume, [tank] or [membrane]");
  const auto outside = read_ambient_composition(root, ambient);
  if (outside) add_species(ambient ? *ambient : root, *outside, list);

  gas::ControlVolumeModel model{gas::Thermo(list.species()), scene.ambient, {}, {}};
  if (outside) model.ambient.mass_fractions = mass_fractions(model.thermo, *outside);
  scene.gas.emplace(GasPart{std::move(model), {}, {}});
  GasPart& part = *scene.gas;
  if (initial) read_initial(*initial, initial_composition, scene);
  read_heat_loss(*table, scene);
  table->finish();

  TriggerNames names = read_triggers(root, part);
  require_sensors(root, part.model);
  gas::ControlVolumeModel alone = part.model;  // with one inflator: what is wrong is of that one
  auto& inflows = part.model.inflows;
  for (std::size_t i = 0; i < inflators.size(); ++i) {
    inflows.push_back(read_inflow(inflators[i], mass_fractions(part.model.thermo, compositions[i]), names));
    alone.inflows.assign(1, inflows.back());
    inflators[i].located("temperature", [&] { gas::validate(alone); });
  }
  warn_of_idle_inflators(scene);
  read_vents(root, names, part.model);
  names.warn_of_idle(scene);
  read_tank(root, scene);
  table->located("", [&] { gas::validate(part.model); });
  if (!initial) return;
  table->located("initial", [&] {
    gas::make_state(part.model.thermo, part.initial_fractions, part.initial_pressure,
                    part.initial_temperature, part.rigid_volume.value_or(1.0));
  });
  warn_of_range(scene);
}

}  // namespace driver
