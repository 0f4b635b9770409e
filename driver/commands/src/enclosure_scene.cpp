// SPDX-License-Identifier: Apache-2.0
#include "enclosure_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/case_reader.hpp"
#include "enclosure/scene.hpp"

namespace driver::commands {
namespace {

enclosure::Curve knots_of(const gas::Curve& curve) {
  enclosure::Curve result;
  for (const auto& knot : curve.knots()) result.push_back({knot.time, knot.value});
  return result;
}

enclosure::Species species_of(const gas::Species& s) {
  enclosure::Species result{.name = s.name, .molar_mass = s.molar_mass, .constant_cp = s.constant_cp};
  std::copy_n(s.low.begin(), 6, result.low.begin());
  std::copy_n(s.high.begin(), 6, result.high.begin());
  if (!s.constant_cp) {
    result.minimum_temperature = s.minimum_temperature;
    result.maximum_temperature = s.maximum_temperature;
  }
  return result;
}

/// Time at which a trigger first comes on; none: never.
std::optional<double> first_on(const gas::ControlVolumeModel& model,
                               const std::optional<std::size_t>& trigger, double end,
                               const std::string& key) {
  if (!trigger) return 0.0;
  const auto times = gas::switching_times(model.triggers, *trigger, end);
  if (!times)
    throw CaseError(
        key +
        ": depends on a sensor of pressure or contact, whose times are not enclosed; allowed: sensors of "
        "time and signal");
  return times->empty() ? std::nullopt : std::optional<double>(times->front());
}

void add_inflators(const Scene& scene, enclosure::Scene& result) {
  const auto& model = scene.gas->model;
  for (std::size_t i = 0; i < model.inflows.size(); ++i) {
    const gas::Inflow& inflow = model.inflows[i];
    const auto on = first_on(model, inflow.trigger, scene.time.end, fmt::format("inflator.{}.trigger", i));
    enclosure::Inflator inflator{inflow.mass_fractions, knots_of(inflow.mass_flow),
                                 knots_of(inflow.temperature)};
    if (on && inflow.start_time < std::numeric_limits<double>::infinity())
      inflator.start = *on + inflow.start_time;
    else
      inflator.mass_flow = {{0.0, 0.0}};
    result.inflators.push_back(std::move(inflator));
  }
}

void add_holes(const gas::ControlVolumeModel& model, enclosure::Scene& result) {
  for (std::size_t j = 0; j < model.vents.size(); ++j) {
    const gas::Vent& vent = model.vents[j];
    if (vent.trigger)
      throw CaseError(
          fmt::format("vent.{}.trigger: vents that open by a trigger are not enclosed; give their area over "
                      "time",
                      j));
    enclosure::Hole hole{vent.discharge_coefficient, {{0.0, vent.area}}, {}, vent.backflow};
    if (vent.area_of_time) hole.area = knots_of(*vent.area_of_time);
    if (vent.area_of_overpressure) hole.area_of_overpressure = knots_of(*vent.area_of_overpressure);
    if (vent.backflow) result.ambient_fractions = model.ambient.mass_fractions;
    result.holes.push_back(std::move(hole));
  }
}

}  // namespace

enclosure::Scene enclosure_scene(const Scene& scene) {
  if (!scene.has_volume() || scene.bag)
    throw CaseError(fmt::format("{}: has {}; only tanks are enclosed", scene.case_file.string(),
                                scene.bag ? "a bag" : "no volume of gas"));
  const GasPart& gas = *scene.gas;
  const gas::ControlVolumeModel& model = gas.model;
  if (model.volume_of_overpressure)
    throw CaseError("tank.volume: a volume that follows the pressure is not enclosed");
  enclosure::Scene result;
  for (std::size_t k = 0; k < model.thermo.size(); ++k)
    result.species.push_back(species_of(model.thermo.species(k)));
  result.initial_fractions = gas.initial_fractions;
  result.initial_pressure = gas.initial_pressure;
  result.initial_temperature = gas.initial_temperature;
  result.ambient_pressure = model.ambient.pressure;
  result.ambient_temperature = model.ambient.temperature;
  result.volume = {{0.0, *gas.rigid_volume}};
  if (gas.tank_volume && gas.tank_volume->table)
    result.volume = knots_of(*gas.tank_volume->table);
  else if (const auto& wave = gas.tank_volume)
    result.wave = enclosure::Wave{wave->mean, wave->amplitude, wave->frequency, wave->phase};
  add_inflators(scene, result);
  add_holes(model, result);
  if (gas.tank_leak_area > 0.0 && model.fabrics.empty()) result.fabrics.push_back({gas.tank_leak_area});
  if (gas.tank_leak_area > 0.0)
    for (const gas::Fabric& fabric : model.fabrics) {
      result.fabrics.push_back({fabric.share * gas.tank_leak_area});
      if (fabric.velocity) result.fabrics.back().velocity = knots_of(*fabric.velocity);
    }
  result.wall_conductance = model.heat_loss.conductance;
  result.outside_temperature = model.heat_loss.outside_temperature;
  result.laminar_share = model.laminar_share;
  return result;
}

}  // namespace driver::commands
