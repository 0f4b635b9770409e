// SPDX-License-Identifier: Apache-2.0
#include "tube.hpp"

#include <algorithm>
#include <cmath>

#include "libgas_route.hpp"
#include "plain_gas.hpp"
#include "plain_network.hpp"

namespace random_tanks {
namespace {

enclosure::Curve curve_of(const Table& table) {
  enclosure::Curve curve;
  for (std::size_t i = 0; i < table.x.size(); ++i) curve.push_back({table.x[i], table.y[i]});
  return curve;
}

enclosure::Species species_of(const Gas& gas, const PlainSpecies& plain) {
  const double r = gas.cp == 0.0 ? plain.gas_constant : gas.gas_constant;
  enclosure::Species result{.name = gas.name, .molar_mass = 8.31446261815324 / r};
  if (gas.cp != 0.0) {
    result.low[0] = result.high[0] = gas.cp / r;
    return result;
  }
  result.constant_cp = false;
  result.minimum_temperature = plain.minimum;
  result.maximum_temperature = plain.maximum;
  for (std::size_t j = 0; j < 6; ++j) {
    result.low[j] = plain.lower[j] / r;
    result.high[j] = plain.upper[j] / r;
  }
  return result;
}

bool is_constant(const std::vector<double>& values) {
  return std::ranges::all_of(values, [&](double v) { return v == values.front(); });
}

enclosure::Curve short_curve_of(const Table& table) {
  enclosure::Curve curve = curve_of(table);
  if (is_constant(table.y)) curve.resize(1);
  return curve;
}

/// Of a node on which an inflow or a hole depends.
bool watches_pressure(const Tank& tank) {
  std::vector<bool> of_pressure;
  for (const SensorPlan& sensor : tank.sensors) of_pressure.push_back(sensor.kind == Watch::pressure);
  for (const GatePlan& gate : tank.gates)
    of_pressure.push_back(std::ranges::any_of(gate.inputs, [&](std::size_t i) { return of_pressure[i]; }));
  const auto waits = [&](const auto& part) { return part.node && of_pressure[*part.node]; };
  return std::ranges::any_of(tank.pulses, waits) || std::ranges::any_of(tank.holes, waits);
}

/// Times [s] at which a node that no pressure reaches comes on, goes off, comes on and so on.
std::vector<double> switching_times(const Tank& tank, Node node) {
  PlainNetwork network(tank);
  std::vector<double> times;
  for (double t = 0.0; t <= tank.times.back(); t = network.next_break(t)) {
    network.update(t, 0.0);
    if (network.is_on(node) != (times.size() % 2 == 1)) times.push_back(t);
  }
  return times;
}

}  // namespace

std::optional<enclosure::Scene> scene_of(const Tank& tank, const std::string& csv) {
  if (!tank.volume_of_overpressure.empty() || watches_pressure(tank)) return {};
  enclosure::Scene s;
  const std::vector<PlainSpecies> plain = read_species(tank.gases, csv);
  for (std::size_t k = 0; k < tank.gases.size(); ++k)
    s.species.push_back(species_of(tank.gases[k], plain[k]));
  s.initial_fractions = tank.start;
  s.initial_pressure = tank.pressure;
  s.initial_temperature = tank.temperature;
  s.ambient_pressure = tank.ambient_pressure;
  s.ambient_temperature = tank.ambient_temperature;
  s.ambient_fractions = tank.ambient;
  const Table volume{tank.times, tank.volumes}, leak{tank.times, tank.leak_areas};
  s.volume = short_curve_of(volume);
  if (std::ranges::any_of(tank.bulges, [](double b) { return b != 0.0; })) {
    s.volume = curve_of(volume);
    s.bulges = tank.bulges;
  }
  for (const Pulse& p : tank.pulses) {
    s.inflators.push_back({p.fractions, curve_of(p.mass_flow), curve_of(p.temperature), p.start});
    if (!p.node) continue;
    const std::vector<double> times = switching_times(tank, p.node);
    if (times.empty())
      s.inflators.back().mass_flow = {{0.0, 0.0}};
    else
      s.inflators.back().start += times.front();
  }
  for (const Hole& h : tank.holes) {
    s.holes.push_back({h.discharge_coefficient, {{0.0, h.area}}, {}, h.backflow});
    if (h.node) s.holes.back().switching = switching_times(tank, h.node);
    if (!h.area_of_time.empty()) s.holes.back().area = curve_of(h.area_of_time);
    if (!h.area_of_overpressure.empty())
      s.holes.back().area_of_overpressure = curve_of(h.area_of_overpressure);
  }
  if (!is_constant(tank.leak_areas) || tank.leak_areas.front() > 0.0) {
    s.fabrics = {{1.0, {}, short_curve_of(leak)}};
    if (!tank.fabric_velocity.empty()) s.fabrics[0].velocity = curve_of(tank.fabric_velocity);
  }
  s.wall_conductance = tank.conductance;
  s.outside_temperature = tank.outside_temperature;
  s.laminar_share = model_of(tank).laminar_share;
  return s;
}

double distance_to_tube(const Tank& tank, const enclosure::Scene& scene, double width, double longest) {
  const enclosure::Tube tube =
      enclosure::enclose(scene, {.times = tank.times, .width = width, .longest = longest});
  const Computed run = libgas_route(tank);
  if (!run.refusal.empty()) return std::nan("");
  double largest = 0.0;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const Sample& mine = run.samples[i];
    const auto far = [&](double value, std::size_t column) {
      const enclosure::Bounds& b = tube.moments[i].bounds[column];
      largest =
          std::max(largest, std::max({b.lower - value, value - b.upper, 0.0}) / std::max(b.upper, 1e-300));
    };
    far(mine.pressure, 0);
    far(mine.temperature, 1);
    far(mine.mass, 3);
  }
  return largest;
}

}  // namespace random_tanks
