// SPDX-License-Identifier: Apache-2.0
#include "driver/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gas/orifice.hpp"
#include "jet_peak.hpp"
#include "membrane/time_step.hpp"
#include "stages.hpp"

namespace driver {
namespace {

using std::numbers::pi;

// Seconds of an inflow's own time that the scene sees.
double duration(const Scene& scene, const gas::Inflow& inflow) {
  return std::max(0.0, scene.time.end - inflow.start_time);
}

double total_flow(const Scene& scene, double time) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.gas->model.inflows.size(); ++i)
    sum += gas::inflator_point(scene.gas->model, i, time).mass_flow;
  return sum;
}

// Piecewise linear flows: the largest sum stands at a knot of one of them.
double peak_flow(const Scene& scene) {
  double peak = 0.0;
  for (const auto& inflow : scene.gas->model.inflows) {
    if (duration(scene, inflow) <= 0.0) continue;
    for (const auto& knot : inflow.mass_flow.knots())
      if (knot.time <= duration(scene, inflow))
        peak = std::max(peak, total_flow(scene, inflow.start_time + knot.time));
  }
  return peak;
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

FullState full_state(const Scene& scene, const State& state, const Supply& supply) {
  const auto model = opened(scene.gas->model);
  const double ambient = scene.ambient.pressure, start = enclosure(scene, state).volume;
  const double leak_area = enclosure(scene, state).leak_area;
  FullState full;
  full.volume = start;  // a flat design shape has none
  if (scene.bag)
    full.volume = std::max(start, membrane::enclosed_volume(scene.bag->mesh.nodes, scene.bag->mesh.elements));
  const bool filled = supply.mass > 0.0;
  const auto& fractions = filled ? supply.mass_fractions : scene.gas->initial_fractions;
  const double temperature = filled ? supply.temperature : scene.gas->initial_temperature;
  full.gamma = model.thermo.gamma(fractions, temperature);
  full.closed_pressure = (scene.gas->initial_pressure * start + supply.work -
                          (full.gamma - 1.0) * ambient * (full.volume - start)) /
                         full.volume;  // (K.30)
  const auto at = [&](double pressure) {
    return gas::evaluate(model, gas::make_state(model, fractions, pressure, temperature, full.volume),
                         full.volume, leak_area, 0.0);
  };
  const auto out = [&](double pressure) {
    return at(pressure).vent_mass_flow + at(pressure).fabric_mass_flow;
  };
  double low = std::min(ambient, full.closed_pressure), high = std::max(full.closed_pressure, 0.0);
  if (filled && out(high) > supply.peak_flow)  // (K.31)
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (out(middle) > supply.peak_flow ? high : low) = middle;
    }
  full.pressure = high;
  full.vent_flow = at(high).vent_mass_flow;
  full.fabric_flow = at(high).fabric_mass_flow;
  return full;
}

// Share of the gas that leaves at sonic speed with at least ambient pressure in the outlet, by the midpoint
// rule.
double sonic_share(const Scene& scene, const JetPart& part) {
  const auto& inflow = scene.gas->model.inflows[part.inflator];
  constexpr int pieces = 4000;
  const double end =
      std::min(duration(scene, inflow),
               inflow.mass_flow.is_constant() ? INFINITY : inflow.mass_flow.knots().back().time);
  jet::OutletModel sonic = part.outlet;
  sonic.law = jet::OutletLaw::sonic;
  double all = 0.0, choked = 0.0;
  for (int i = 0; i < pieces && end > 0.0; ++i) {
    const auto point =
        gas::inflator_point(scene.gas->model, part.inflator, inflow.start_time + end * (i + 0.5) / pieces);
    if (!(point.mass_flow > 0.0)) continue;
    const auto outlet = jet::outlet_state(
        sonic, {point.mass_flow, point.temperature, point.cp, point.gas_constant, scene.ambient.pressure});
    all += point.mass_flow;
    if (outlet.pressure >= scene.ambient.pressure) choked += point.mass_flow;
  }
  return all > 0.0 ? choked / all : 0.0;
}

// Mean side of the surface's elements as sewn: that of equilateral triangles of the same area.
double mean_side(const Scene& scene) {
  const auto& model = scene.bag->model;
  double area = 0.0;
  for (const double a : model.reference_area) area += a;
  return std::sqrt(4.0 * area / (std::sqrt(3.0) * model.element_count));
}

// Area mean of E h / (1 - nu) over the fabric [N/m].
double fabric_stiffness(const membrane::BagModel& model) {
  double sum = 0.0, area = 0.0;
  for (std::size_t e = 0; e < model.reference_area.size(); ++e) {
    const auto& p = model.description.properties[e];
    if (p.null_panel) continue;
    const double young = p.weave ? std::sqrt(p.young * p.weave->young_weft) : p.young;
    sum += model.reference_area[e] * young * p.thickness / (1.0 - p.poisson);
    area += model.reference_area[e];
  }
  return sum / area;
}

struct Groups {
  std::vector<Group> list;
  void add_size(std::string name, const char* equation, std::string meaning, double value) {
    list.push_back({std::move(name), equation, std::move(meaning), value, true});
  }
  void add_number(std::string name, const char* equation, std::string meaning, double value) {
    list.push_back({std::move(name), equation, std::move(meaning), value, false});
  }
};

