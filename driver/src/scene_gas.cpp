// SPDX-License-Identifier: Apache-2.0
// [gas], [tank], [[inflator]] and [[vent]] -> GasPart.
#include <fmt/format.h>

#include <algorithm>

#include "scene_parts.hpp"

namespace driver {
namespace {

using Composition = std::map<std::string, double>;
enum class By { mass, mole };
enum class Thermodynamics { constant_cp, nasa7 };

struct NamedComposition {
  Composition fractions;
  By by = By::mass;
};

NamedComposition read_composition(TableReader& table) {
  NamedComposition composition;
  composition.fractions = table.composition("composition");
  composition.by = table.choice<By>("composition_by", {{"mass", By::mass}, {"mole", By::mole}}, "mass");
  return composition;
}

// The species of the scene, in the order in which the case names them; "air" stands for its four.
class SpeciesList {
 public:
  SpeciesList(Thermodynamics law, double reference_temperature)
      : law_(law), reference_(reference_temperature) {}

  void add_own(gas::Species species) {
    if (is_own(species.name)) throw std::invalid_argument("names \"" + species.name + "\" a second time");
    own_.push_back(std::move(species));
  }

  void add(const std::string& name) {
    if (name == "air" && !is_own(name)) {
      for (const auto& part : gas::air_by_mole()) add(part.species);
      return;
    }
    const auto same = [&](const gas::Species& s) { return s.name == name; };
    if (std::any_of(species_.begin(), species_.end(), same)) return;
    if (const auto own = std::find_if(own_.begin(), own_.end(), same); own != own_.end())
      species_.push_back(*own);
    else
      species_.push_back(law_ == Thermodynamics::nasa7 ? gas::nasa7_species(name)
                                                       : gas::constant_cp_species(name, reference_));
  }

  bool is_own(const std::string& name) const {
    return std::any_of(own_.begin(), own_.end(), [&](const gas::Species& s) { return s.name == name; });
  }
  const std::vector<gas::Species>& species() const { return species_; }

 private:
  Thermodynamics law_;
  double reference_;
  std::vector<gas::Species> own_;
  std::vector<gas::Species> species_;
};

SpeciesList read_species(TableReader& table) {
  const auto law = table.choice<Thermodynamics>(
      "thermodynamics", {{"constant", Thermodynamics::constant_cp}, {"nasa7", Thermodynamics::nasa7}},
      "constant");
  double reference = gas::kReferenceTemperature;
  if (law == Thermodynamics::constant_cp)
    reference =
        table.number("reference_temperature", Bounds{200.0, 6000.0, false, "200 to 6000 K"}, reference);
  SpeciesList list(law, reference);
  for (auto& own : table.tables("species")) {
    own.located("", [&] {
      list.add_own(gas::constant_cp_species(own.text("name"), own.number("gas_constant", positive),
                                            own.number("cp", positive)));
    });
    own.finish();
  }
  return list;
}

std::vector<double> mass_fractions(const gas::Thermo& thermo, const SpeciesList& list,
                                   const NamedComposition& composition) {
  const bool air_is_mixture = !list.is_own("air");
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
    if (name != "air" || !air_is_mixture) {
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

void read_vents(TableReader& root, std::vector<gas::Vent>& vents) {
  for (auto& table : root.tables("vent")) {
    vents.push_back(
        {table.number("discharge_coefficient", positive_fraction, 1.0), table.number("area", positive)});
    table.finish();
  }
}

// What fills the volume at the start.
void read_initial(TableReader& table, const SpeciesList& list, const NamedComposition& composition,
                  const gas::Ambient& ambient, GasPart& part) {
  table.located("composition",
                [&] { part.initial_fractions = mass_fractions(part.model.thermo, list, composition); });
  part.initial_pressure = table.number("pressure", non_negative, ambient.pressure);
  part.initial_temperature = table.number("temperature", positive, ambient.temperature);
  table.finish();
}

void read_inflow(TableReader& table, const SpeciesList& list, const NamedComposition& composition,
                 GasPart& part) {
  std::optional<gas::Curve> mass_flow, temperature;
  table.located("mass_flow", [&] {
    mass_flow = to_gas_curve(table.curve("mass_flow", non_negative), gas::Outside::kZero);
  });
  table.located("temperature", [&] {
    temperature = to_gas_curve(table.curve("temperature", positive), gas::Outside::kHeld);
  });
  const double start = table.number("start_time", non_negative, 0.0);
  table.located("temperature", [&] {
    part.model.inflows.push_back(
        {mass_fractions(part.model.thermo, list, composition), *mass_flow, *temperature, start});
    gas::validate(part.model);
  });
}

void warn_if_idle(Scene& scene) {
  for (std::size_t i = 0; i < scene.gas->model.inflows.size(); ++i) {
    const auto& inflow = scene.gas->model.inflows[i];
    const double length = scene.time.end - inflow.start_time;
    if (!(length > 0.0 && inflow.mass_flow.integral(0.0, length) > 0.0))
      scene.warnings.push_back(fmt::format("inflator.{} delivers nothing before end_time", i));
  }
}

}  // namespace

gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside) {
  if (outside == gas::Outside::kZero && !data.time.empty() && data.time.front() < 0.0)
    throw std::invalid_argument(fmt::format(
        "its first knot is at {} s: time counts from firing, 0 or more is allowed", data.time.front()));
  if (data.time.empty()) return gas::Curve::constant(data.value.front());
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < data.time.size(); ++i) knots.push_back({data.time[i], data.value[i]});
  return {std::move(knots), outside};
}

void read_gas(TableReader& root, std::vector<TableReader>& inflators, Scene& scene) {
  auto table = root.optional_table("gas");
  if (!table) {
    for (const char* key : {"tank", "inflator", "vent"})
      if (root.has(key)) root.fail(key, "needs a table [gas]");
    return;
  }
  SpeciesList list = read_species(*table);
  const auto composition_of = [&](TableReader& reader) {
    NamedComposition composition = read_composition(reader);
    reader.located("composition", [&] {
      for (const auto& entry : composition.fractions) list.add(entry.first);
    });
    return composition;
  };
  std::optional<TableReader> initial;
  NamedComposition initial_composition;
  if (root.has("tank") || root.has("membrane")) {
    initial = table->table("initial");
    initial_composition = composition_of(*initial);
  } else if (table->has("initial")) {
    table->fail("initial", "the scene has no volume, [tank] or [membrane], that gas fills at the start");
  }
  std::vector<NamedComposition> compositions;
  for (auto& inflator : inflators) compositions.push_back(composition_of(inflator));

  scene.gas.emplace(GasPart{{gas::Thermo(list.species()), scene.ambient, {}, {}}, {}, {}, 0.0, 0.0, {}});
  GasPart& part = *scene.gas;
  if (initial) read_initial(*initial, list, initial_composition, scene.ambient, part);
  table->finish();
  for (std::size_t i = 0; i < inflators.size(); ++i) read_inflow(inflators[i], list, compositions[i], part);
  warn_if_idle(scene);
  read_vents(root, part.model.vents);
  if (auto tank = root.optional_table("tank")) {
    part.rigid_volume = tank->number("volume", positive);
    tank->finish();
  }
  table->located("", [&] { gas::validate(part.model); });
  if (!initial) return;
  table->located("initial", [&] {
    gas::make_state(part.model.thermo, part.initial_fractions, part.initial_pressure,
                    part.initial_temperature, part.rigid_volume.value_or(1.0));
  });
}

}  // namespace driver
