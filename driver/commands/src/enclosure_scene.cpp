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

enclosure::Sensor sensor_of(const Scene& scene, std::size_t i, double end) {
  const gas::Sensor& sensor = scene.gas->model.triggers.sensors[i];
  if (sensor.kind == gas::SensorKind::pressure) return {{}, sensor.threshold, sensor.reset};
  const auto times = gas::switching_times(scene.gas->model.triggers, i, end);
  if (!times)
    throw CaseError(
        fmt::format("sensor.{}: a sensor of contact, or set from outside, is not enclosed; allowed: sensors "
                    "of time, signal and overpressure",
                    i));
  return {*times};
}

void add_network(const Scene& scene, double end, enclosure::Scene& result) {
  const gas::TriggerModel& triggers = scene.gas->model.triggers;
  for (std::size_t i = 0; i < triggers.sensors.size(); ++i)
    result.sensors.push_back(sensor_of(scene, i, end));
  using Logic = enclosure::Gate::Logic;
  for (const gas::Gate& gate : triggers.gates)
    result.gates.push_back({gate.logic == gas::Logic::all   ? Logic::all
                            : gate.logic == gas::Logic::any ? Logic::any
                                                            : Logic::negated,
                            gate.inputs, gate.delay, gate.latch});
}

void add_inflators(const Scene& scene, enclosure::Scene& result) {
  const auto& model = scene.gas->model;
  for (std::size_t i = 0; i < model.inflows.size(); ++i) {
    const gas::Inflow& inflow = model.inflows[i];
    enclosure::Inflator inflator{inflow.mass_fractions, knots_of(inflow.mass_flow),
                                 knots_of(inflow.temperature)};
    inflator.node = inflow.trigger;
    if (inflow.start_time < std::numeric_limits<double>::infinity())
      inflator.start = inflow.start_time;
    else
      inflator.mass_flow = {{0.0, 0.0}};
    result.inflators.push_back(std::move(inflator));
  }
}

void add_holes(const Scene& scene, enclosure::Scene& result) {
  const auto& model = scene.gas->model;
  for (std::size_t j = 0; j < model.vents.size(); ++j) {
    const gas::Vent& vent = model.vents[j];
    enclosure::Hole hole{vent.discharge_coefficient, {{0.0, vent.area}}, {}, vent.backflow};
    if (vent.area_of_time) hole.area = knots_of(*vent.area_of_time);
    if (vent.area_of_overpressure) hole.area_of_overpressure = knots_of(*vent.area_of_overpressure);
    hole.node = vent.trigger;
    if (vent.backflow) result.ambient_fractions = model.ambient.mass_fractions;
    result.holes.push_back(std::move(hole));
  }
}

}  // namespace

enclosure::Scene enclosure_scene(const Scene& scene, double end) {
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
  add_network(scene, end, result);
  add_inflators(scene, result);
  add_holes(scene, result);
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