void add_gas(const Scene& scene, const State& state, const Forecast& f, Groups& groups) {
  const FullState& full = *f.full;
  const double ambient = scene.ambient.pressure, flow = f.supply.peak_flow;
  groups.add_number("full_pressure", "K.31", "pressure of the full volume over ambient",
                    full.pressure / ambient);
  if (!scene.gas->model.vents.empty())
    groups.add_number("vent_choking", "K.32", "that pressure over the one from which vents choke",
                      full.pressure / ambient * gas::critical_pressure_ratio(full.gamma));
  if (flow > 0.0 && full.vent_flow > 0.0)
    groups.add_size("vent_leak", "K.33", "outflow of the vents over the peak inflow", full.vent_flow / flow);
  if (flow > 0.0 && full.fabric_flow > 0.0)
    groups.add_size("fabric_leak", "K.33", "outflow of the fabric over the peak inflow",
                    full.fabric_flow / flow);
  if (flow > 0.0 && state.gas_point.mass > 0.0 && full.vent_flow + full.fabric_flow > 0.0)
    groups.add_number("gas_relaxation", "K.37", "relaxations of the gas in a step at the start",
                      f.step * gas::outflow_relaxation_rate(full.gamma, flow / state.gas_point.mass, 1.0));
}

void add_jet(const Scene& scene, const JetPart& part, const Forecast& f, Groups& groups) {
  const JetPeak peak = jet_peak(scene, part);
  const jet::JetModel& model = part.field.model();
  const std::string of = fmt::format("jet {}: ", part.inflator), key = fmt::format("_{}", part.inflator);
  groups.add_size("below_sonic" + key, "K.34",
                  of + "share of the gas that leaves with less than ambient outlet pressure",
                  1.0 - sonic_share(scene, part));
  if (!f.full) return;
  const double excess = f.full->pressure - scene.ambient.pressure;
  const double flux =
      (1.0 + model.restitution) * peak.outlet.density * peak.outlet.velocity * peak.outlet.velocity;
  const double bag = std::cbrt(f.full->volume);
  groups.add_size("jet_on_bag" + key, "K.35", of + "its force over that of the pressure on the bag",
                  excess > 0.0 ? flux * part.outlet.area / (excess * bag * bag) : INFINITY);
  if (!scene.pendulum) return;
  const Eigen::Vector3d impactor = scene.pendulum->model.impactor_centre(scene.pendulum->initial.angle);
  const double ratio = jet::relative_velocity(model, impactor).dot(model.axis);
  groups.add_size("jet_on_impactor" + key, "K.35",
                  of + "its force over that of the pressure on the impactor, unhidden",
                  excess > 0.0 ? flux * ratio * ratio / excess : INFINITY);
  const double distance = (impactor - model.centre).dot(model.axis);
  if (!scene.bag || !(distance > 0.0)) return;
  const double pieces =
      part.pieces ? std::sqrt(part.pieces->triangles().cols() / scene.bag->model.element_count) : 1.0;
  groups.add_size("jet_mesh" + key, "K.38", of + "(element side / its width at the impactor)^2",
                  std::pow(mean_side(scene) / pieces / (2.0 * jet::section(model, distance).width), 2));
}

void add_bag(const Scene& scene, const FullState& full, Groups& groups) {
  const double radius = std::cbrt(0.75 * full.volume / pi), stiffness = fabric_stiffness(scene.bag->model);
  groups.add_size("fabric_stretch", "K.36", "stiffness of the gas over that of the fabric, breathing sphere",
                  1.5 * full.gamma * full.pressure * radius / stiffness);
  if (scene.contact)
    groups.add_size("contact_mesh", "K.38", "(element side / diameter of the impactor)^2",
                    std::pow(mean_side(scene) / (2.0 * scene.contact->parameters().sphere_radius), 2));
}

double first_step(const Scene& scene, const State& state) {
  if (scene.time.step) return *scene.time.step;
  if (!scene.bag) return scene.moves() ? 0.0 : scene.output.history_every;
  return scene.time.safety *
         membrane::critical_time_step(membrane::stiffness_shares(
             scene.bag->model, *state.bag, state.gas_point.gamma, state.gas_point.pressure));
}

}  // namespace

Forecast forecast(const Scene& scene, const State& state) {
  Forecast f;
  f.step = first_step(scene, state);
  if (!scene.gas) return f;
  f.supply = supply_of(scene);
  Groups groups;
  if (scene.has_volume()) {
    f.full = full_state(scene, state, f.supply);
    add_gas(scene, state, f, groups);
  }
  for (const JetPart& part : scene.jets) add_jet(scene, part, f, groups);
  if (scene.bag && f.full) add_bag(scene, *f.full, groups);
  f.groups = std::move(groups.list);
  return f;
}

const char* verdict(const Group& group) {
  if (!group.is_size) return "";
  return group.value >= 0.1 ? "matters" : group.value >= 0.01 ? "shows" : "negligible";
}

}  // namespace driver
