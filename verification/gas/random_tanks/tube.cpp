// SPDX-License-Identifier: Apache-2.0
#include "tube.hpp"

#include <algorithm>
#include <cmath>

#include "libgas_route.hpp"
#include "plain_gas.hpp"

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

}  // namespace

std::optional<enclosure::Scene> scene_of(const Tank& tank, const std::string& csv) {
  const auto acts = [](const auto& part) { return part.node.has_value(); };
  if (std::ranges::any_of(tank.pulses, acts) || std::ranges::any_of(tank.holes, acts) ||
      !tank.volume_of_overpressure.empty() || !is_constant(tank.leak_areas) ||
      std::ranges::any_of(tank.bulges, [](double b) { return b != 0.0; }))
    return {};
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
  for (std::size_t i = 0; i < tank.times.size(); ++i) s.volume.push_back({tank.times[i], tank.volumes[i]});
  if (is_constant(tank.volumes)) s.volume.resize(1);
  for (const Pulse& p : tank.pulses)
    s.inflators.push_back({p.fractions, curve_of(p.mass_flow), curve_of(p.temperature), p.start});
  for (const Hole& h : tank.holes) {
    s.holes.push_back({h.discharge_coefficient, {{0.0, h.area}}, {}, h.backflow});
    if (!h.area_of_time.empty()) s.holes.back().area = curve_of(h.area_of_time);
    if (!h.area_of_overpressure.empty())
      s.holes.back().area_of_overpressure = curve_of(h.area_of_overpressure);
  }
  if (tank.leak_areas.front() > 0.0) {
    s.fabrics = {{tank.leak_areas.front()}};
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
