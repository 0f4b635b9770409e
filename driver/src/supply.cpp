// SPDX-License-Identifier: Apache-2.0
#include "supply.hpp"

#include <algorithm>

#include "stages.hpp"

namespace driver {
namespace {

double total_flow(const Scene& scene, double time) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.gas->model.inflows.size(); ++i)
    sum += gas::inflator_point(scene.gas->model, i, time).mass_flow;
  return sum;
}

// Piecewise linear flows: the largest sum stands at a corner of one of them.
double peak_flow(const Scene& scene) {
  double peak = 0.0;
  for (const auto& inflow : scene.gas->model.inflows)
    for (const double time : corner_times(scene, inflow)) peak = std::max(peak, total_flow(scene, time));
  return peak;
}

// Vents as they are once open, as wide as they get with time.
gas::ControlVolumeModel opened(gas::ControlVolumeModel model) {
  for (auto& vent : model.vents) {
    vent.trigger.reset();
    if (!vent.area_of_time) continue;
    vent.area = vent.area_of_time->maximum();
    vent.area_of_time.reset();
  }
  return model;
}

// The pressure [Pa] in a volume that follows it, after `work` [J] of inflows and none out, by (K.30) with p
// dV instead of p_a dV: int p dV = p V - p0 V0 - int V dp.
double closed_pressure(const gas::Curve& volume, double ambient, double start, double gamma, double work) {
  const auto product = [&](double p) { return p * volume.value(p - ambient); };
  const auto missing = [&](double p) {
    return gamma * (product(start) - product(p)) + work +
           (gamma - 1.0) * volume.integral(start - ambient, p - ambient);
  };
  double low = start, high = start + work / volume.value(start - ambient);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (missing(middle) > 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

double duration(const Scene& scene, const gas::Inflow& inflow) {
  return std::max(0.0, scene.time.end - inflow.start_time);
}

std::vector<double> corner_times(const Scene& scene, const gas::Inflow& inflow) {
  const double length = duration(scene, inflow);
  if (!(length > 0.0)) return {};
  std::vector<double> times;
  for (const auto& knot : inflow.mass_flow.knots())
    if (knot.time >= 0.0 && knot.time < length) times.push_back(inflow.start_time + knot.time);
  times.push_back(scene.time.end);
  return times;
}

Supply supply_of(const Scene& scene) {
  const auto& model = scene.gas->model;
  Supply s{0.0, peak_flow(scene), 0.0, std::vector<double>(model.thermo.size(), 0.0), 0.0};
  double mass_by_temperature = 0.0;
  for (const auto& inflow : model.inflows) {
    const double end = duration(scene, inflow), mass = inflow.mass_flow.integral(0.0, end);
    if (!(mass > 0.0)) continue;
    const double heat = gas::product_integral(inflow.mass_flow, inflow.temperature, 0.0, end);
    s.mass += mass;
    mass_by_temperature += heat;
    s.work += model.thermo.gamma(inflow.mass_fractions, heat / mass) *
              model.thermo.gas_constant(inflow.mass_fractions) * heat;
    for (std::size_t k = 0; k < s.mass_fractions.size(); ++k)
      s.mass_fractions[k] += mass * inflow.mass_fractions[k];
  }
  for (double& y : s.mass_fractions) y = s.mass > 0.0 ? y / s.mass : 0.0;
  if (s.mass > 0.0) s.temperature = mass_by_temperature / s.mass;
  return s;
}

FullState full_state(const Scene& scene, const State& state, const Supply& supply) {
  auto model = opened(scene.gas->model);
  const double ambient = scene.ambient.pressure, start = enclosure(scene, state).volume;
  const double leak_area = enclosure(scene, state).leak_area;
  FullState full;
  const bool filled = supply.mass > 0.0;
  full.volume = start;  // a flat design shape has none
  if (scene.bag && filled)
    full.volume = std::max(start, membrane::enclosed_volume(scene.bag->mesh.nodes, scene.bag->mesh.elements));
  const auto& fractions = filled ? supply.mass_fractions : scene.gas->initial_fractions;
  const double temperature = filled ? supply.temperature : scene.gas->initial_temperature;
  full.gamma = model.thermo.gamma(fractions, temperature);
  full.closed_pressure = (scene.gas->initial_pressure * start + supply.work -
                          (full.gamma - 1.0) * ambient * (full.volume - start)) /
                         full.volume;  // (K.30)
  if (const auto curve = model.volume_of_overpressure) {
    full.closed_pressure =
        closed_pressure(*curve, ambient, scene.gas->initial_pressure, full.gamma, supply.work);
    full.volume = curve->value(full.closed_pressure - ambient);
    model.volume_of_overpressure.reset();
  }
  full.fills = !filled || full.closed_pressure >= ambient;
  if (!full.fills) return full;
  const auto at = [&](double pressure) {
    return gas::evaluate(model, gas::make_state(model, fractions, pressure, temperature, full.volume),
                         full.volume, leak_area, 0.0);
  };
  const auto out = [&](double pressure) {
    return at(pressure).vent_mass_flow + at(pressure).fabric_mass_flow;
  };
  double low = ambient, high = full.closed_pressure;
  if (filled && out(high) > supply.peak_flow)  // (K.31)
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (out(middle) > supply.peak_flow ? high : low) = middle;
    }
  full.pressure = high;
  full.vent_flow = at(high).vent_mass_flow;
  full.fabric_flow = at(high).fabric_mass_flow;
  full.mass = at(high).mass;
  return full;
}

}  // namespace driver
