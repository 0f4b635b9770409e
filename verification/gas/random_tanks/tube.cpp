// SPDX-License-Identifier: Apache-2.0
#include "tube.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

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

/// Of time and signal: as the second route finds them.
std::vector<double> switching_times(const Tank& tank, std::size_t sensor) {
  PlainNetwork network(tank);
  std::vector<double> times;
  for (double t = 0.0; t <= tank.times.back(); t = network.next_break(t)) {
    network.update(t, 0.0);
    if (network.is_on(sensor) != (times.size() % 2 == 1)) times.push_back(t);
  }
  return times;
}

void add_network(const Tank& tank, enclosure::Scene& s) {
  for (std::size_t i = 0; i < tank.sensors.size(); ++i) {
    const SensorPlan& plan = tank.sensors[i];
    if (plan.kind == Watch::pressure)
      s.sensors.push_back({{}, plan.threshold, plan.reset});
    else
      s.sensors.push_back({switching_times(tank, i)});
  }
  using Logic = enclosure::Gate::Logic;
  for (const GatePlan& plan : tank.gates)
    s.gates.push_back({plan.logic == Join::all   ? Logic::all
                       : plan.logic == Join::any ? Logic::any
                                                 : Logic::negated,
                       plan.inputs, plan.delay, plan.latch});
}

}  // namespace

std::optional<enclosure::Scene> scene_of(const Tank& tank, const std::string& csv) {
  if (!tank.volume_of_overpressure.empty()) return {};
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
    s.inflators.back().node = p.node;
  }
  add_network(tank, s);
  for (const Hole& h : tank.holes) {
    s.holes.push_back({h.discharge_coefficient, {{0.0, h.area}}, {}, h.backflow});
    s.holes.back().node = h.node;
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

std::vector<Proved> proved(const enclosure::Tube& tube) {
  std::vector<Proved> all;
  for (const enclosure::Moment& moment : tube.moments) {
    Proved row{moment.time, {}, {}};
    for (const std::size_t i : {0U, 1U, 2U}) {
      const enclosure::Bounds& b = moment.bounds[i < 2 ? i : 3];
      row.lower[i] = b.lower;
      row.upper[i] = b.upper;
    }
    all.push_back(row);
  }
  return all;
}

double distance(const Computed& run, const std::vector<Proved>& bounds) {
  double largest = 0.0;
  for (const Proved& b : bounds) {
    const auto mine = std::ranges::find_if(run.samples, [&](const Sample& s) { return s.time == b.time; });
    if (mine == run.samples.end()) return kInfinity;
    const std::array<double, 3> values{mine->pressure, mine->temperature, mine->mass};
    for (std::size_t i = 0; i < 3; ++i)
      largest = std::max(largest, std::max({b.lower[i] - values[i], values[i] - b.upper[i], 0.0}) /
                                      std::max(b.upper[i], 1e-300));
  }
  return largest;
}

double distance_to_tube(const Tank& tank, const enclosure::Scene& scene, double width, double longest) {
  const enclosure::Tube tube =
      enclosure::enclose(scene, {.times = tank.times, .width = width, .longest = longest});
  const Computed run = libgas_route(tank);
  return run.refusal.empty() ? distance(run, proved(tube)) : std::nan("");
}

ShippedTube compute_shipped(const Tank& tank, const enclosure::Scene& scene, double longest) {
  std::vector<double> times{tank.times[tank.times.size() / 2], tank.times.back()};
  if (tank.times.size() == 2) times.erase(times.begin());
  const enclosure::Tube tube =
      enclosure::enclose(scene, {.times = times, .width = kShippedWidth, .longest = longest});
  return {tube.steps + tube.crossings, proved(tube)};
}

std::map<std::uint64_t, ShippedTube> read_shipped(const std::string& csv) {
  std::ifstream in(csv);
  std::map<std::uint64_t, ShippedTube> all;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 's') continue;
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    std::uint64_t seed = 0;
    long steps = 0;
    Proved row{};
    words >> seed >> steps >> row.time;
    for (std::size_t i = 0; i < 3; ++i) words >> row.lower[i] >> row.upper[i];
    all[seed].steps = steps;
    all[seed].bounds.push_back(row);
  }
  return all;
}

}  // namespace random_tanks
