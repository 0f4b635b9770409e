// SPDX-License-Identifier: Apache-2.0
#include "forecast/full_state.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <elementary/exponential.hpp>
#include <numbers>

#include "engine/stages.hpp"
#include "gas/orifice.hpp"

namespace driver {
namespace {

// The model with all vents open, at their largest area over time, and without inflow.
gas::ControlVolumeModel opened(gas::ControlVolumeModel model) {
  model.inflows.clear();
  for (auto& vent : model.vents) {
    vent.trigger.reset();
    if (!vent.area_of_time) continue;
    vent.area = vent.area_of_time->maximum();
    vent.area_of_time.reset();
  }
  return model;
}

// The pressure [Pa] in a volume that follows it, after `work` [J] of inflow without outflow: (K.30) with p dV
// instead of p_a dV, int p dV = p V - p0 V0 - int V dp.
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

// The openings of the full volume, with gas at the mean temperature of the inflow.
class FullOpenings {
 public:
  FullOpenings(const Scene& scene, const Supply& supply, double volume, double leak_area)
      : model_(opened(scene.gas->model)),
        fractions_(supply.mass > 0.0 ? supply.mass_fractions : scene.gas->initial_fractions),
        temperature_(supply.mass > 0.0 ? supply.temperature : scene.gas->initial_temperature),
        volume_(volume),
        leak_area_(leak_area) {
    model_.volume_of_overpressure.reset();
  }

  gas::GasPoint at(double pressure) const {
    return gas::evaluate(model_, gas::make_state(model_, fractions_, pressure, temperature_, volume_),
                         volume_, leak_area_, 0.0);
  }

  double outflow(double pressure) const {
    const gas::GasPoint point = at(pressure);
    return point.vent_mass_flow + point.fabric_mass_flow;
  }

  // Pressure [Pa] at which they let out `flow` [kg/s], at most `high`.
  double balance(double flow, double high) const {
    const auto excess = [&](double pressure) { return outflow(pressure) - flow; };
    if (!(excess(high) > 0.0)) return high;
    const boost::math::tools::eps_tolerance<double> close(48);
    std::uintmax_t iterations = 100;
    return boost::math::tools::toms748_solve(excess, model_.ambient.pressure, high, close, iterations).second;
  }

 private:
  gas::ControlVolumeModel model_;
  const std::vector<double>& fractions_;
  double temperature_, volume_, leak_area_;
};

// The faster relaxation rate [1/s] of the gas while outflow equals inflow (G.14).
double relaxation_rate(const gas::GasPoint& point, double inflow, double ambient_pressure) {
  const double out = point.vent_mass_flow + point.fabric_mass_flow, flow = std::min(out, inflow);
  if (!(flow > 0.0)) return 0.0;
  const double share = 1.0 - ambient_pressure / point.pressure;
  if (!(share > 0.0)) return flow / point.mass;
  const double of_vents = gas::orifice_pressure_exponent(point.gamma, share),
               of_fabric = gas::fabric_pressure_exponent(share);
  const double exponent = (point.vent_mass_flow * of_vents + point.fabric_mass_flow * of_fabric) / out;
  return gas::outflow_relaxation_rate(point.gamma, flow / point.mass, exponent);
}

// Number of relaxations (K.39), by the midpoint rule.
double relaxations(const Scene& scene, const FullOpenings& openings, const FullState& full) {
  constexpr int pieces = 400;
  const gas::GasPoint point = openings.at(full.pressure);
  double sum = 0.0;
  if (const double conductance = scene.gas->model.heat_loss.conductance;
      conductance > 0.0 && point.mass > 0.0)
    sum = pieces * conductance / (point.mass * (point.cp - point.gas_constant));
  for (int i = 0; i < pieces; ++i)
    if (const double flow = total_mass_flow(scene, scene.time.end * (i + 0.5) / pieces); flow > 0.0)
      sum += relaxation_rate(openings.at(openings.balance(flow, full.closed_pressure)), flow,
                             scene.ambient.pressure);
  return sum * scene.time.end / pieces;
}

// Volume as sewn. A flat design encloses nothing; it inflates to about a balloon of two discs of the same
// fabric area. The flatter a design, the closer it comes to that.
double sewn_volume(const mesh::Mesh& mesh) {
  constexpr double kBalloon =
      1.2185242;  // volume over radius^3 of the discs: Paulsen, the Mylar balloon, 1994
  const double discs =
      kBalloon * elementary::pow(mesh::panel_areas(mesh).sum() / (2.0 * std::numbers::pi), 1.5);
  const double sewn = mesh::enclosed_volume(mesh.nodes, mesh.elements);
  return std::max(sewn, discs - sewn);
}

}  // namespace

FullState full_state(const Scene& scene, const State& state, const Supply& supply) {
  const auto& model = scene.gas->model;
  const double ambient = scene.ambient.pressure;
  const auto [start, leak_area] = enclosure(scene, state);
  FullState full;
  const bool filled = supply.mass > 0.0;
  full.volume = scene.bag && filled ? std::max(start, sewn_volume(scene.bag->mesh)) : start;
  full.gamma = filled ? model.thermo.gamma(supply.mass_fractions, supply.temperature)
                      : model.thermo.gamma(scene.gas->initial_fractions, scene.gas->initial_temperature);
  full.closed_pressure = (scene.gas->initial_pressure * start + supply.work -
                          (full.gamma - 1.0) * ambient * (full.volume - start)) /
                         full.volume;  // (K.30)
  if (const auto& curve = model.volume_of_overpressure) {
    full.closed_pressure =
        closed_pressure(*curve, ambient, scene.gas->initial_pressure, full.gamma, supply.work);
    full.volume = curve->value(full.closed_pressure - ambient);
  }
  full.fills = !filled || full.closed_pressure >= ambient;
  if (!full.fills) return full;
  const FullOpenings openings(scene, supply, full.volume, leak_area);
  full.pressure =
      filled ? openings.balance(supply.peak_flow, full.closed_pressure) : full.closed_pressure;  // (K.31)
  const gas::GasPoint point = openings.at(full.pressure);
  const double out = point.vent_mass_flow + point.fabric_mass_flow;
  const double known = filled ? std::min(1.0, supply.peak_flow / out) : 1.0;  // p rounds close to p_a
  full.vent_flow = known * point.vent_mass_flow;
  full.fabric_flow = known * point.fabric_mass_flow;
  full.relaxation = relaxation_rate(point, filled ? supply.peak_flow : out, ambient);
  full.relaxations = relaxations(scene, openings, full);
  return full;
}

}  // namespace driver
